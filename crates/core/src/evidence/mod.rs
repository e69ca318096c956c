//! Belief: masses over {occupied, empty}, how they combine, what sensors say, and levels of accuracy.

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
pub use rule::Rule;
pub use sensor::SurfaceObservation;
