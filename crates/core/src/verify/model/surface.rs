//! The `surface` model: which beams met the built surface near a sample, and how far off.
//!
//! A beam belongs to the samples around one place X of the drawn surface: the foot of its return, walked to from where
//! the beam crosses the surface, or that crossing where no walk leads to the foot (`foot`). Neighbouring surfaces at
//! concave corners, openings and silhouettes then never tell of a face they are not on.

use super::beam_model::BeamModel;
use super::kernel::{BEAMS_IN_KERNEL, KERNEL_SPACINGS, MEAN_WEIGHT, WEIGHT, goes_on, is_within, weight};
use super::outcome::{BeamOutcome, BeamOutcomes, LANES};
use super::parameters::EvidenceModel;
use super::statement::{Statement, StationObservation};
use super::sums::Sums;
use super::surface_sums::{DEVIATION, SurfaceReading, SurfaceSums};
use super::touch::PointTouch;
use super::viewing_geometry::ViewingGeometry;
use crate::geometry::{Aabb, Vec3};
use crate::scan::RangeImage;
use crate::verify::aim::AimedAt;
use crate::{Interrupt, Result};

/// Beams on one surface scatter by this much beyond their noise at the most: plaster, a slope between them, metres.
const ROUGHNESS_M: f64 = 0.005;

/// The model.
#[derive(Debug)]
pub struct Surface;

/// The beams of a view, by what they met.
#[derive(Debug)]
pub struct SurfaceBeams<'v> {
    view: &'v RangeImage,
    met: BeamOutcomes,
    /// Of the steepest admitted incidence.
    min_cos: f64,
}

impl BeamModel for Surface {
    type PreparedBeams<'v> = SurfaceBeams<'v>;

    const CROSSES_SURFACE: bool = true;
    const MEASURES_DEVIATIONS: bool = true;
    const RAYS_TELL_OF_THEIR_END: bool = false;

    /// Weights are positive, and no beam weighs more than 1.
    fn are_possible(sums: &Sums) -> bool {
        let SurfaceSums { hit, squared, through, .. } = SurfaceSums::of(sums);
        hit >= 0 && squared >= 0 && through >= 0 && hit.saturating_add(through) <= i64::from(sums.beams()) << 16
    }

    fn kernel_radius(_: &EvidenceModel) -> f64 {
        0.0
    }

    fn beams<'v>(
        view: &'v RangeImage,
        aimed: &AimedAt<'_>,
        model: &'v EvidenceModel,
        keep: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
        interrupt: Interrupt,
    ) -> Result<Option<SurfaceBeams<'v>>> {
        let met = BeamOutcomes::of(view, aimed, model, keep, interrupt)?;
        Ok(met.map(|met| SurfaceBeams { view, met, min_cos: model.max_incidence.cos() }))
    }

    fn beside_cone(beams: &SurfaceBeams<'_>) -> f64 {
        beams.met.widest
    }

    fn may_tell_of(beams: &SurfaceBeams<'_>, centre_scanner: &Vec3, radius: f64) -> bool {
        let SurfaceBeams { view, met, .. } = beams;
        let ([u0, v0], [u1, v1]) = view.rectangle_around(&Aabb::around(&[*centre_scanner]).expanded(radius).corners());
        let farthest = [u0.abs().max(u1.abs()), v0.abs().max(v1.abs())];
        let kernel = kernel_radius(view.step(), farthest);
        // Beside the image where a part of the ball is beside the scanner.
        !kernel.is_finite()
            || met.slots_in([u0 - kernel, v0 - kernel], [u1 + kernel, v1 + kernel]).any(|s| !s.is_empty())
    }

    fn gather(beams: &SurfaceBeams<'_>, offset_scanner: &Vec3, normal: &Vec3, sums: &mut Sums) {
        let cos = -offset_scanner.dot(normal) / offset_scanner.norm();
        if cos >= beams.min_cos {
            gather(beams, offset_scanner, normal, sums);
        }
    }

    fn turned(sums: &Sums) -> Sums {
        let s = SurfaceSums::of(sums);
        Sums::new(sums.beams(), SurfaceSums { first: s.first.saturating_neg(), ..s }.parts())
    }

    /// The point's own variance widens the scatter.
    fn add_point(touch: &PointTouch, _: &EvidenceModel, sums: &mut Sums) {
        let fixed = |x: f64, unit: f64| (x * unit).round() as i64;
        // No point is less certain than a metre.
        let variance = fixed(touch.variance.min(1.0), DEVIATION * DEVIATION);
        let (w, d) = (fixed(touch.weight, WEIGHT), fixed(touch.deviation, DEVIATION));
        sums.add_beam(SurfaceSums::met(w, d, variance).parts());
    }

    fn read(sums: &Sums, sight: &ViewingGeometry, model: &EvidenceModel) -> Option<Statement> {
        let r = &SurfaceReading::of(sums)?;
        let brightness = brightness(r, sums, model);
        // Sums count towards the scanner; values count along the outward normal.
        let outward = if sight.from_outside { r.deviation } else { -r.deviation };
        Some(Statement::Deviation(StationObservation {
            deviation: (r.hit >= r.through).then_some(outward),
            // The observed scatter, where that is larger than the noise.
            random_variance: (beam_variance(sight, model) / brightness).max(r.variance) / r.effective.max(1.0),
            trust: model.reliability * (1.0 - (-(r.hit + r.through) / brightness).exp()) * unmixed(r, sight, model),
            hit_share: r.hit / (r.hit + r.through),
            has_rays: sight.has_rays,
            independence: independence(sight.step, sight.range, sight.cos, model),
        }))
    }

    fn least_belief_of_seen(model: &EvidenceModel) -> f64 {
        model.question.confidence
    }
}

