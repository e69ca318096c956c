//! What the beams of many stations tell of a solid, and the verdict that follows.
//!
//! Six rooms after the stages of the method, and the models that they share. A room uses only those before it:
//!
//! * [`aim`]: where the beams of a patch would meet a solid that was made ready (`Target`);
//! * [`model`]: the parameters ([`EvidenceModel`]), and by kind of model how beams become integer sums and what these
//!   state;
//! * [`evidence`]: what is stored, [`Samples`] on the solid and the sums of each [`StationEvidence`] ([`Evidence`]);
//! * [`sights`]: where all beams ended ([`Sights`]), for a second look at what stayed unobserved or was not found;
//! * [`collect`]: adding patches to the evidence of one solid ([`Collector`]) or of many ([`Verifier`]);
//! * [`surface`]: from evidence to `Observations` of all seen samples, and the `FittedObject` that was built;
//! * [`verdict`]: from there to a `Judgement` at one tolerance, and to a [`Summary`];
//! * [`change`]: the `FittedObject`s of two epochs, compared ([`ObjectChange`]).
//!
//! So the data goes: solid + model → `Target` → [`Evidence`] → `Observations` → `FittedObject` → `Judgement`.
//!
//! Positions are named by their frame: `_world`, `_local` (from the evidence's reference point), `_scanner` (from where
//! the beams of a patch start). Deviations are metres along the outward normal of the drawn face, but in stored sums
//! towards the scanner.

mod aim;
mod change;
mod collect;
mod evidence;
mod model;
mod sights;
mod surface;
mod verdict;

pub use change::{Displacement, ObjectChange, ObjectChangeClass, PairedSamples, SurveyedEpoch};
pub use collect::{Batch, Collector, SurveyObjects, Threads, Verifier};
pub use evidence::{Evidence, EvidenceHeader, FoundFace, Samples, StationEvidence, StationOrigin, Unseen, Why};
pub use model::{EvidenceModel, IntensityNoise, ModelKind, Question};
pub use sights::Sights;
pub use surface::Shift;
pub use verdict::{
    Contribution, Counts, FaceReport, Judged, PlannedStation, SampleBelief, Shares, Summary, Verdict, VerdictRule,
};
