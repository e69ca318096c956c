//! Belief: masses over {occupied, empty}, how they combine, what sensors say, and levels of accuracy. Read in this
//! order:
//!
//! * [`loa`]: levels of accuracy;
//! * [`accuracy`]: probabilities of levels, beliefs at other levels, tolerances;
//! * [`mass`]: belief in occupied and empty, and what is unknown;
//! * [`commonality`]: Dempster's rule as a sum of logarithms;
//! * [`measure`]: how uncertain a mass is, and what to decide on it;
//! * [`rule`]: rules of combination for two sources;
//! * [`pool`]: any number of sources;
//! * [`ray_model`]: what one beam says of a point, as published;
//! * [`sensor`]: what other observations say;
//! * [`preset`]: which scanners measure how well.

pub mod accuracy;
mod commonality;
mod loa;
mod mass;
mod measure;
mod pool;
mod preset;
mod ray_model;
mod rule;
mod sensor;

pub use commonality::LogCommonality;
pub use loa::Loa;
pub use mass::{Hypothesis, Mass};
pub use measure::Criterion;
pub use pool::Pool;
pub use preset::SensorPreset;
pub use ray_model::RayModel;
pub use rule::CombinationRule;
pub use sensor::SurfaceObservation;
