//! What a stored evidence tells without its samples.

use crate::geometry::Aabb;
use crate::verify::model::EvidenceModel;

/// What a stored evidence tells without its samples.
#[derive(Debug, Clone, Copy)]
pub struct EvidenceHeader {
    /// Box of the solid.
    pub bounds: Aabb,
    /// Number of samples.
    pub samples: u32,
    /// Number of stations that saw the solid.
    pub stations: u32,
    /// The parameters.
    pub model: EvidenceModel,
}
