//! `ab_occupancy_agg(patch, grid)` and `ab_rollup_agg(occupancy)`.

use std::sync::atomic::{AtomicUsize, Ordering};

use asbuilt_core::scan::Header;
use asbuilt_core::voxel::Occupancy;
use asbuilt_core::{Error, Result};

use crate::pg::{AggState, Args, Ret, aggregate_state, deserialised_state, interrupt, sql_functions};
use crate::settings::max_grid_memory;
use crate::types::grid_arg;

/// Bytes that all states of this process take, so that a group for every tile does not multiply the limit.
static IN_USE: AtomicUsize = AtomicUsize::new(0);

/// Occupancy gathered by one worker; gives its share of [`IN_USE`] back when PostgreSQL drops it.
#[derive(Default)]
struct State {
    occupancy: Option<Occupancy>,
    counted: usize,
}

impl State {
    /// Bytes that this state may take.
    fn most(&self) -> usize {
        max_grid_memory().saturating_sub(IN_USE.load(Ordering::Relaxed) - self.counted)
    }

    fn count(&mut self) -> Result<()> {
        let now = self.occupancy.as_ref().map_or(0, Occupancy::memory);
        IN_USE.fetch_add(now, Ordering::Relaxed);
        IN_USE.fetch_sub(self.counted, Ordering::Relaxed);
        self.counted = now;
        self.occupancy.as_ref().map_or(Ok(()), |o| o.check_memory(self.most()))
    }

    fn absorb(&mut self, args: &Args) -> Result<()> {
        let grid = grid_arg(args, 2)?;
        let most = self.most();
        let occupancy = self.occupancy.get_or_insert_with(|| Occupancy::new(grid));
        if *occupancy.grid() != grid {
            let reason = format!("the group has {} and {}", occupancy.grid().to_text(), grid.to_text());
            return Err(Error::Lattice { reason });
        }
        if !args.is_null(1) && occupancy.concerns(&Header::read(args.prefix(1, Header::LEN))?) {
            let absorbed = occupancy.absorb(args.bytes(1), most, &interrupt);
            self.count()?;
            absorbed?;
        }
        Ok(())
    }

    fn merge(&mut self, other: Occupancy) -> Result<()> {
        match &mut self.occupancy {
            Some(own) => own.merge(&other, &interrupt)?,
            None => self.occupancy = Some(other),
        }
        self.count()
    }
}

impl Drop for State {
    fn drop(&mut self) {
        IN_USE.fetch_sub(self.counted, Ordering::Relaxed);
    }
}

fn state(args: &Args, i: usize) -> Result<AggState<State>> {
    aggregate_state(args, i, || Ok(State::default()))
}

sql_functions! {
    /// transition(state, patch, grid): a NULL patch adds nothing; without a grid nothing is asked.
    fn ab_occupancy_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(2) {
            state.get().absorb(args)?;
        }
        Ok(state.ret())
    }

    fn ab_occupancy_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1) {
            let mut right = state(args, 1)?;
            let taken = right.get().occupancy.take();
            right.get().count()?;
            if let Some(taken) = taken {
                left.get().merge(taken)?;
            }
        }
        Ok(left.ret())
    }

    fn ab_occupancy_serial(args) {
        let mut state = state(args, 0)?;
        let bytes = state.get().occupancy.as_ref().map(|o| o.to_bytes(&interrupt)).transpose()?;
        Ok(Ret::Bytes(bytes.unwrap_or_default()))
    }

    fn ab_occupancy_deserial(args) {
        let mut state = State::default();
        if !args.bytes(0).is_empty() {
            let most = state.most();
            state.merge(Occupancy::from_bytes(args.bytes(0), most, &interrupt)?)?;
        }
        Ok(deserialised_state(state).ret())
    }

    fn ab_occupancy_final(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        let bytes = state(args, 0)?.get().occupancy.as_ref().map(|o| o.to_bytes(&interrupt)).transpose()?;
        Ok(bytes.map_or(Ret::Null, Ret::Bytes))
    }

    /// transition(state, occupancy) of ab_rollup_agg.
    fn ab_occupancy_rollup_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(1) {
            let most = state.get().most();
            let occupancy = Occupancy::from_bytes(args.bytes(1), most, &interrupt)?;
            state.get().merge(occupancy)?;
        }
        Ok(state.ret())
    }
}
