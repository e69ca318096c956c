//! `ab_mass`: three float8 (occupied, empty, unknown), native byte order on disk, network order on the wire.

use asbuilt_core::evidence::{Hypothesis, Mass};
use asbuilt_core::{Error, Result};

use crate::pg::{Message, SqlValue, TextInput, sql_functions};

/// The stored form.
pub fn mass_bytes(m: &Mass) -> Vec<u8> {
    [m.occupied, m.empty, m.unknown].iter().flat_map(|c| (c + 0.0).to_ne_bytes()).collect()
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
    fn ab_mass_in(text: TextInput) { mass_ret(&Mass::from_text(&text.text())?) }

    fn ab_mass_out(mass: Mass) { Ok(SqlValue::CString(mass.to_text())) }

    fn ab_mass_recv(message: Message) { mass_ret(&received(message.rest())?) }

    fn ab_mass_send(mass: Mass) {
        Ok(SqlValue::Bytes([mass.occupied, mass.empty, mass.unknown].iter().flat_map(|c| c.to_be_bytes()).collect()))
    }

    fn ab_mass_make(occupied: f64, empty: f64) { mass_ret(&Mass::new(occupied, empty)?) }

    fn ab_mass_belief(mass: Mass, hypothesis: String) {
        Ok(SqlValue::F64(mass.belief(Hypothesis::parse(&hypothesis)?)))
    }

    fn ab_mass_plausibility(mass: Mass, hypothesis: String) {
        Ok(SqlValue::F64(mass.plausibility(Hypothesis::parse(&hypothesis)?)))
    }

    fn ab_mass_combine(m1: Mass, m2: Mass) { mass_ret(&m1.combine(&m2)?) }

    fn ab_mass_conflict(m1: Mass, m2: Mass) { Ok(SqlValue::F64(m1.conflict(&m2))) }

    fn ab_mass_equal(a: Mass, b: Mass) { Ok(SqlValue::Bool(a == b)) }
}
