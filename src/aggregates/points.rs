//! `ab_line_agg` and `ab_plane_agg`: best fits through points.

use asbuilt_core::error::Limited;
use asbuilt_core::uncertain::{Stored, UncertainPoint, fit};
use asbuilt_core::{Error, Grow, Interrupt, Result};

use crate::pg::{AggState, Backend, Bytea, Internal, SqlValue, StateOrNew, Varlena, deserialised_state, sql_functions};
use crate::types::uncertain::ret;

/// Most points of one fit: they are in memory, 96 bytes each.
const MAX_POINTS: usize = 2_000_000;
/// Bytes of one point as exchanged between workers.
const POINT_LEN: usize = 72;

fn check(points: &[UncertainPoint]) -> Result<()> {
    if points.len() <= MAX_POINTS {
        return Ok(());
    }
    let (value, limit) = (points.len().to_string(), MAX_POINTS.to_string());
    Err(Error::Limit { what: Limited::FitPoints, value, limit })
}

/// What `fit` makes of the points; NULL where there is none.
fn fitted<T: Stored<N> + Copy, const N: usize>(
    state: Option<AggState<Vec<UncertainPoint>>>,
    fit: fn(&[UncertainPoint], Interrupt) -> Result<T>,
) -> Result<SqlValue> {
    let Some(mut state) = state else { return Ok(SqlValue::Null) };
    let points = state.get();
    if points.is_empty() { Ok(SqlValue::Null) } else { ret(&fit(points, &Backend)?) }
}

sql_functions! {
    fn ab_points_accum(state: StateOrNew<Vec<UncertainPoint>>, point: Option<UncertainPoint>) {
        let mut state = state.0;
        if let Some(point) = point {
            state.get().grow(1, &Backend)?;
            state.get().push(point);
            check(state.get())?;
        }
        Ok(state.ret())
    }

    fn ab_points_combine(left: StateOrNew<Vec<UncertainPoint>>, right: Option<AggState<Vec<UncertainPoint>>>) {
        let mut left = left.0;
        if let Some(mut right) = right {
            left.get().grow(right.get().len(), &Backend)?;
            left.get().extend_from_slice(right.get());
            check(left.get())?;
        }
        Ok(left.ret())
    }

    fn ab_points_serial(state: AggState<Vec<UncertainPoint>>) {
        let mut state = state;
        let numbers = state.get().iter().flat_map(UncertainPoint::to_numbers);
        Ok(SqlValue::Bytes(numbers.flat_map(f64::to_ne_bytes).collect()))
    }

    fn ab_points_deserial(bytes: Varlena<Bytea>, dummy: Internal) {
        let (rows, rest) = bytes.bytes().as_chunks::<POINT_LEN>();
        if !rest.is_empty() {
            return Err(Error::binary("the state of a fit", "a point is cut short"));
        }
        let point = |row: &[u8; POINT_LEN]| {
            UncertainPoint::from_stored(&std::array::from_fn(|i| {
                f64::from_ne_bytes(std::array::from_fn(|k| row[8 * i + k]))
            }))
        };
        Ok(deserialised_state(rows.iter().map(point).collect::<Vec<UncertainPoint>>()).ret())
    }

    fn ab_line_fit(state: Option<AggState<Vec<UncertainPoint>>>) { fitted(state, fit::line) }

    fn ab_plane_fit(state: Option<AggState<Vec<UncertainPoint>>>) { fitted(state, fit::plane) }
}
