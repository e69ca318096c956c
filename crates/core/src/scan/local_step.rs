//! How far neighbouring beams are apart around each of them, where they form no grid.
//!
//! A scanner's beams form a grid: the two nearest to each lie on its two sides, equally far. Where beams were chosen by
//! place (a scan thinned by cubes), near surfaces keep fewer of them per angle than far ones, and a patch's mean is the
//! spacing of no place in it. There every beam has a step of its own: the square root of the solid angle that it stands
//! for.

use super::beam::Beam;
use super::neighbourhoods::{AROUND, Nearest, Neighbourhoods};
use crate::geometry::Vec3;

/// Beams of which it is asked how far the others are.
const PROBES: usize = 64;
/// Beams form a grid when the nearest other one lies at this part of the distance to the second nearest, or more: the
/// lower quartile. On a grid it is 1, less what noise and losses take; at random places 0.5, after thinning 0.1 to 0.5.
const MIN_GRID_RATIO: f64 = 0.8;
/// Below, but not below this, beams of one density form a grid, too: one with losses, or a dense one with noisy angles.
const MIN_LOSSY_RATIO: f64 = 0.45;
/// Beams are of one density when the upper decile of the steps that they show is at most so many times the lower.
const MAX_EVEN_RATIO: f64 = 1.3;
/// Around the pole of a scanner its lines run together, and noise hides the grid. What tells it is the order of the
/// scan: this share of the beams lie equally far from the one before,
const MIN_IN_LINE: f64 = 0.6;
/// up to this part of the distance,
const MAX_OFF_LINE: f64 = 0.15;
/// which is at least so many times that to the nearest one.
const MIN_POLE_RATIO: f64 = 2.5;
/// Steps, radians: from hardly any,
const MIN_STEP: f64 = 1e-6;
/// to a whole patch.
const MAX_STEP: f64 = 1.0;

/// The step of each beam, radians; `None` where they form a grid, of which one step tells all, or are too few to tell.
/// `mean` is their mean step.
pub fn steps_off_grid(beams: &[Beam], mean: f64) -> Option<Vec<f32>> {
    let directions = directions(beams);
    if directions.len() <= AROUND {
        return None;
    }
    let all = Neighbourhoods::of(&directions, mean);
    if is_grid(&directions, &all) {
        return None;
    }
    let around: Vec<Nearest> = (0..directions.len()).map(|i| all.nearest(i)).collect();
    let own: Vec<f64> = around.iter().enumerate().map(|(i, nearest)| all.solid_angle(i, nearest)).collect();
    Some(of_beams(beams, around.iter().enumerate().map(|(i, nearest)| shared(&own, i, nearest))))
}

/// The step of each beam that stands for so much, steradians, radians. `mean` is their mean step.
pub fn steps_of(beams: &[Beam], stands_for: &[f64], mean: f64) -> Vec<f32> {
    let directions = directions(beams);
    let pointing = beams.iter().zip(stands_for).filter(|(b, _)| points(b));
    let own: Vec<f64> = pointing.map(|(_, angle)| *angle).collect();
    if directions.len() <= AROUND {
        let shared = own.iter().sum::<f64>() / own.len().max(1) as f64;
        return of_beams(beams, own.iter().map(|_| shared));
    }
    let all = Neighbourhoods::of(&directions, mean);
    of_beams(beams, (0..own.len()).map(|i| shared(&own, i, &all.nearest(i))))
}

/// The mean solid angle of a beam and those nearest to it: chance puts some near each other, and others apart.
fn shared(solid_angles: &[f64], own: usize, nearest: &Nearest) -> f64 {
    let others: f64 = nearest.iter().map(|n| solid_angles[n.1 as usize]).sum();
    (solid_angles[own] + others) / (AROUND + 1) as f64
}

/// Whether a beam points anywhere.
fn points(beam: &Beam) -> bool {
    beam.offset.norm() > 1e-12
}

fn directions(beams: &[Beam]) -> Vec<Vec3> {
    beams.iter().filter(|b| points(b)).map(|b| b.offset.normalize()).collect()
}

/// The steps of all beams, by the solid angles of those that point somewhere; the others tell nothing with any step.
fn of_beams(beams: &[Beam], mut solid_angles: impl Iterator<Item = f64>) -> Vec<f32> {
    let step = |angle: f64| angle.sqrt().clamp(MIN_STEP, MAX_STEP) as f32;
    let own = |b: &Beam| if points(b) { solid_angles.next().map(step) } else { None };
    beams.iter().map(own).map(|step| step.unwrap_or(MIN_STEP as f32)).collect()
}

fn is_grid(directions: &[Vec3], all: &Neighbourhoods) -> bool {
    let probes = PROBES.min(directions.len());
    let probe = |p: usize| p * directions.len() / probes;
    let around: Vec<(usize, Nearest)> = (0..probes).map(probe).map(|i| (i, all.nearest(i))).collect();
    let ratio = quantile(around.iter().map(|(_, nearest)| nearest_ratio(nearest)), 0.25);
    if ratio >= MIN_GRID_RATIO || is_pole(directions, &around) {
        return true;
    }
    let step = |part| quantile(around.iter().map(|(i, nearest)| all.solid_angle(*i, nearest).sqrt()), part);
    ratio >= MIN_LOSSY_RATIO && step(0.9) <= MAX_EVEN_RATIO * step(0.1)
}

