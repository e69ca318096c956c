//! The `surface` model's sums: which beams met the built surface near a sample, and how far off.
//!
//! A beam belongs to the samples around the place X where it would cross the drawn face (not around the foot of
//! its return): neighbouring surfaces at concave corners, openings and silhouettes then never speak for a face
//! they are not on. Its weight at a sample Q is 2^(−ρ²/s²), with ρ the distance of X from the sight line to Q
//! and s the local spacing of the beams: ln 2/s² of the source, already stretched along a slope.

use super::crossing::Crossings;
use super::model::EvidenceModel;
use super::sums::Sums;
use crate::geometry::Vec3;
use crate::scan::View;

/// Fixed-point unit of a weight.
const WEIGHT: f64 = 65_536.0;
/// Fixed-point unit of a deviation: 1/131072 m, 7.6 µm.
const DEVIATION: f64 = 131_072.0;
/// Beyond this many spacings the kernel (1/16 there) is cut off.
pub(super) const KERNEL_SPACINGS: f64 = 2.0;
/// Effective number of beams (Σw)²/Σw² of a full kernel: 2π/ln 2.
pub(super) const BEAMS_IN_KERNEL: f64 = 9.064_720_283_654_387;
/// A crossing may lie this far off the sample's plane, relative to its distance across the sight line: a
/// neighbouring facet of a curve.
const MAX_RISE: f64 = 0.35;
/// … and its normal turn by this much (cos 30°).
const MIN_TURN_COS: f64 = 0.866;

/// What one beam saw where it would cross the solid.
#[derive(Debug, Clone, Copy)]
pub struct Encounter {
    /// Crossing relative to the scanner, metres.
    crossing: Vec3,
    normal: Vec3,
    seen: Seen,
}

#[derive(Debug, Clone, Copy)]
enum Seen {
    /// Nothing to say: passed by, stopped well in front, or too grazing.
    Nothing,
    /// A surface this far (fixed-point) in front of the face.
    Surface(i32),
    /// Empty space, with this weight.
    Through(f64),
}

/// Classifies every beam of the view against its crossing.
pub fn encounters(view: &View, crossings: &Crossings, model: &EvidenceModel) -> Vec<Encounter> {
    let (in_front, behind) = (model.band_in_front(), model.band_behind());
    let min_cos = model.max_incidence.cos();
    (0..view.len())
        .map(|slot| {
            let (t, normal, range) = (crossings.distance[slot], crossings.normal[slot], view.ranges[slot]);
            let cos = -view.directions[slot].dot(&normal);
            let seen = if !t.is_finite() || cos < min_cos {
                Seen::Nothing
            } else if range.is_infinite() {
                if t <= model.no_return_range { Seen::Through(model.no_return_weight) } else { Seen::Nothing }
            } else {
                let deviation = (t - range) * cos;
                if deviation > in_front {
                    Seen::Nothing
                } else if deviation >= -behind {
                    Seen::Surface((deviation * DEVIATION).round() as i32)
                } else {
                    Seen::Through(1.0)
                }
            };
            let crossing = if t.is_finite() { view.directions[slot] * t } else { Vec3::zeros() };
            Encounter { crossing, normal, seen }
        })
        .collect()
}

/// Adds to `sums` what the beams around the sight line to a sample saw. `offset` leads from the scanner to it.
pub fn gather(view: &View, encounters: &[Encounter], offset: &Vec3, normal: &Vec3, sums: &mut Sums) {
    let range = offset.norm();
    let Some(uv) = view.project(offset) else { return };
    let step = f64::from(view.header.step);
    // The gnomonic image stretches away from its centre, by this much at the most.
    let radius = KERNEL_SPACINGS * step * (1.0 + uv[0] * uv[0] + uv[1] * uv[1]) * 1.05;
    let sight = offset / range;
    let per_spacing = 1.0 / (step * range).powi(2);
    for slots in view.slots_in([uv[0] - radius, uv[1] - radius], [uv[0] + radius, uv[1] + radius]) {
        for e in &encounters[slots] {
            if matches!(e.seen, Seen::Nothing) {
                continue;
            }
            let v = e.crossing - offset;
            let along = v.dot(&sight);
            let lateral_squared = (v.norm_squared() - along * along).max(0.0);
            let across = lateral_squared * per_spacing;
            let near = across <= KERNEL_SPACINGS * KERNEL_SPACINGS;
            if !near || !same_surface(&v, lateral_squared.sqrt(), &e.normal, normal) {
                continue;
            }
            e.add((-across).exp2(), sums);
        }
    }
}

/// Whether a crossing at `v` from the sample lies on the sample's own surface, not on a parallel one behind it.
pub(super) fn same_surface(v: &Vec3, lateral: f64, normal_there: &Vec3, normal_here: &Vec3) -> bool {
    let rise = v.dot(normal_here).abs();
    normal_there.dot(normal_here) >= MIN_TURN_COS && (rise <= 0.002 || rise <= MAX_RISE * lateral)
}

