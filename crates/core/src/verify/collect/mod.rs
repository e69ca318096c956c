//! Adding up what patches tell of solids.
//!
//! A [`Collector`] takes patches one by one and adds what their beams met to the sums of the samples around; `points`
//! adds what no beam was aimed with, for which a `PointIndex` finds the face. A [`Verifier`] does so for many objects
//! that know each other, on one thread or on several ([`Threads`]).

mod collector;
mod point_index;
mod points;
mod threads;
mod verifier;

pub use collector::Collector;
pub use threads::Threads;
pub use verifier::Verifier;
