//! What a beam says about a place: the parameters, and one file for each model.
//!
//! [`EvidenceModel`] holds the parameters, [`Question`] those that can be asked anew. What differs from model to model
//! is the trait [`BeamModel`]: how beams become integer [`Sums`] at a sample, and what a station's sums state there
//! ([`Statement`]). [`Surface`] is the product's own model, with the sums in `surface_sums`, the weights in `kernel`,
//! and what each beam met in `outcome` and `ownership`; [`Meyer2022`] is the published one. A new model is a file here,
//! its type named below, and an entry in `kind`.

mod beam_model;
mod intensity;
mod kernel;
mod kind;
mod meyer2022;
mod outcome;
mod ownership;
mod parameters;
mod question;
mod statement;
mod sums;
mod surface;
mod surface_sums;
mod touch;
mod viewing_geometry;

pub(super) use beam_model::{BeamModel, measures_deviations};
pub use intensity::IntensityNoise;
pub(super) use kernel::{BEAMS_IN_KERNEL, KERNEL_SPACINGS, same_surface};
pub use kind::ModelKind;
pub(super) use kind::with_model;
pub(super) use meyer2022::Meyer2022;
pub(super) use outcome::BeamOutcome;
pub(super) use ownership::{RATHER, as_designed, may_be_anothers, three_sigma};
pub use parameters::EvidenceModel;
pub use question::Question;
pub(super) use statement::{Statement, StationObservation};
pub(super) use sums::Sums;
pub(super) use surface::{Surface, independence};
pub(super) use surface_sums::{SurfaceReading, SurfaceSums};
pub(super) use touch::PointTouch;
pub(super) use viewing_geometry::ViewingGeometry;
