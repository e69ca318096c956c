//! `ab_mass`: three float8 (occupied, empty, unknown), native byte order on disk, network order on the wire.

use asbuilt_core::evidence::{Hypothesis, Mass, RayModel};
use asbuilt_core::{Error, Result};

use crate::pg::{Args, Ret, sql_functions};

/// The stored form.
pub fn mass_bytes(m: &Mass) -> Vec<u8> {
    [m.occupied, m.empty, m.unknown].iter().flat_map(|c| c.to_ne_bytes()).collect()
}

fn arg(args: &Args, i: usize) -> Mass {
    let bytes: [u8; 24] = args.fixed(i);
    let at = |i: usize| f64::from_ne_bytes(std::array::from_fn(|k| bytes[8 * i + k]));
    Mass { occupied: at(0), empty: at(1), unknown: at(2) }
}

fn ret(m: &Mass) -> Result<Ret> {
    Ok(Ret::Fixed(mass_bytes(m)))
}

fn received(bytes: &[u8]) -> Result<Mass> {
    let all: &[u8; 24] = bytes.try_into().map_err(|_| Error::binary("ab_mass", "24 bytes expected"))?;
    let at = |i: usize| f64::from_be_bytes(std::array::from_fn(|k| all[8 * i + k]));
    Mass::from_parts(at(0), at(1), at(2)).map_err(|e| Error::binary("ab_mass", e.to_string()))
}

sql_functions! {
    fn ab_mass_in(args) { ret(&Mass::from_text(&args.cstring(0))?) }

    fn ab_mass_out(args) { Ok(Ret::CString(arg(args, 0).to_text())) }

    fn ab_mass_recv(args) { ret(&received(args.message(0))?) }

    fn ab_mass_send(args) {
        let m = arg(args, 0);
        Ok(Ret::Bytes([m.occupied, m.empty, m.unknown].iter().flat_map(|c| c.to_be_bytes()).collect()))
    }

    fn ab_mass_make(args) { ret(&Mass::new(args.f64(0), args.f64(1))?) }

    fn ab_mass_belief(args) { Ok(Ret::F64(arg(args, 0).belief(Hypothesis::parse(&args.text(1))?))) }

    fn ab_mass_plausibility(args) { Ok(Ret::F64(arg(args, 0).plausibility(Hypothesis::parse(&args.text(1))?))) }

    fn ab_mass_combine(args) { ret(&arg(args, 0).combine(&arg(args, 1))?) }

    fn ab_mass_conflict(args) { Ok(Ret::F64(arg(args, 0).conflict(&arg(args, 1)))) }

    fn ab_mass_equal(args) { Ok(Ret::Bool(arg(args, 0) == arg(args, 1))) }

    /// ab_ray_mass(origin, point, query, kappa, lambda, c): the published ray model at one point.
    fn ab_ray_mass(args) {
        let place = |i, what| args.vector::<3>(i, what).map(Into::into);
        let (origin, point, query) = (place(0, "the origin")?, place(1, "the point")?, place(2, "the query point")?);
        let rays = RayModel::new(args.f64(3), args.f64(4), args.f64(5))?;
        let m = rays.mass(&origin, &point, &query);
        if m.occupied.is_nan() {
            return Err(Error::argument("a coordinate", "finite", "NaN"));
        }
        ret(&m)
    }
}
