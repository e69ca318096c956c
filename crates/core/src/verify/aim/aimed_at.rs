//! What the beams of a patch are aimed at, all together.

use super::claims::OtherObjects;
use super::crossing::BeamCrossing;
use super::target::Target;

/// One solid, where the beams of a patch cross it, and what else they may have met.
#[derive(Debug, Clone, Copy)]
pub struct AimedAt<'a> {
    pub target: &'a Target,
    /// The first crossing of every beam that crosses; empty where nobody asks for them.
    pub crossings: &'a [BeamCrossing],
    /// The other objects, where they are known.
    pub others: Option<OtherObjects<'a>>,
}