fn gather(beams: &SurfaceBeams<'_>, offset_scanner: &Vec3, normal: &Vec3, sums: &mut Sums) {
    let SurfaceBeams { view, met, .. } = beams;
    let range_squared = offset_scanner.norm_squared();
    let Some(uv) = view.project(offset_scanner) else { return };
    let (step, radius) = (view.step(), kernel_radius(view.step(), uv));
    let seen = SeenSample32 {
        here: offset_scanner.map(|c| c as f32).into(),
        sight: (offset_scanner / range_squared.sqrt()).map(|c| c as f32).into(),
        per_spacing: (1.0 / (step * step * range_squared)) as f32,
    };
    let normal = normal.map(|c| c as f32);
    let (mut added, mut parts) = (0, SurfaceSums::default());
    for slots in met.slots_in([uv[0] - radius, uv[1] - radius], [uv[0] + radius, uv[1] + radius]) {
        for first in slots.clone().step_by(LANES) {
            let Some(lanes) = met.lanes(first) else { break };
            let (lateral_squared, across_squared) = seen.beside(&lanes);
            for lane in 0..LANES.min(slots.end - first) {
                let (slot, across_squared) = (first + lane, across_squared[lane]);
                if is_within(across_squared) {
                    let [x, y, z] = &seen.here;
                    let v = nalgebra::Vector3::new(lanes[0][lane] - x, lanes[1][lane] - y, lanes[2][lane] - z);
                    let there = nalgebra::Vector3::from(met.normals[slot]);
                    if goes_on(v.dot(&normal).abs(), lateral_squared[lane], there.dot(&normal)) {
                        added += 1;
                        add(met.outcomes[slot], weight(across_squared), &mut parts);
                    }
                }
            }
        }
    }
    sums.add(&Sums::new(added, parts.parts()));
}

/// A sample as a station sees it, in the precision of the places around.
struct SeenSample32 {
    /// From the scanner, metres.
    here: [f32; 3],
    /// Unit direction.
    sight: [f32; 3],
    /// ρ²/s² of a squared distance across the sight line, 1/m².
    per_spacing: f32,
}

impl SeenSample32 {
    /// Squared distances of some places from the sight line, m², and as ρ²/s². All at once: no branch, no call.
    #[inline(always)]
    fn beside(&self, [xs, ys, zs]: &[&[f32; LANES]; 3]) -> ([f32; LANES], [f32; LANES]) {
        let (mut lateral_squared, mut across_squared) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (x, y, z) = (xs[i] - self.here[0], ys[i] - self.here[1], zs[i] - self.here[2]);
            let along = x * self.sight[0] + y * self.sight[1] + z * self.sight[2];
            lateral_squared[i] = (x * x + y * y + z * z - along * along).max(0.0);
            across_squared[i] = lateral_squared[i] * self.per_spacing;
        }
        (lateral_squared, across_squared)
    }
}

/// Radius of the kernel around a place in the image, which stretches away from its centre, by this much at the most.
fn kernel_radius(step: f64, [u, v]: [f64; 2]) -> f64 {
    KERNEL_SPACINGS * step * (1.0 + u * u + v * v) * 1.05
}

#[inline(always)]
fn add(outcome: BeamOutcome, kernel: i64, parts: &mut SurfaceSums) {
    parts.add(match outcome {
        BeamOutcome::Surface { deviation, share } => SurfaceSums::met(shared(kernel, share), i64::from(deviation), 0),
        BeamOutcome::SeenThrough { weight } => SurfaceSums::passed(shared(kernel, weight)),
    });
}

/// A part of a weight in fixed point.
#[inline(always)]
fn shared(weight: i64, share: f32) -> i64 {
    if share == 1.0 { weight } else { (weight as f64 * f64::from(share)).round() as i64 }
}

/// How many samples' worth of independent measurements a station gives one sample, at most 1: samples nearer to each
/// other than the kernel is wide share their beams. `step` in radians, `range` in metres, 0 where they are unknown.
pub fn independence(step: f64, range: f64, cos: f64, model: &EvidenceModel) -> f64 {
    let beam_spacing_squared = (step * range).powi(2) / cos.max(0.05);
    if beam_spacing_squared > 0.0 {
        (model.spacing * model.spacing / (beam_spacing_squared * BEAMS_IN_KERNEL)).min(1.0)
    } else {
        1.0
    }
}

/// Mean share of the beams' weights that their intensities left: dark beams cover a place as well as bright ones.
fn brightness(r: &SurfaceReading, sums: &Sums, model: &EvidenceModel) -> f64 {
    let unweighted = f64::from(sums.beams()) * MEAN_WEIGHT;
    if model.intensity.is_some() { ((r.hit + r.through) / unweighted).clamp(1.0 / 64.0, 1.0) } else { 1.0 }
}

/// Variance of one beam's deviation, from range and angle, m².
fn beam_variance(sight: &ViewingGeometry, model: &EvidenceModel) -> f64 {
    let sin = (1.0 - sight.cos * sight.cos).max(0.0).sqrt();
    (model.sigma_range * sight.cos).powi(2) + (model.sigma_angle * sight.range * sin).powi(2)
}

/// How far the beams around a sample met one surface: where they scatter by more than noise and roughness, some met
/// the edge's other side or what stands before it, and their mean is the place of nothing.
fn unmixed(r: &SurfaceReading, sight: &ViewingGeometry, model: &EvidenceModel) -> f64 {
    let of_one_surface = 9.0 * beam_variance(sight, model) + ROUGHNESS_M * ROUGHNESS_M;
    (of_one_surface / r.variance.max(of_one_surface)).powi(2)
}
