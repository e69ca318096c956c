//! The nearest ones to each of many directions, and the solid angle that is one's own.

use std::f64::consts::PI;

use super::angular_grid::AngularGrid;
use super::cone::Cone;
use crate::geometry::Vec3;

/// So many nearest ones tell the solid angle of a beam.
pub const AROUND: usize = 8;
/// Least part of the disc around a beam that the others fill: it lies at a corner.
const MIN_FILLED: f64 = 0.25;

/// The nearest other directions with their squared distances, nearest first.
pub type Nearest = [(f64, u32); AROUND];

/// Directions, more than [`AROUND`] of them, to be asked for the nearest ones.
pub struct Neighbourhoods<'a> {
    directions: &'a [Vec3],
    /// Their places in the image.
    image: Vec<[f64; 2]>,
    grid: AngularGrid,
    /// Number of the direction in each slot of the grid.
    order: Vec<u32>,
    /// Where the search begins, radians.
    reach: f64,
}

impl<'a> Neighbourhoods<'a> {
    /// Of unit vectors, neighbours `mean` radians apart.
    pub fn of(directions: &'a [Vec3], mean: f64) -> Self {
        let cone = Cone::around(directions);
        let basis = cone.basis();
        let image: Vec<[f64; 2]> = directions.iter().map(|d| cone.image(&basis, d)).collect();
        let (grid, slots) = AngularGrid::sort(&image, mean);
        let mut order = vec![0; slots.len()];
        (0..).zip(slots).for_each(|(i, slot)| order[slot as usize] = i);
        Self { directions, image, grid, order, reach: 2.0 * mean }
    }

    /// The nearest to one of them.
    pub fn nearest(&self, own: usize) -> Nearest {
        let [u, v] = self.image[own];
        let mut reach = self.reach;
        loop {
            // The gnomonic image stretches away from its centre, by this much at the most.
            let r = reach * (1.0 + u * u + v * v) * 1.05;
            let slots = self.grid.slots_in([u - r, v - r], [u + r, v + r]).flatten();
            let distance = |i: u32| ((self.directions[i as usize] - self.directions[own]).norm_squared(), i);
            let others = slots.map(|slot| self.order[slot]).filter(|i| *i as usize != own).map(distance);
            // None is farther than the sphere is wide.
            let mut found: Vec<(f64, u32)> = others.filter(|(d, _)| *d <= reach * reach || reach > 2.0).collect();
            if found.len() >= AROUND {
                let nearer = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
                found.select_nth_unstable_by(AROUND - 1, nearer);
                let mut nearest: Nearest = std::array::from_fn(|k| found[k]);
                nearest.sort_unstable_by(nearer);
                return nearest;
            }
            reach *= 1.5;
        }
    }

    /// The solid angle of a direction, given the nearest ones: the disc that they fill, shared out.
    ///
    /// Where directions end, they fill a part of the disc only, and their centroid lies off its middle: by 4/(3π) of the
    /// radius where it is halved. What chance does to the centroid of so many is taken off.
    pub fn solid_angle(&self, own: usize, nearest: &Nearest) -> f64 {
        let radius_squared = nearest[AROUND - 1].0;
        let sum: Vec3 = nearest.iter().map(|n| self.directions[n.1 as usize] - self.directions[own]).sum();
        let off_squared = (sum / AROUND as f64).norm_squared() / radius_squared.max(f64::MIN_POSITIVE);
        let halved = (4.0 / (3.0 * PI)).powi(2);
        let filled = 1.0 - 0.5 * (off_squared - 0.5 / AROUND as f64).max(0.0) / halved;
        PI * radius_squared / AROUND as f64 * filled.max(MIN_FILLED)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_are_found(
            places in prop::collection::vec((-0.9..0.9f64, -0.9..0.9f64, 0i32..3), 10..200),
            mean in 1e-4..0.3f64,
        ) {
            // Three densities.
            let direction = |&(u, v, k): &(f64, f64, i32)| {
                let scale = 0.1f64.powi(k);
                Vec3::new(1.0, u * scale, v * scale).normalize()
            };
            let directions: Vec<Vec3> = places.iter().map(direction).collect();
            let all = Neighbourhoods::of(&directions, mean);
            for own in 0..directions.len() {
                let distance = |(i, d): (u32, &Vec3)| ((d - directions[own]).norm_squared(), i);
                let others = (0..).zip(&directions).filter(|(i, _)| *i as usize != own);
                let mut expected: Vec<(f64, u32)> = others.map(distance).collect();
                expected.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                prop_assert_eq!(&all.nearest(own)[..], &expected[..AROUND]);
            }
        }
    }
}
