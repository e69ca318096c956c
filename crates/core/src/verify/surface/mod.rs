//! The surface that was built, whatever tolerance will be asked.
//!
//! A [`SampleReading`] is what the stations state at one sample, as bodies of evidence ([`EvidenceBody`]), and how far
//! they conflict. [`Observations`] are all seen samples of an object. A [`FittedObject`] has for each smooth surface
//! what follows its `trend` (`surface_trend`, [`FittedSurface`]), and for each face where it is ([`FittedFace`]). From
//! the faces follows the rigid [`Shift`].

mod basis;
mod body;
mod closest_points;
mod compact;
mod fitted_face;
mod fitted_object;
mod fitted_surface;
mod observations;
mod reading;
mod shift;
mod station_shares;
mod surface_trend;
mod trend;
mod vote;

pub(super) use body::EvidenceBody;
pub(super) use fitted_face::FittedFace;
pub(super) use fitted_object::FittedObject;
pub(super) use fitted_surface::FittedSurface;
pub(super) use reading::SampleReading;
pub use shift::Shift;
pub(super) use shift::{shift_of, shift_of_faces};
