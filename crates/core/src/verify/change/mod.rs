//! What became of an object between two epochs, from the evidence of both at the same samples.
//!
//! Not from two verdicts: a sample says something of change only where both epochs saw it.
//!
//! * [`thresholds`]: the numbers;
//! * [`state`]: what one epoch says at a sample: the object is there, its place is empty, or nothing;
//! * [`epoch`]: the fitted object of one epoch, asked sample by sample;
//! * [`paired`]: both epochs at every sample that both saw, counted and by face ([`PairedSamples`]);
//! * [`displacement`]: how far the object moved, from the differences of its faces ([`Displacement`]);
//! * [`class`]: the classes ([`ObjectChangeClass`]), and which one follows;
//! * [`value`]: all of it for one object ([`ObjectChange`]);
//! * [`elsewhere`]: a second look for what left its place ([`SurveyedEpoch`]).

mod class;
mod displacement;
mod elsewhere;
mod epoch;
mod paired;
mod state;
mod thresholds;
mod value;

pub use class::ObjectChangeClass;
pub use displacement::Displacement;
pub use elsewhere::SurveyedEpoch;
pub use paired::PairedSamples;
pub use value::ObjectChange;
