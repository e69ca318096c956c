//! `ab_scan_agg`: patches from rows of returns.

use asbuilt_core::Result;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{PatchBuilder, Return};

use crate::pg::{
    AggState, Args, Backend, Bytea, F64Array, I32Array, Internal, SqlValue, StateOrNew, Varlena, deserialised_state,
    sql_functions,
};
use crate::types::planes::{one_colour, one_intensity};

/// The state of the aggregate, at a row.
type Building = StateOrNew<PatchBuilder>;

/// What a row may tell beside its point; what the aggregate was not given is `None`.
struct RowAttributes<'a> {
    origin: Option<F64Array<'a>>,
    station: Option<i64>,
    intensity: Option<i32>,
    colour: Option<I32Array<'a>>,
}

/// A row with a NULL adds nothing.
fn accumulate(call: &Args, state: Building, point: [Option<f64>; 3], told: RowAttributes) -> Result<SqlValue> {
    let mut state = state.0;
    let ([Some(x), Some(y), Some(z)], false) = (point, (1..call.len()).any(|i| call.is_null(i))) else {
        return Ok(state.ret());
    };
    let row = Return {
        point: Vec3::new(x, y, z),
        origin: told.origin.map(|o| o.vector::<3>("the origin")).transpose()?.map(Vec3::from),
        intensity: told.intensity.map(one_intensity).transpose()?,
        colour: told.colour.map(|c| c.vector::<3>("the colour").and_then(one_colour)).transpose()?,
    };
    state.get().push(told.station.unwrap_or(0), &row, &Backend)?;
    Ok(state.ret())
}

sql_functions! {
    fn ab_scan_accum(
        call: Call; state: Building, x: Option<f64>, y: Option<f64>, z: Option<f64>, origin: Option<F64Array>,
        station: Option<i64>, intensity: Option<i32>, colour: Option<I32Array>
    ) {
        accumulate(call, state, [x, y, z], RowAttributes { origin, station, intensity, colour })
    }

    fn ab_cloud_accum(
        call: Call; state: Building, x: Option<f64>, y: Option<f64>, z: Option<f64>,
        station: Option<i64>, intensity: Option<i32>, colour: Option<I32Array>
    ) {
        accumulate(call, state, [x, y, z], RowAttributes { origin: None, station, intensity, colour })
    }

    fn ab_scan_combine(left: Building, right: Option<AggState<PatchBuilder>>) {
        let mut left = left.0;
        if let Some(mut right) = right {
            left.get().merge(right.get(), &Backend)?;
        }
        Ok(left.ret())
    }

    fn ab_scan_serial(state: AggState<PatchBuilder>) {
        let mut state = state;
        Ok(SqlValue::Bytes(state.get().to_bytes(&Backend)?))
    }

    fn ab_scan_deserial(bytes: Varlena<Bytea>, dummy: Internal) {
        Ok(deserialised_state(PatchBuilder::from_bytes(bytes.bytes(), &Backend)?).ret())
    }

    fn ab_scan_final(state: Option<AggState<PatchBuilder>>) {
        let Some(mut state) = state else { return Ok(SqlValue::Null) };
        let patches = state.get().patches(&Backend)?;
        Ok(SqlValue::VarlenaArray(patches.iter().map(|p| p.to_bytes()).collect()))
    }
}
