//! Belief: masses over {occupied, empty}, how they combine, what one ray says, and levels of accuracy.

mod commonality;
mod loa;
mod mass;
mod ray_model;

pub use commonality::LogCommonality;
pub use loa::Loa;
pub use mass::{Hypothesis, Mass};
pub use ray_model::RayModel;
