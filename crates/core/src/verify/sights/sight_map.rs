//! Where the beams of one station ended, coarsely.

use super::horizon::Horizon;
use super::sphere_grid::SphereGrid;
use crate::geometry::Vec3;

/// One beam a cell, the one nearest to its middle, so that the order in which beams come does not matter.
#[derive(Debug)]
pub struct SightMap {
    /// Where its beams start, world metres.
    pub origin_world: Vec3,
    grid: SphereGrid,
    cells: Vec<Option<Sight>>,
    horizon: Horizon,
}

/// Where a beam ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// From where beams start, metres; infinite in a direction from which nothing returned.
    pub met_scanner: [f32; 3],
    /// Squared distance from the cell's middle, in cells.
    off: f32,
}

impl Sight {
    /// Where the beam met something, scanner metres.
    pub fn met(&self) -> Option<Vec3> {
        self.met_scanner[0].is_finite().then(|| Vec3::from(self.met_scanner.map(f64::from)))
    }
}

impl SightMap {
    /// Height of a row of cells, and width of a cell, radians: 10 cm at 10 m.
    pub const CELL: f64 = 0.01;

    /// Of a station at `origin_world`, metres, that looked nowhere yet.
    pub fn new(origin_world: Vec3) -> Self {
        let grid = SphereGrid::new(Self::CELL);
        Self { origin_world, cells: vec![None; grid.len()], grid, horizon: Horizon::new() }
    }

    /// Of how many neighbouring beams `step` radians apart one suffices.
    pub fn stride(step: f64) -> usize {
        ((0.4 * SightMap::CELL / step).powi(2) as usize).max(1)
    }

    /// Remembers a beam: its unit direction and its range, metres, infinite without return.
    pub fn add(&mut self, direction: &Vec3, range: f64) {
        let (cell, off) = self.grid.place(direction);
        self.horizon.add(direction, range);
        let met = if range.is_finite() { direction * range } else { Vec3::repeat(f64::INFINITY) };
        let sight = Sight { met_scanner: met.map(|c| c as f32).into(), off };
        let order = |s: &Sight| (s.off.to_bits(), s.met_scanner.map(f32::to_bits));
        if self.cells[cell].is_none_or(|known| order(&sight) < order(&known)) {
            self.cells[cell] = Some(sight);
        }
    }

    /// The beam sent nearest to a direction, if one was sent near it.
    pub fn towards(&self, direction: &Vec3) -> Option<Sight> {
        let here = |d: &Vec3| self.cells[self.grid.place(d).0];
        let across = Vec3::z().cross(direction).try_normalize(1e-6).unwrap_or_else(Vec3::x);
        let up = direction.cross(&across);
        let beside = [across, -across, up, -up].map(|side| (direction + side * SightMap::CELL).normalize());
        here(direction).or_else(|| beside.iter().find_map(here))
    }

    /// Whether a beam towards a ball (world metres) may have got as near to it as `within` metres.
    pub fn may_meet(&self, centre_world: &Vec3, radius: f64, within: f64) -> bool {
        // A direction finds the beam of a neighbouring cell, too.
        self.horizon.may_meet(&(centre_world - self.origin_world), radius, 2.5 * Self::CELL, within)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::seq::SliceRandom;
    use rand::{Rng, SeedableRng};

    /// Whatever the order of the beams, a direction finds one that was sent near it.
    #[test]
    fn a_direction_finds_a_beam_near_it() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(4);
        let mut beams: Vec<(Vec3, f64)> = Vec::new();
        while beams.len() < 400_000 {
            let d = Vec3::from([0; 3].map(|_| rng.random_range(-1.0..1.0)));
            if (0.1..1.0).contains(&d.norm()) && d.z < 0.9 * d.norm() {
                beams.push((d.normalize(), rng.random_range(1.0..9.0)));
            }
        }
        let map = |beams: &[(Vec3, f64)]| {
            let mut map = SightMap::new(Vec3::zeros());
            beams.iter().for_each(|(d, r)| map.add(d, *r));
            map
        };
        let first = map(&beams);
        beams.shuffle(&mut rng);
        assert_eq!(first.cells, map(&beams).cells);
        for (d, _) in beams.iter().take(20_000) {
            let found = first.towards(d).unwrap().met().unwrap();
            assert!(found.normalize().dot(d) > (2.0 * SightMap::CELL).cos(), "{d} {found}");
        }
        assert_eq!(first.towards(&Vec3::z()), None);
        let mut nothing = SightMap::new(Vec3::zeros());
        nothing.add(&Vec3::x(), f64::INFINITY);
        assert_eq!(nothing.towards(&Vec3::x()).unwrap().met(), None);
    }
}