/// Distance to the nearest other beam, as a part of that to the second nearest; 1 where all are in one place.
fn nearest_ratio(nearest: &Nearest) -> f64 {
    let [first, second] = [nearest[0].0, nearest[1].0];
    if second > 0.0 { (first / second).sqrt() } else { 1.0 }
}

/// Whether most beams follow each other in equal steps that are much longer than the way to the nearest one.
fn is_pole(directions: &[Vec3], around: &[(usize, Nearest)]) -> bool {
    let gaps: Vec<f64> = directions.windows(2).map(|d| (d[1] - d[0]).norm()).collect();
    let usual = quantile(gaps.iter().copied(), 0.5);
    let in_line = gaps.iter().filter(|gap| (**gap - usual).abs() <= MAX_OFF_LINE * usual).count();
    let apart = quantile(around.iter().map(|(_, nearest)| nearest[0].0.sqrt()), 0.5);
    in_line as f64 >= MIN_IN_LINE * gaps.len() as f64 && usual >= MIN_POLE_RATIO * apart
}

fn quantile(values: impl Iterator<Item = f64>, part: f64) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let k = (part * (values.len() - 1) as f64) as usize;
    *values.select_nth_unstable_by(k, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn beams(directions: impl Iterator<Item = Vec3>) -> Vec<Beam> {
        directions.map(|offset| Beam { offset, returned: true }).collect()
    }

    /// 64 × 64 beams in equal steps of azimuth and elevation, less a share of lost ones, angles with noise in steps.
    fn scanned(low: f64, step: f64, lost: f64, noise: f64) -> Vec<Beam> {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut out = Vec::new();
        for i in 0..64 * 64 {
            let mut angle = |k: i32| (f64::from(k) + noise * rng.random_range(-1.0..1.0)) * step;
            let (azimuth, elevation) = (angle(i / 64), low + angle(i % 64));
            let direction =
                Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin());
            if !rng.random_bool(lost) {
                out.push(direction * rng.random_range(2.0..9.0));
            }
        }
        beams(out.into_iter())
    }

    #[test]
    fn a_scanners_grid_has_one_step() {
        for low in [-1.0, 0.0, 0.8, 1.3] {
            for (step, lost, noise) in [(4e-3, 0.0, 0.0), (2e-3, 0.1, 0.02), (6e-4, 0.02, 0.1), (3e-4, 0.0, 0.2)] {
                let beams = scanned(low, step, lost, noise);
                assert!(steps_off_grid(&beams, step).is_none(), "{low} {step} {lost} {noise}");
            }
        }
        let sheared =
            |i: i32| Vec3::new(1.0, f64::from(i % 50) * 2e-3 + f64::from(i / 50) * 7e-4, f64::from(i / 50) * 2e-3);
        assert!(steps_off_grid(&beams((0..2500).map(sheared)), 2e-3).is_none());
        assert!(steps_off_grid(&beams((0..4096).map(|_| Vec3::x())), 1e-3).is_none(), "all along one line");
        assert!(steps_off_grid(&beams((0..8).map(|i| Vec3::new(1.0, f64::from(i * i), 0.0))), 1e-3).is_none(), "few");
    }

    /// A wall along the line of sight, one beam at a random place of every square; and the solid angles of the squares.
    fn wall(side: f64) -> (Vec<Beam>, Vec<f64>) {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut along = |i: i32| side * (f64::from(i) + rng.random_range(0.1..0.9));
        let wall = beams((0..80 * 40).map(|i| Vec3::new(1.0 + along(i % 80), 2.0, along(i / 80) - 1.0)));
        let solid_angle = |b: &Beam| side * side * 2.0 / b.offset.norm().powi(3);
        let solid_angles = wall.iter().map(solid_angle).collect();
        (wall, solid_angles)
    }

    /// Both ways to a step find the root of the solid angle, to the border of the wall.
    #[test]
    fn a_step_is_the_root_of_a_solid_angle() {
        let (wall, solid_angles) = wall(0.05);
        let found = steps_off_grid(&wall, 0.02).unwrap();
        let shared = steps_of(&wall, &solid_angles, 0.02);
        for steps in [&found, &shared] {
            let ratios = steps.iter().zip(&solid_angles).map(|(step, angle)| f64::from(*step) / angle.sqrt());
            let mut ratios: Vec<f64> = ratios.collect();
            ratios.sort_by(f64::total_cmp);
            let at = |part: f64| ratios[(part * (ratios.len() - 1) as f64) as usize];
            assert!(
                (at(0.5) - 1.0).abs() < 0.05 && at(0.02) > 0.75 && at(0.98) < 1.33,
                "{} {} {}",
                at(0.02),
                at(0.5),
                at(0.98)
            );
        }
        let covered = |steps: &[f32]| steps.iter().map(|s| f64::from(*s).powi(2)).sum::<f64>();
        let all: f64 = solid_angles.iter().sum();
        assert!((covered(&found) / all - 1.0).abs() < 0.1, "{}", covered(&found) / all);
        assert!((covered(&shared) / all - 1.0).abs() < 0.01, "{}", covered(&shared) / all);
    }

    #[test]
    fn few_beams_share_what_they_stand_for() {
        let few = beams([Vec3::x(), Vec3::zeros(), Vec3::new(1.0, 0.1, 0.0)].into_iter());
        let steps = steps_of(&few, &[1e-4, 1.0, 3e-4], 0.01);
        assert!([0, 2].iter().all(|i| (f64::from(steps[*i]) - 2e-4f64.sqrt()).abs() < 1e-8), "{steps:?}");
    }
}
