//! Adding up what patches tell of solids.
//!
//! A `DrawnObject` is a solid made ready for beams. A [`Collector`] takes patches one by one and adds what their beams met
//! to the sums of the samples around; `points` adds what no beam was aimed with, for which a `PointIndex` finds the
//! samples. [`SurveyObjects`] are all objects as they are drawn, in batches of neighbours; a [`Verifier`] collects for
//! those of a batch, which know each other, on one thread or on several ([`Threads`]).

mod collector;
mod drawn_object;
mod point_index;
mod points;
mod survey_objects;
mod threads;
mod verifier;

pub use collector::Collector;
pub use survey_objects::{Batch, SurveyObjects};
pub use threads::Threads;
pub use verifier::Verifier;
