//! `ab_line_agg` and `ab_plane_agg`: best fits through points.

use asbuilt_core::error::Limited;
use asbuilt_core::uncertain::{Point, Stored, fit};
use asbuilt_core::{Error, Grow, Interrupt, Result};

use crate::pg::{AggState, Args, Backend, SqlValue, aggregate_state, deserialised_state, sql_functions};
use crate::types::uncertain::{ret, value};

/// Most points of one fit: they are in memory, 96 bytes each.
const MAX_POINTS: usize = 2_000_000;
/// Bytes of one point as exchanged between workers.
const POINT_LEN: usize = 72;

fn state(args: &Args, i: usize) -> Result<AggState<Vec<Point>>> {
    aggregate_state(args, i, || Ok(Vec::new()))
}

fn check(points: &[Point]) -> Result<()> {
    if points.len() <= MAX_POINTS {
        return Ok(());
    }
    let (value, limit) = (points.len().to_string(), MAX_POINTS.to_string());
    Err(Error::Limit { what: Limited::FitPoints, value, limit })
}

/// What `fit` makes of the points; NULL where there is none.
fn fitted<T: Stored<N> + Copy, const N: usize>(
    args: &Args,
    fit: fn(&[Point], Interrupt) -> Result<T>,
) -> Result<SqlValue> {
    if args.is_null(0) {
        return Ok(SqlValue::Null);
    }
    let mut state = state(args, 0)?;
    let points = state.get();
    if points.is_empty() { Ok(SqlValue::Null) } else { ret(&fit(points, &Backend)?) }
}

sql_functions! {
    fn ab_points_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(1) {
            state.get().grow(1, &Backend)?;
            state.get().push(value(args, 1));
            check(state.get())?;
        }
        Ok(state.ret())
    }

    fn ab_points_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1) {
            let mut right = state(args, 1)?;
            left.get().grow(right.get().len(), &Backend)?;
            left.get().extend_from_slice(right.get());
            check(left.get())?;
        }
        Ok(left.ret())
    }

    fn ab_points_serial(args) {
        let mut state = state(args, 0)?;
        let numbers = state.get().iter().flat_map(Point::to_numbers);
        Ok(SqlValue::Bytes(numbers.flat_map(f64::to_ne_bytes).collect()))
    }

    fn ab_points_deserial(args) {
        let (rows, rest) = args.bytes(0).as_chunks::<POINT_LEN>();
        if !rest.is_empty() {
            return Err(Error::binary("the state of a fit", "a point is cut short"));
        }
        let point = |row: &[u8; POINT_LEN]| {
            Point::from_stored(&std::array::from_fn(|i| {
                f64::from_ne_bytes(std::array::from_fn(|k| row[8 * i + k]))
            }))
        };
        Ok(deserialised_state(rows.iter().map(point).collect::<Vec<Point>>()).ret())
    }

    fn ab_line_fit(args) { fitted(args, fit::line) }

    fn ab_plane_fit(args) { fitted(args, fit::plane) }
}
