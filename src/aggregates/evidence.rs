//! `ab_evidence_agg(solid, patch, model)` and `ab_rollup_agg(evidence)`.

use asbuilt_core::error::Mismatch;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::UncertainPoint;
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel};
use asbuilt_core::{Error, Result};

use crate::pg::{
    Account, AggState, Backend, Bytea, F64Array, Internal, SqlValue, StateOrNew, Varlena, deserialised_state,
    sql_functions,
};
use crate::types::{EvidenceArg, ModelArg, ScanArg, SolidArg, model_or_default};

/// Evidence about one solid, gathered by one worker.
#[derive(Default)]
pub enum EvidenceState {
    /// No row with a solid yet.
    #[default]
    Empty,
    /// This worker takes patches.
    Collecting(Box<Collecting>),
    /// Only merges what others collected.
    Merged(Box<Evidence>),
}

pub struct Collecting {
    collector: Collector,
    /// The arguments as they were in the first row; the same bytes mean the same value.
    raw_solid: Vec<u8>,
    model: EvidenceModel,
}

impl EvidenceState {
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

    /// The collector for the row's solid and model, made at the first row.
    fn collecting(&mut self, solid: &SolidArg, model: EvidenceModel) -> Result<&mut Collector> {
        if matches!(self, Self::Empty) {
            let collector = Collector::new(&solid.read()?, model, &Backend)?;
            *self = Self::Collecting(Box::new(Collecting { collector, raw_solid: solid.raw().to_vec(), model }));
        }
        match self {
            Self::Collecting(c) if c.raw_solid != solid.raw() && !same_solid(&c.collector, solid)? => {
                Err(Error::Mismatch(Mismatch::GroupOfSolids))
            }
            Self::Collecting(c) if c.model != model => Err(Error::Mismatch(Mismatch::GroupOfModels)),
            Self::Collecting(c) => Ok(&mut c.collector),
            _ => Err(Error::Mismatch(Mismatch::PatchesAfterMerge)),
        }
    }
}

/// Unequal bytes may still be the same solid, stored differently.
fn same_solid(collector: &Collector, solid: &SolidArg) -> Result<bool> {
    Ok(collector.evidence().fingerprint() == solid.read()?.fingerprint(&Backend)?)
}

/// The state of the aggregate, at a row.
pub type Gathering = StateOrNew<EvidenceState>;

/// A NULL patch adds nothing, but the object is there. `model` is asked for where there is a solid.
pub fn absorb_patch(
    mut state: Gathering,
    solid: Option<SolidArg>,
    patch: Option<ScanArg>,
    model: impl FnOnce() -> Result<EvidenceModel>,
) -> Result<SqlValue> {
    if let Some(solid) = solid {
        let collector = state.0.get().collecting(&solid, model()?)?;
        if let Some(patch) = patch
            && collector.concerns(&patch.header()?)
        {
            collector.absorb(patch.bytes(), &Backend)?;
        }
    }
    Ok(state.0.ret())
}

/// A NULL point adds nothing; without cameras it has no rays.
pub fn absorb_tie_point(
    mut state: Gathering,
    solid: Option<SolidArg>,
    point: Option<UncertainPoint>,
    cameras: Option<F64Array>,
    model: impl FnOnce() -> Result<EvidenceModel>,
) -> Result<SqlValue> {
    if let Some(solid) = solid {
        let collector = state.0.get().collecting(&solid, model()?)?;
        if let Some(point) = point {
            let cameras = cameras.map_or(Ok(Vec::new()), |c| c.triples("the cameras"))?;
            if let Some(c) = cameras.iter().flatten().find(|c| !c.is_finite()) {
                return Err(Error::argument("a camera's coordinate", "finite", c));
            }
            let cameras: Vec<Vec3> = cameras.into_iter().map(Vec3::from).collect();
            collector.absorb_tie_point(&point, &cameras, &Backend)?;
        }
    }
    Ok(state.0.ret())
}

sql_functions! {
    on Account::Evidence;

    fn ab_model_accum(
        state: Gathering, solid: Option<SolidArg>, patch: Option<ScanArg>, model: Option<ModelArg>,
    ) {
        absorb_patch(state, solid, patch, || model_or_default(model.as_ref()))
    }

    fn ab_model_accum_point(
        state: Gathering, solid: Option<SolidArg>, point: Option<UncertainPoint>, cameras: Option<F64Array>,
        model: Option<ModelArg>,
    ) {
        absorb_tie_point(state, solid, point, cameras, || model_or_default(model.as_ref()))
    }

    fn ab_evidence_combine(left: Gathering, right: Option<AggState<EvidenceState>>) {
        let mut left = left.0;
        if let Some(mut right) = right
            && let Some(right) = right.get().evidence()
        {
            left.get().merge(right)?;
        }
        Ok(left.ret())
    }

    fn ab_evidence_serial(state: AggState<EvidenceState>) {
        let mut state = state;
        let bytes = state.get().evidence().map(|e| e.to_bytes(&Backend)).transpose()?;
        Ok(SqlValue::Bytes(bytes.unwrap_or_default()))
    }

    fn ab_evidence_deserial(bytes: Varlena<Bytea>, dummy: Internal) {
        let state = match bytes.bytes() {
            [] => EvidenceState::Empty,
            bytes => EvidenceState::Merged(Box::new(Evidence::from_bytes(bytes, &Backend)?)),
        };
        Ok(deserialised_state(state).ret())
    }

    fn ab_evidence_final(state: Option<AggState<EvidenceState>>) {
        let Some(mut state) = state else { return Ok(SqlValue::Null) };
        let bytes = state.get().evidence().map(|e| e.to_bytes(&Backend)).transpose()?;
        Ok(bytes.map_or(SqlValue::Null, SqlValue::Bytes))
    }

    /// The transition of ab_rollup_agg.
    fn ab_rollup_accum(state: Gathering, evidence: Option<EvidenceArg>) {
        let mut state = state.0;
        if let Some(evidence) = evidence {
            state.get().merge(&evidence.read()?)?;
        }
        Ok(state.ret())
    }
}
