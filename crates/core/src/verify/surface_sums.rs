//! The `surface` model's sums: which beams met the built surface near a sample, and how far off.
//!
//! A beam belongs to the samples around one place X of the drawn surface: the foot of its return, walked to from where
//! the beam crosses the surface, or that crossing where no walk leads to the foot (`foot`). Neighbouring surfaces at
//! concave corners, openings and silhouettes then never speak for a face they are not on. Its weight at a sample Q is
//! 2^(−ρ²/s²), with ρ the distance of X from the sight line to Q and s the local spacing of the beams: ln 2/s² of the
//! source, already stretched along a slope.

use std::sync::LazyLock;

use super::encounter::{DEVIATION, Encounters, Seen, WEIGHT};
use super::sums::Sums;
use crate::geometry::{BLUNT_EDGE_COS, Vec3};
use crate::scan::View;

/// Beyond this many spacings the kernel (1/16 there) is cut off.
pub(super) const KERNEL_SPACINGS: f64 = 2.0;
/// Effective number of beams (Σw)²/Σw² of a full kernel: 2π/ln 2.
pub(super) const BEAMS_IN_KERNEL: f64 = 9.064_720_283_654_387;
/// Mean weight of the beams within the kernel: (1 − 2⁻⁴)/(4 ln 2).
pub(super) const MEAN_WEIGHT: f64 = 0.338_132_187_4;
/// A crossing may lie this far off the sample's plane, relative to its distance across the sight line: a
/// neighbouring facet of a curve, whose normal may turn by 30°.
const MAX_RISE: f64 = 0.35;

/// The kernel 2^(−ρ²/s²) by ρ²/s², in fixed point; the steps are a thousandth of its height.
static KERNEL: LazyLock<[u16; KERNEL_STEPS + 1]> = LazyLock::new(|| {
    std::array::from_fn(|i| ((-(i as f64) / STEPS_A_UNIT).exp2() * WEIGHT).round().min(65_535.0) as u16)
});
const STEPS_A_UNIT: f64 = 1024.0;
const KERNEL_STEPS: usize = 4096;

/// Adds to `sums` what the beams around the sight line to a sample saw. `offset` leads from the scanner to it.
pub fn gather(view: &View, encounters: &Encounters, offset: &Vec3, normal: &Vec3, sums: &mut Sums) {
    let range_squared = offset.norm_squared();
    let Some(uv) = view.project(offset) else { return };
    let step = f64::from(view.header.step);
    // The gnomonic image stretches away from its centre, by this much at the most.
    let radius = KERNEL_SPACINGS * step * (1.0 + uv[0] * uv[0] + uv[1] * uv[1]) * 1.05;
    let here = offset.map(|c| c as f32);
    let sight = (offset / range_squared.sqrt()).map(|c| c as f32);
    let normal = normal.map(|c| c as f32);
    let per_spacing = (1.0 / (step * step * range_squared)) as f32;
    let [xs, ys, zs] = &encounters.places;
    for slots in encounters.slots_in([uv[0] - radius, uv[1] - radius], [uv[0] + radius, uv[1] + radius]) {
        for slot in slots {
            let v = nalgebra::Vector3::new(xs[slot] - here.x, ys[slot] - here.y, zs[slot] - here.z);
            let along = v.dot(&sight);
            let lateral_squared = (v.norm_squared() - along * along).max(0.0);
            let across = lateral_squared * per_spacing;
            if across < (KERNEL_SPACINGS * KERNEL_SPACINGS) as f32 {
                let there = nalgebra::Vector3::from(encounters.normals[slot]);
                if goes_on(v.dot(&normal).abs(), lateral_squared, there.dot(&normal)) {
                    let weight = KERNEL[(across * STEPS_A_UNIT as f32 + 0.5) as usize];
                    add(encounters.seen[slot], i64::from(weight), sums);
                }
            }
        }
    }
}

/// Whether a place `rise` metres off the sample's plane lies on the sample's own surface, not on a parallel one
/// behind it, and where their normals have this scalar product.
fn goes_on(rise: f32, lateral_squared: f32, turn_cos: f32) -> bool {
    turn_cos >= BLUNT_EDGE_COS as f32
        && (rise <= 0.002 || rise * rise <= (MAX_RISE * MAX_RISE) as f32 * lateral_squared)
}

fn add(seen: Seen, weight: i64, sums: &mut Sums) {
    match seen {
        Seen::Surface(d, share) => add_surface(shared(weight, share), i64::from(d), 0, sums),
        Seen::Through(share) => {
            let [.., through] = &mut sums.parts;
            *through = through.saturating_add(shared(weight, share));
            sums.beams = sums.beams.saturating_add(1);
        }
    }
}

/// Whether a crossing at `v` from the sample lies on the sample's own surface, not on a parallel one behind it.
pub(super) fn same_surface(v: &Vec3, lateral: f64, normal_there: &Vec3, normal_here: &Vec3) -> bool {
    let rise = v.dot(normal_here).abs();
    normal_there.dot(normal_here) >= BLUNT_EDGE_COS && (rise <= 0.002 || rise <= MAX_RISE * lateral)
}

fn shared(weight: i64, share: f32) -> i64 {
    if share == 1.0 { weight } else { (weight as f64 * f64::from(share)).round() as i64 }
}

/// A surface at `d` with a variance of its own, both in fixed point, and so is the weight.
fn add_surface(w: i64, d: i64, variance: i64, sums: &mut Sums) {
    let [hit, squared, first, second, _] = &mut sums.parts;
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
    let variance = fixed(variance.min(1.0), DEVIATION * DEVIATION);
    add_surface(fixed(weight, WEIGHT), fixed(deviation, DEVIATION), variance, sums);
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

    #[test]
    fn sums_give_weighted_moments() {
        let mut sums = Sums::default();
        let observations = [(0.010, 1.0), (0.012, 0.5), (-0.003, 0.25)];
        for (d, w) in observations {
            add(Seen::Surface((d * DEVIATION) as i32, 1.0), (w * WEIGHT) as i64, &mut sums);
        }
        add(Seen::Through(1.0), (0.5 * WEIGHT) as i64, &mut sums);
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
