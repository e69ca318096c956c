//! `ab_occupancy_agg(patch, grid)` and `ab_rollup_agg(occupancy)`.

use asbuilt_core::error::LatticeMismatch;
use asbuilt_core::voxel::Occupancy;
use asbuilt_core::{Error, Result};

use crate::pg::{
    Account, AggState, Backend, Bytea, Internal, SqlValue, StateOrNew, Varlena, deserialised_state, sql_functions,
};
use crate::types::{GridArg, OccupancyArg, ScanArg};

/// Occupancy gathered by one worker.
#[derive(Default)]
struct OccupancyState(Option<Occupancy>);

impl OccupancyState {
    fn absorb(&mut self, patch: Option<ScanArg>, grid: &GridArg) -> Result<()> {
        let grid = grid.read()?;
        let occupancy = self.0.get_or_insert_with(|| Occupancy::new(grid));
        if *occupancy.grid() != grid {
            return Err(Error::Lattice(LatticeMismatch::GroupOfGrids(occupancy.grid().to_text(), grid.to_text())));
        }
        if let Some(patch) = patch
            && occupancy.concerns(&patch.header()?)
        {
            occupancy.absorb(patch.bytes(), &Backend)?;
        }
        Ok(())
    }

    fn merge(&mut self, other: Occupancy) -> Result<()> {
        match &mut self.0 {
            Some(own) => own.merge(&other, &Backend),
            None => {
                self.0 = Some(other);
                Ok(())
            }
        }
    }

    fn to_bytes(&self) -> Result<Option<Vec<u8>>> {
        self.0.as_ref().map(|o| o.to_bytes(&Backend)).transpose()
    }
}

sql_functions! {
    on Account::Grid;

    /// A NULL patch adds nothing; a row without a grid is ignored.
    fn ab_occupancy_accum(state: StateOrNew<OccupancyState>, patch: Option<ScanArg>, grid: Option<GridArg>) {
        let mut state = state.0;
        if let Some(grid) = grid {
            state.get().absorb(patch, &grid)?;
        }
        Ok(state.ret())
    }

    fn ab_occupancy_combine(left: StateOrNew<OccupancyState>, right: Option<AggState<OccupancyState>>) {
        let mut left = left.0;
        if let Some(mut right) = right
            && let Some(taken) = right.get().0.take()
        {
            left.get().merge(taken)?;
        }
        Ok(left.ret())
    }

    fn ab_occupancy_serial(state: AggState<OccupancyState>) {
        let mut state = state;
        Ok(SqlValue::Bytes(state.get().to_bytes()?.unwrap_or_default()))
    }

    fn ab_occupancy_deserial(bytes: Varlena<Bytea>, dummy: Internal) {
        let mut state = OccupancyState::default();
        if !bytes.bytes().is_empty() {
            state.merge(Occupancy::from_bytes(bytes.bytes(), &Backend)?)?;
        }
        Ok(deserialised_state(state).ret())
    }

    fn ab_occupancy_final(state: Option<AggState<OccupancyState>>) {
        let Some(mut state) = state else { return Ok(SqlValue::Null) };
        Ok(state.get().to_bytes()?.map_or(SqlValue::Null, SqlValue::Bytes))
    }

    /// The transition of ab_rollup_agg.
    fn ab_occupancy_rollup_accum(state: StateOrNew<OccupancyState>, occupancy: Option<OccupancyArg>) {
        let mut state = state.0;
        if let Some(occupancy) = occupancy {
            state.get().merge(occupancy.read()?)?;
        }
        Ok(state.ret())
    }
}
