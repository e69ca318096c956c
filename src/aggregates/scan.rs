//! `ab_scan_agg`: patches from rows of returns.

use asbuilt_core::Result;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{PatchBuilder, Return};

use crate::pg::{AggState, Args, Backend, SqlValue, aggregate_state, deserialised_state, sql_functions};
use crate::types::planes::{one_colour, one_intensity};

fn state(args: &Args, i: usize) -> Result<AggState<PatchBuilder>> {
    aggregate_state(args, i, || Ok(PatchBuilder::default()))
}

/// The row (x, y, z, [origin,] [station [, intensity [, colour]]]) behind the state, and its station.
fn row(args: &Args, with_origin: bool) -> Result<(i64, Return)> {
    let has = |i: usize| args.len() > i;
    let next = if with_origin { 5 } else { 4 };
    let origin = (with_origin && has(4)).then(|| args.vector::<3>(4, "the origin")).transpose()?;
    let station = if has(next) { args.i64(next) } else { 0 };
    let intensity = has(next + 1).then(|| one_intensity(args.i32(next + 1))).transpose()?;
    let colour =
        has(next + 2).then(|| args.i32_vector::<3>(next + 2, "the colour").and_then(one_colour)).transpose()?;
    let point = Vec3::new(args.f64(1), args.f64(2), args.f64(3));
    Ok((station, Return { point, origin: origin.map(Vec3::from), intensity, colour }))
}

/// A row with a NULL adds nothing.
fn accumulate(args: &Args, with_origin: bool) -> Result<SqlValue> {
    let mut state = state(args, 0)?;
    if !(1..args.len()).any(|i| args.is_null(i)) {
        let (station, row) = row(args, with_origin)?;
        state.get().push(station, &row, &Backend)?;
    }
    Ok(state.ret())
}

sql_functions! {
    fn ab_scan_accum(args) { accumulate(args, true) }

    fn ab_cloud_accum(args) { accumulate(args, false) }

    fn ab_scan_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1) {
            left.get().merge(state(args, 1)?.get(), &Backend)?;
        }
        Ok(left.ret())
    }

    fn ab_scan_serial(args) { Ok(SqlValue::Bytes(state(args, 0)?.get().to_bytes(&Backend)?)) }

    fn ab_scan_deserial(args) { Ok(deserialised_state(PatchBuilder::from_bytes(args.bytes(0), &Backend)?).ret()) }

    fn ab_scan_final(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let patches = state(args, 0)?.get().patches(&Backend)?;
        Ok(SqlValue::VarlenaArray(patches.iter().map(|p| p.to_bytes()).collect()))
    }
}
