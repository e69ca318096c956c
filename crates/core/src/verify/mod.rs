//! What the beams of many stations say about a solid, and the verdict that follows.
//!
//! [`EvidenceModel`] holds the parameters. [`Samples`] are spread over the solid's faces. A [`Collector`] takes
//! scan patches one by one: it finds where each beam would cross the solid, and adds what that beam saw there to
//! the sums of the samples around ([`Sums`]). A [`Verifier`] does so for many solids at once. The result is
//! [`Evidence`], a value that can be stored, added up and asked: per sample for its belief, per object for a
//! [`Summary`].

mod belief;
mod built_surface;
mod claims;
mod collect;
mod collect_points;
mod consensus;
mod contribution;
mod crossing;
mod encounter;
mod evidence;
mod evidence_bytes;
mod explain;
mod face;
mod foot;
mod forecast;
mod intensity;
mod judgement;
mod model;
mod observe;
mod point_index;
mod ray_sums;
mod reading;
mod sample;
mod shift;
mod summary;
mod sums;
mod surface_points;
mod surface_sums;
mod target;
mod unpacked;
mod verifier;

pub use belief::SampleBelief;
pub use collect::Collector;
pub use contribution::Contribution;
pub use evidence::{Evidence, EvidenceHeader, Place, Station};
pub use face::{Counts, FaceReport};
pub use forecast::PlannedStation;
pub use intensity::IntensityNoise;
pub use model::{EvidenceModel, ModelKind};
pub use sample::Samples;
pub use shift::Shift;
pub use summary::{Shares, Summary, Verdict, VerdictRule};
pub use sums::Sums;
pub use surface_points::SurfacePoints;
pub use verifier::{Threads, Verifier};
