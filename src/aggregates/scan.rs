//! `ab_scan_agg`: patches from rows of returns.

use asbuilt_core::Result;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Gathered, Return};

use crate::pg::{AggState, Args, Ret, aggregate_state, deserialised_state, interrupt, sql_functions};
use crate::types::planes::{one_colour, one_intensity};

fn state(args: &Args, i: usize) -> Result<AggState<Gathered>> {
    aggregate_state(args, i, || Ok(Gathered::default()))
}

/// The row (x, y, z [, origin [, station [, intensity [, colour]]]]) behind the state, and its station.
fn row(args: &Args) -> Result<(i64, Return)> {
    let has = |i: usize| args.len() > i;
    let origin = has(4).then(|| args.vector::<3>(4, "the origin")).transpose()?;
    let intensity = has(6).then(|| one_intensity(args.i32(6))).transpose()?;
    let colour = has(7).then(|| args.i32_vector::<3>(7, "the colour").and_then(one_colour)).transpose()?;
    let point = Vec3::new(args.f64(1), args.f64(2), args.f64(3));
    let station = if has(5) { args.i64(5) } else { 0 };
    Ok((station, Return { point, origin: origin.map(Vec3::from), intensity, colour }))
}

sql_functions! {
    /// transition: a row with a NULL adds nothing.
    fn ab_scan_accum(args) {
        let mut state = state(args, 0)?;
        if !(1..args.len()).any(|i| args.is_null(i)) {
            let (station, row) = row(args)?;
            state.get().push(station, &row)?;
        }
        Ok(state.ret())
    }

    fn ab_scan_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1) {
            left.get().merge(state(args, 1)?.get())?;
        }
        Ok(left.ret())
    }

    fn ab_scan_serial(args) { Ok(Ret::Bytes(state(args, 0)?.get().to_bytes())) }

    fn ab_scan_deserial(args) { Ok(deserialised_state(Gathered::from_bytes(args.bytes(0))?).ret()) }

    fn ab_scan_final(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        let patches = state(args, 0)?.get().patches(&interrupt)?;
        Ok(Ret::VarlenaArray(patches.iter().map(|p| p.to_bytes()).collect()))
    }
}
