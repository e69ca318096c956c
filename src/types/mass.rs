//! `ab_mass`: three float8 (occupied, empty, unknown), native byte order on disk, network order on the wire.

use asbuilt_core::evidence::{Hypothesis, Mass};
use asbuilt_core::{Error, Result};

use crate::pg::{Args, SqlValue, sql_functions};

/// The stored form.
pub fn mass_bytes(m: &Mass) -> Vec<u8> {
    [m.occupied, m.empty, m.unknown].iter().flat_map(|c| (c + 0.0).to_ne_bytes()).collect()
}

/// The mass in argument `i`.
pub fn mass_arg(args: &Args, i: usize) -> Mass {
    let [occupied, empty, unknown] = args.numbers(i);
    Mass { occupied, empty, unknown }
}

/// Returns a mass.
pub fn mass_ret(m: &Mass) -> Result<SqlValue> {
    Ok(SqlValue::Fixed(mass_bytes(m)))
}

fn received(bytes: &[u8]) -> Result<Mass> {
    let all: &[u8; 24] = bytes.try_into().map_err(|_| Error::binary("ab_mass", "24 bytes expected"))?;
    let at = |i: usize| f64::from_be_bytes(std::array::from_fn(|k| all[8 * i + k]));
    Mass::from_parts(at(0), at(1), at(2)).map_err(|e| Error::binary("ab_mass", e.to_string()))
}

sql_functions! {
    fn ab_mass_in(args) { mass_ret(&Mass::from_text(&args.cstring(0))?) }

    fn ab_mass_out(args) { Ok(SqlValue::CString(mass_arg(args, 0).to_text())) }

    fn ab_mass_recv(args) { mass_ret(&received(args.message(0))?) }

    fn ab_mass_send(args) {
        let m = mass_arg(args, 0);
        Ok(SqlValue::Bytes([m.occupied, m.empty, m.unknown].iter().flat_map(|c| c.to_be_bytes()).collect()))
    }

    fn ab_mass_make(args) { mass_ret(&Mass::new(args.f64(0), args.f64(1))?) }

    fn ab_mass_belief(args) { Ok(SqlValue::F64(mass_arg(args, 0).belief(Hypothesis::parse(&args.text(1))?))) }

    fn ab_mass_plausibility(args) { Ok(SqlValue::F64(mass_arg(args, 0).plausibility(Hypothesis::parse(&args.text(1))?))) }

    fn ab_mass_combine(args) { mass_ret(&mass_arg(args, 0).combine(&mass_arg(args, 1))?) }

    fn ab_mass_conflict(args) { Ok(SqlValue::F64(mass_arg(args, 0).conflict(&mass_arg(args, 1)))) }

    fn ab_mass_equal(args) { Ok(SqlValue::Bool(mass_arg(args, 0) == mass_arg(args, 1))) }
}
