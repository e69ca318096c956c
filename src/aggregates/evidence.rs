//! `ab_evidence_agg(solid, patch, model)` and `ab_rollup_agg(evidence)`.

use asbuilt_core::error::Mismatch;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::Header;
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel};
use asbuilt_core::{Error, Result};

use crate::pg::{Account, AggState, Args, Backend, SqlValue, aggregate_state, deserialised_state, sql_functions};
use crate::types::model_arg;
use crate::types::uncertain::value;

/// Reads the model in an argument.
pub type ModelArg = fn(&Args, usize) -> Result<EvidenceModel>;

/// Evidence about one solid, gathered by one worker.
#[derive(Default)]
enum State {
    /// No row with a solid yet.
    #[default]
    Empty,
    /// This worker takes patches.
    Collecting(Box<Collecting>),
    /// Only merges what others collected.
    Merged(Box<Evidence>),
}

struct Collecting {
    collector: Collector,
    /// The arguments as they were in the first row; the same bytes mean the same value.
    raw_solid: Vec<u8>,
    model: EvidenceModel,
}

impl State {
    fn evidence(&self) -> Option<&Evidence> {
        match self {
            Self::Empty => None,
            Self::Collecting(c) => Some(c.collector.evidence()),
            Self::Merged(e) => Some(e),
        }
    }

    fn merge(&mut self, other: &Evidence) -> Result<()> {
        match self {
            Self::Empty => {
                let mut copy = other.without_stations();
                copy.merge(other, &Backend)?;
                *self = Self::Merged(Box::new(copy));
                Ok(())
            }
            Self::Collecting(c) => c.collector.merge(other, &Backend),
            Self::Merged(e) => e.merge(other, &Backend),
        }
    }

    /// The collector for the row's solid (argument 1) and model, made at the first row.
    fn collecting(&mut self, args: &Args, model: EvidenceModel) -> Result<&mut Collector> {
        if matches!(self, Self::Empty) {
            let solid = Solid::from_stored(args.bytes(1), &Backend)?;
            let collector = Collector::new(&solid, model, &Backend)?;
            *self = Self::Collecting(Box::new(Collecting { collector, raw_solid: args.raw(1).to_vec(), model }));
        }
        match self {
            Self::Collecting(c) if c.raw_solid != args.raw(1) && !same_solid(&c.collector, args)? => {
                Err(Error::Mismatch(Mismatch::GroupOfSolids))
            }
            Self::Collecting(c) if c.model != model => Err(Error::Mismatch(Mismatch::GroupOfModels)),
            Self::Collecting(c) => Ok(&mut c.collector),
            _ => Err(Error::Mismatch(Mismatch::PatchesAfterMerge)),
        }
    }
}

/// Unequal bytes may still be the same solid, stored differently.
fn same_solid(collector: &Collector, args: &Args) -> Result<bool> {
    Ok(collector.evidence().fingerprint() == Solid::from_stored(args.bytes(1), &Backend)?.fingerprint(&Backend)?)
}

fn state(args: &Args, i: usize) -> Result<AggState<State>> {
    aggregate_state(args, i, || Ok(State::default()))
}

/// transition(state, solid, patch, model): a NULL patch adds nothing, but the object is there.
pub fn absorb_patch(args: &Args, model: ModelArg) -> Result<SqlValue> {
    let mut state = state(args, 0)?;
    if !args.is_null(1) {
        let collector = state.get().collecting(args, model(args, 3)?)?;
        if !args.is_null(2) && collector.concerns(&Header::read(args.prefix(2, Header::LEN))?) {
            collector.absorb(args.bytes(2), &Backend)?;
        }
    }
    Ok(state.ret())
}

/// transition(state, solid, tie point, cameras, model): a NULL point adds nothing; without cameras it has no rays.
pub fn absorb_tie_point(args: &Args, model: ModelArg) -> Result<SqlValue> {
    let mut state = state(args, 0)?;
    if !args.is_null(1) {
        let collector = state.get().collecting(args, model(args, 4)?)?;
        if !args.is_null(2) {
            let cameras = if args.is_null(3) { Vec::new() } else { args.f64_triples(3, "the cameras")? };
            if let Some(c) = cameras.iter().flatten().find(|c| !c.is_finite()) {
                return Err(Error::argument("a camera's coordinate", "finite", c));
            }
            let cameras: Vec<Vec3> = cameras.into_iter().map(Vec3::from).collect();
            collector.absorb_tie_point(&value(args, 2), &cameras, &Backend)?;
        }
    }
    Ok(state.ret())
}

sql_functions! {
    on Account::Evidence;

    fn ab_model_accum(args) { absorb_patch(args, model_arg) }

    fn ab_model_accum_point(args) { absorb_tie_point(args, model_arg) }

    fn ab_evidence_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1)
            && let Some(right) = state(args, 1)?.get().evidence()
        {
            left.get().merge(right)?;
        }
        Ok(left.ret())
    }

    fn ab_evidence_serial(args) {
        let mut state = state(args, 0)?;
        let bytes = state.get().evidence().map(|e| e.to_bytes(&Backend)).transpose()?;
        Ok(SqlValue::Bytes(bytes.unwrap_or_default()))
    }

    fn ab_evidence_deserial(args) {
        let state = match args.bytes(0) {
            [] => State::Empty,
            bytes => State::Merged(Box::new(Evidence::from_bytes(bytes, &Backend)?)),
        };
        Ok(deserialised_state(state).ret())
    }

    fn ab_evidence_final(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let bytes = state(args, 0)?.get().evidence().map(|e| e.to_bytes(&Backend)).transpose()?;
        Ok(bytes.map_or(SqlValue::Null, SqlValue::Bytes))
    }

    /// transition(state, evidence) of ab_rollup_agg.
    fn ab_rollup_accum(args) {
        let mut state = state(args, 0)?;
        if !args.is_null(1) {
            state.get().merge(&Evidence::from_bytes(args.bytes(1), &Backend)?)?;
        }
        Ok(state.ret())
    }
}