impl Encounter {
    fn add(&self, weight: f64, sums: &mut Sums) {
        let [.., through] = &mut sums.parts;
        match self.seen {
            Seen::Nothing => return,
            Seen::Surface(d) => return add_surface(weight, i64::from(d), 0, sums),
            Seen::Through(share) => *through = through.saturating_add((weight * share * WEIGHT).round() as i64),
        }
        sums.beams = sums.beams.saturating_add(1);
    }
}

fn add_surface(weight: f64, d: i64, variance: i64, sums: &mut Sums) {
    let [hit, squared, first, second, _] = &mut sums.parts;
    let w = (weight * WEIGHT).round() as i64;
    *hit = hit.saturating_add(w);
    *squared = squared.saturating_add((w * w) >> 16);
    *first = first.saturating_add(w * d);
    *second = second.saturating_add(w * (d * d + variance));
    sums.beams = sums.beams.saturating_add(1);
}

/// The same sums, their deviations counted the other way.
pub fn turned(sums: &Sums) -> Sums {
    let [hit, squared, first, second, through] = sums.parts;
    Sums { parts: [hit, squared, first.saturating_neg(), second, through], ..*sums }
}

/// Adds a point met `deviation` metres in front of the face, with a variance (m²) of its own: it widens the scatter.
pub fn add_point(weight: f64, deviation: f64, variance: f64, sums: &mut Sums) {
    let fixed = |x: f64, unit: f64| (x * unit).round() as i64;
    // No point is less certain than a metre.
    add_surface(weight, fixed(deviation, DEVIATION), fixed(variance.min(1.0), DEVIATION * DEVIATION), sums);
}

impl Encounter {
    /// Only what a ray pierced, at a share of its weight: where the ray's end speaks for itself.
    pub fn pierced_alone(&mut self, share: f64) {
        self.seen = match self.seen {
            Seen::Through(weight) => Seen::Through(weight * share),
            _ => Seen::Nothing,
        };
    }
}

/// What the sums of one station say.
#[derive(Debug, Clone, Copy)]
pub struct SurfaceReading {
    /// Σw over beams that met a surface within the band.
    pub hit: f64,
    /// Σw over beams that pierced the face.
    pub through: f64,
    /// Weighted mean deviation, metres, + towards the scanner.
    pub deviation: f64,
    /// Weighted variance of the deviations, m².
    pub variance: f64,
    /// Effective number of beams (Σw)²/Σw².
    pub effective: f64,
}

impl SurfaceReading {
    /// `None` when no beam spoke.
    pub fn of(sums: &Sums) -> Option<Self> {
        let [hit, squared, first, second, through] = sums.parts.map(|p| p as f64);
        if hit + through <= 0.0 {
            return None;
        }
        let (mut deviation, mut variance, mut effective) = (0.0, 0.0, 0.0);
        if hit > 0.0 {
            deviation = first / hit;
            variance = (second / hit - deviation * deviation).max(0.0) / (DEVIATION * DEVIATION);
            deviation /= DEVIATION;
            effective = hit * hit / (squared * WEIGHT).max(1.0);
        }
        Some(Self { hit: hit / WEIGHT, through: through / WEIGHT, deviation, variance, effective })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encounter(seen: Seen) -> Encounter {
        Encounter { crossing: Vec3::zeros(), normal: Vec3::x(), seen }
    }

    #[test]
    fn sums_give_weighted_moments() {
        let mut sums = Sums::default();
        let observations = [(0.010, 1.0), (0.012, 0.5), (-0.003, 0.25)];
        for (d, w) in observations {
            encounter(Seen::Surface((d * DEVIATION) as i32)).add(w, &mut sums);
        }
        encounter(Seen::Through(1.0)).add(0.5, &mut sums);
        let r = SurfaceReading::of(&sums).unwrap();
        let total: f64 = observations.iter().map(|o| o.1).sum();
        let mean = observations.iter().map(|o| o.0 * o.1).sum::<f64>() / total;
        let variance = observations.iter().map(|o| (o.0 - mean).powi(2) * o.1).sum::<f64>() / total;
        let effective = total * total / observations.iter().map(|o| o.1 * o.1).sum::<f64>();
        assert!((r.hit - total).abs() < 1e-4 && (r.through - 0.5).abs() < 1e-4);
        assert!((r.deviation - mean).abs() < 1e-5, "{}", r.deviation);
        assert!((r.variance - variance).abs() < 1e-6 && (r.effective - effective).abs() < 1e-2);
        assert_eq!(sums.beams, 4);
        assert!(SurfaceReading::of(&Sums::default()).is_none());
    }
}
