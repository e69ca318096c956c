//! `ab_occupancy_agg(patch, grid)` and `ab_rollup_agg(occupancy)`.

use asbuilt_core::error::LatticeMismatch;
use asbuilt_core::scan::Header;
use asbuilt_core::voxel::Occupancy;
use asbuilt_core::{Error, Result};

use crate::pg::{Account, AggState, Args, Backend, SqlValue, aggregate_state, deserialised_state, sql_functions};
use crate::types::grid_arg;

/// Occupancy gathered by one worker.
#[derive(Default)]
struct State(Option<Occupancy>);

impl State {
    fn absorb(&mut self, args: &Args) -> Result<()> {
        let grid = grid_arg(args, 2)?;
        let occupancy = self.0.get_or_insert_with(|| Occupancy::new(grid));
        if *occupancy.grid() != grid {
            return Err(Error::Lattice(LatticeMismatch::GroupOfGrids(occupancy.grid().to_text(), grid.to_text())));
        }
        if !args.is_null(1) && occupancy.concerns(&Header::read(args.prefix(1, Header::LEN))?) {
            occupancy.absorb(args.bytes(1), &Backend)?;
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

fn state(args: &Args, i: usize) -> Result<AggState<State>> {
    aggregate_state(args, i, || Ok(State::default()))
}

sql_functions! {
    on Account::Grid;

    /// transition(state, patch, grid): a NULL patch adds nothing; a row without a grid is ignored.
    fn ab_occupancy_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(2) {
            state.get().absorb(args)?;
        }
        Ok(state.ret())
    }

    fn ab_occupancy_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1)
            && let Some(taken) = state(args, 1)?.get().0.take()
        {
            left.get().merge(taken)?;
        }
        Ok(left.ret())
    }

    fn ab_occupancy_serial(args) {
        Ok(SqlValue::Bytes(state(args, 0)?.get().to_bytes()?.unwrap_or_default()))
    }

    fn ab_occupancy_deserial(args) {
        let mut state = State::default();
        if !args.bytes(0).is_empty() {
            state.merge(Occupancy::from_bytes(args.bytes(0), &Backend)?)?;
        }
        Ok(deserialised_state(state).ret())
    }

    fn ab_occupancy_final(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        Ok(state(args, 0)?.get().to_bytes()?.map_or(SqlValue::Null, SqlValue::Bytes))
    }

    /// transition(state, occupancy) of ab_rollup_agg.
    fn ab_occupancy_rollup_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(1) {
            state.get().merge(Occupancy::from_bytes(args.bytes(1), &Backend)?)?;
        }
        Ok(state.ret())
    }
}
