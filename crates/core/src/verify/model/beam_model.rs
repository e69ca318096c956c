//! What differs from model to model.

use super::kind::with_model;
use super::outcome::BeamOutcome;
use super::parameters::EvidenceModel;
use super::statement::Statement;
use super::sums::Sums;
use super::touch::PointTouch;
use super::viewing_geometry::ViewingGeometry;
use crate::geometry::Vec3;
use crate::scan::RangeImage;
use crate::verify::aim::AimedAt;
use crate::{Interrupt, Result};

/// How beams become sums at the samples of an object, and what a station's sums state. Chosen once a patch by
/// [`with_model`].
pub trait BeamModel {
    /// The beams of a patch, made ready for all samples around.
    type PreparedBeams<'v>;

    /// Whether each beam is asked against the drawn surface first, and tells only of the place where it crosses that:
    /// samples that look away from the scanner are then left out.
    const CROSSES_SURFACE: bool;
    /// Whether stations measure how far off the built surface is. If not, tolerances and contradictions mean little.
    const MEASURES_DEVIATIONS: bool;
    /// Whether the rays to a tie point tell of the surface at their end, too.
    const RAYS_TELL_OF_THEIR_END: bool;

    /// Whether beams can add up to these sums.
    fn are_possible(sums: &Sums) -> bool;

    /// How far beside a beam its kernel reaches, metres; 0 where the kernel is an angle.
    fn kernel_radius(model: &EvidenceModel) -> f64;

    /// Makes a patch's beams ready; `None` if none of them tells anything. `keep` may take back some of it.
    fn beams<'v>(
        view: &'v RangeImage,
        aimed: &AimedAt<'_>,
        model: &'v EvidenceModel,
        keep: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
        interrupt: Interrupt,
    ) -> Result<Option<Self::PreparedBeams<'v>>>;

    /// How far beside the patch's cone samples are that its beams tell of, metres.
    fn beside_cone(beams: &Self::PreparedBeams<'_>) -> f64;

    /// Whether any beam may tell of a sample in a ball (from the scanner, metres).
    fn may_tell_of(beams: &Self::PreparedBeams<'_>, centre_scanner: &Vec3, radius: f64) -> bool;

    /// Adds the beams around a sample at `offset_scanner`, whose `normal` looks at the scanner.
    fn gather(beams: &Self::PreparedBeams<'_>, offset_scanner: &Vec3, normal: &Vec3, sums: &mut Sums);

    /// The same sums, their deviations counted the other way.
    fn turned(sums: &Sums) -> Sums;

    /// Adds a point that no beam was aimed with.
    fn add_point(touch: &PointTouch, model: &EvidenceModel, sums: &mut Sums);

    /// What a station's sums state; `None` where they state nothing.
    fn read(sums: &Sums, sight: &ViewingGeometry, model: &EvidenceModel) -> Option<Statement>;

    /// A sample is seen when as much belief as this could be formed there.
    fn least_belief_of_seen(model: &EvidenceModel) -> f64;
}

/// [`BeamModel::MEASURES_DEVIATIONS`] of the model that the parameters name.
pub fn measures_deviations(model: &EvidenceModel) -> bool {
    with_model!(model.kind, M => M::MEASURES_DEVIATIONS)
}
