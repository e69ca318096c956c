//! The `meyer2022` model: logarithmic commonalities of every beam that passes near a sample.

use super::beam_model::BeamModel;
use super::outcome::BeamOutcome;
use super::parameters::EvidenceModel;
use super::statement::Statement;
use super::sums::Sums;
use super::touch::PointTouch;
use super::viewing_geometry::ViewingGeometry;
use crate::evidence::{LogCommonality, Mass};
use crate::geometry::Vec3;
use crate::scan::RangeImage;
use crate::verify::aim::AimedAt;
use crate::{Interrupt, Result};

/// Fixed-point unit of a logarithm, 2⁻⁴⁴: 6e-14, with room for half a million.
const LOGARITHM: f64 = (1u64 << 44) as f64;
/// Beams whose mass is nowhere above this are left out.
const MIN_MASS: f64 = 1e-13;
/// A sample is seen when this much of its mass is committed: the kernel is narrow, and belief rarely comes near the
/// confidence.
const SEEN_BY_RAYS: f64 = 0.5;

/// The model.
#[derive(Debug)]
pub struct Meyer2022;

/// The beams of a view; each tells of all places along it.
#[derive(Debug)]
pub struct RayBeams<'v> {
    view: &'v RangeImage,
    model: &'v EvidenceModel,
}

/// The model's sums: logarithms of the commonalities of all beams, fixed point.
struct RaySums {
    occupied: i64,
    empty: i64,
    unknown: i64,
}

impl RaySums {
    fn of(sums: &Sums) -> Self {
        let [occupied, empty, unknown, ..] = sums.parts();
        Self { occupied, empty, unknown }
    }

    fn parts(&self) -> [i64; Sums::PARTS] {
        [self.occupied, self.empty, self.unknown, 0, 0]
    }

    fn beam(q: &LogCommonality) -> Self {
        let fixed = |log: f64| (log * LOGARITHM).round() as i64;
        Self { occupied: fixed(q.occupied), empty: fixed(q.empty), unknown: fixed(q.unknown) }
    }
}

impl BeamModel for Meyer2022 {
    type PreparedBeams<'v> = RayBeams<'v>;

    const CROSSES_SURFACE: bool = false;
    const MEASURES_DEVIATIONS: bool = false;
    const RAYS_TELL_OF_THEIR_END: bool = true;

    /// They are logarithms of commonalities.
    fn are_possible(sums: &Sums) -> bool {
        let RaySums { occupied, empty, unknown } = RaySums::of(sums);
        occupied <= 0 && empty <= 0 && unknown <= occupied.min(empty)
    }

    /// Distance across a beam within which its mass is anything.
    fn kernel_radius(model: &EvidenceModel) -> f64 {
        model.ray_model().reach(MIN_MASS)
    }

    fn beams<'v>(
        view: &'v RangeImage,
        _: &AimedAt<'_>,
        model: &'v EvidenceModel,
        _: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
        _: Interrupt,
    ) -> Result<Option<RayBeams<'v>>> {
        Ok(Some(RayBeams { view, model }))
    }

    fn beside_cone(beams: &RayBeams<'_>) -> f64 {
        Self::kernel_radius(beams.model)
    }

    fn may_tell_of(_: &Self::PreparedBeams<'_>, _: &Vec3, _: f64) -> bool {
        true
    }

    fn gather(beams: &RayBeams<'_>, offset_scanner: &Vec3, _: &Vec3, sums: &mut Sums) {
        let RayBeams { view, model } = beams;
        let rays = model.ray_model();
        let reach = Self::kernel_radius(model);
        let range = offset_scanner.norm();
        if range <= reach {
            return; // at the scanner itself
        }
        let Some(uv) = view.project(offset_scanner) else { return };
        let radius = (reach / range).asin().tan() * (1.0 + uv[0] * uv[0] + uv[1] * uv[1]) * 1.2;
        for slots in view.slots_in([uv[0] - radius, uv[1] - radius], [uv[0] + radius, uv[1] + radius]) {
            for slot in slots {
                let (beam_range, direction) = (view.ranges[slot], &view.directions[slot]);
                if beam_range.is_infinite() {
                    continue;
                }
                let along = offset_scanner.dot(direction);
                let across_squared = (offset_scanner - direction * along).norm_squared();
                if across_squared > reach * reach {
                    continue;
                }
                let mass = rays.mass_at(along - beam_range, across_squared, beam_range).discounted(model.reliability);
                add_mass(&mass, sums);
            }
        }
    }

    /// Masses have no direction.
    fn turned(sums: &Sums) -> Sums {
        *sums
    }

    fn add_point(touch: &PointTouch, model: &EvidenceModel, sums: &mut Sums) {
        let mass = model.ray_model().dense_point_mass(&touch.point_local, &touch.normal, &touch.sample_local);
        add_mass(&mass.discounted(model.reliability), sums);
    }

    fn read(sums: &Sums, _: &ViewingGeometry, _: &EvidenceModel) -> Option<Statement> {
        Some(Statement::Belief(commonality(sums)))
    }

    fn least_belief_of_seen(_: &EvidenceModel) -> f64 {
        SEEN_BY_RAYS
    }
}

/// Adds one source's mass, unless it says next to nothing.
fn add_mass(mass: &Mass, sums: &mut Sums) {
    if mass.unknown < 1.0 - MIN_MASS {
        sums.add_beam(RaySums::beam(&mass.log_commonality()).parts());
    }
}

/// The commonalities of one station's beams.
fn commonality(sums: &Sums) -> LogCommonality {
    let RaySums { occupied, empty, unknown } = RaySums::of(sums);
    let log = |part: i64| part as f64 / LOGARITHM;
    LogCommonality { occupied: log(occupied), empty: log(empty), unknown: log(unknown) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::RayModel;
    use crate::scan::{Beam, Patch};

    #[test]
    fn equals_pairwise_combination_of_hand_computed_masses() {
        let beams: Vec<Beam> = (0..9)
            .map(|i| Beam { offset: Vec3::new(5.0, f64::from(i % 3) * 0.01, f64::from(i / 3) * 0.01), returned: true })
            .collect();
        let bytes = Patch::encode(0, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap().to_bytes();
        let (header, content) = Patch::beams_of(&bytes).unwrap();
        let view = RangeImage::new(header, &content.beams);
        let model = EvidenceModel::default();
        for query in [Vec3::new(4.998, 0.012, 0.007), Vec3::new(4.95, 0.0, 0.0), Vec3::new(5.02, 0.01, 0.01)] {
            let mut sums = Sums::default();
            Meyer2022::gather(&RayBeams { view: &view, model: &model }, &query, &Vec3::x(), &mut sums);
            let mut want = Mass::VACUOUS;
            for b in &beams {
                let m = RayModel::LASER.mass(&Vec3::zeros(), &b.offset, &query).discounted(model.reliability);
                want = want.combine(&m).unwrap();
            }
            let got = commonality(&sums).mass().unwrap();
            assert!(
                (got.occupied - want.occupied).abs() < 1e-12 && (got.empty - want.empty).abs() < 1e-12,
                "{got:?} {want:?}"
            );
        }
    }
}
