//! All beams of a station.

use std::f64::consts::{PI, TAU};

use asbuilt_core::geometry::Vec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;

use crate::optics::{Echo, echoes};
use crate::receiver::Receiver;
use crate::station::Station;
use crate::world::View;

/// Rays around the one in the middle of a footprint.
const RING: usize = 3;
/// Their distance from it, in halves of the divergence, and the part of the power that each of the four carries: the
/// second moment of a Gaussian beam whose 1/e² diameter is the divergence.
const RING_RADIUS: f64 = 0.816;
const RING_POWER: f64 = 0.25;

/// A scanner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scanner {
    /// Angle between neighbouring beams, radians.
    pub step: f64,
    /// Full divergence of a beam (1/e²), radians.
    pub divergence: f64,
    /// Standard deviation of each of the two angles, radians.
    pub sigma_angle: f64,
    /// Longest range, metres.
    pub max_range: f64,
    /// Lowest elevation, radians: below it the tripod stands in the way.
    pub min_elevation: f64,
    /// From light to ranges.
    pub receiver: Receiver,
}

/// A beam as it was registered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// From the registered place to the return, metres, along the world's axes; without a return a unit direction.
    pub offset: Vec3,
    /// Whether anything came back.
    pub returned: bool,
    /// From whose surface, which no real scanner tells; it is for those who know the truth.
    pub owner: Option<u32>,
}

/// What a station measured, registered.
#[derive(Debug, Clone, PartialEq)]
pub struct Scan {
    /// Where the scanner is believed to stand, world metres.
    pub place: Vec3,
    /// Its beams, column by column.
    pub shots: Vec<Shot>,
}

impl Scanner {
    /// Columns and rows of a scan.
    pub fn grid(&self) -> (u32, u32) {
        ((TAU / self.step).floor() as u32, ((PI / 2.0 - self.min_elevation) / self.step).floor() as u32)
    }

    /// Scans from a station. The same seed gives the same scan, with any number of threads.
    pub fn scan(&self, view: &View, station: &Station, seed: u64) -> Scan {
        let (columns, rows) = self.grid();
        let shots = (0..columns)
            .into_par_iter()
            .flat_map_iter(|column| {
                let mut rng = ChaCha8Rng::seed_from_u64(seed);
                rng.set_stream(u64::from(column) + 1);
                let mut met = Vec::new();
                (0..rows).map(|row| self.shoot(view, station, (column, row), &mut met, &mut rng)).collect::<Vec<_>>()
            })
            .collect();
        Scan { place: station.registered_place, shots }
    }

    fn shoot(
        &self,
        view: &View,
        station: &Station,
        (column, row): (u32, u32),
        met: &mut Vec<Echo>,
        rng: &mut ChaCha8Rng,
    ) -> Shot {
        let azimuth = (f64::from(column) + 0.5) * self.step;
        let elevation = self.min_elevation + (f64::from(row) + 0.5) * self.step;
        met.clear();
        self.footprint(view, station, &direction(azimuth, elevation), rng.random_range(0.0..TAU), met);
        let echo = self.receiver.range(met, rng);
        let mut off = || self.sigma_angle * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng);
        let read = station.registered_rotation * direction(azimuth + off(), elevation + off());
        let range = echo.map_or(1.0, |e| e.range);
        Shot { offset: read * range, returned: echo.is_some(), owner: echo.map(|e| e.owner) }
    }

    /// The echoes of all rays of a beam; `phase` turns the ring.
    fn footprint(&self, view: &View, station: &Station, middle: &Vec3, phase: f64, out: &mut Vec<Echo>) {
        let side = Vec3::new(-middle.y, middle.x, 0.0).try_normalize(1e-9).unwrap_or_else(Vec3::x);
        let up = middle.cross(&side);
        let radius = RING_RADIUS * 0.5 * self.divergence;
        let ring = (0..RING).map(|k| {
            let angle = phase + TAU * k as f64 / RING as f64;
            (middle + (side * angle.cos() + up * angle.sin()) * radius).normalize()
        });
        for ray in std::iter::once(*middle).chain(ring) {
            let world = station.world_from_scanner * ray;
            echoes(view, &station.place, &world, RING_POWER, self.max_range, out);
        }
    }
}

fn direction(azimuth: f64, elevation: f64) -> Vec3 {
    Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;
    use crate::station::Registration;
    use crate::world::{Surface, World};
    use asbuilt_core::geometry::Solid;

    fn scanner() -> Scanner {
        let receiver = Receiver {
            resolution_m: 0.6,
            sigma_floor_m: 1e-9,
            sigma_signal_m: 0.0,
            reference_power: Receiver::WHITE_AT_10_M,
            min_power: 1e-6,
        };
        Scanner { step: 0.004, divergence: 3e-4, sigma_angle: 0.0, max_range: 60.0, min_elevation: -1.0, receiver }
    }

    fn matt(reflectivity: f64) -> Surface {
        Surface { material: Material::matt(reflectivity, 0.0), owner: 0 }
    }

    /// A board 3 m away before a wall at 3.4 m: beams over its edge lie between the two, all others on one of them.
    #[test]
    fn mixed_returns_lie_between_the_two_surfaces() {
        let mut world = World::default();
        world.add_solid(matt(0.8), &Solid::cuboid([3.4, -9.0, -9.0], [3.5, 9.0, 9.0]).unwrap());
        world.add_solid(matt(0.8), &Solid::cuboid([3.0, -0.5, -0.5], [3.05, 0.5, 0.5]).unwrap());
        let (world, nothing) = (world.built(), World::default());
        let exact = Registration { sigma_place_m: 0.0, sigma_turn: 0.0, datum: Vec3::zeros() };
        let station = Station::new(Vec3::zeros(), &exact, &mut ChaCha8Rng::seed_from_u64(1));
        let scan = Scanner { step: 0.002, ..scanner() }.scan(&View { fixed: &world, passing: &nothing }, &station, 4);
        let ahead = scan.shots.iter().filter(|s| s.returned && s.offset.x > 1.0 && s.offset.xy().norm() < 4.0);
        let (mut mixed, mut clean) = (0, 0);
        for p in ahead.map(|s| s.offset).filter(|p| p.y.abs().max(p.z.abs()) < 1.0 * p.x / 3.0) {
            let x = p.x;
            assert!((2.999..3.401).contains(&x), "{x}");
            if (x - 3.0).abs() > 0.002 && (x - 3.4).abs() > 0.002 {
                mixed += 1;
                // At its edge, seen from the scanner: half a metre off at 3 m.
                let edge = 3.0 * p.y.abs().max(p.z.abs()) / x;
                assert!((edge - 0.5).abs() < 3.0 * 2e-4, "{edge}");
            } else {
                clean += 1;
            }
        }
        // The outline of 4 m is 1.3 rad long and the ring 0.25 mrad wide: about 80 of a beam per (2 mrad)².
        assert!((40..170).contains(&mixed) && clean > 30_000, "{mixed} {clean}");
    }

    #[test]
    fn errors_of_registration_are_in_the_points() {
        let mut world = World::default();
        world.add_solid(matt(0.5), &Solid::cuboid([-4.0, -5.0, -2.0], [4.0, 5.0, 3.0]).unwrap());
        let (world, nothing) = (world.built(), World::default());
        let registration = Registration { sigma_place_m: 0.01, sigma_turn: 0.0, datum: Vec3::new(0.0, 0.0, 0.1) };
        let station = Station::new(Vec3::new(0.3, 0.2, 0.1), &registration, &mut ChaCha8Rng::seed_from_u64(3));
        let off = station.registered_place - station.place;
        assert!((off.z - 0.1).abs() < 0.05 && off.norm() > 0.0);
        let view = View { fixed: &world, passing: &nothing };
        let scan = scanner().scan(&view, &station, 5);
        assert_eq!(scan, scanner().scan(&view, &station, 5));
        for s in scan.shots.iter().filter(|s| s.returned) {
            let p = scan.place + s.offset - off;
            let wall = (p.x.abs() - 4.0).abs().min((p.y.abs() - 5.0).abs());
            let slab = (p.z + 2.0).abs().min((p.z - 3.0).abs());
            // Between two walls of a corner it is a mean of the rays of the footprint.
            assert!(wall.min(slab) < 1e-3, "{p}");
        }
        let (columns, rows) = scanner().grid();
        assert_eq!(scan.shots.len(), (columns * rows) as usize);
    }

    /// Noise of a perpendicular wall's returns, by the signal of its distance.
    #[test]
    fn noise_of_a_wall() {
        let mut world = World::default();
        world.add_solid(matt(0.2), &Solid::cuboid([20.0, -9.0, -9.0], [21.0, 9.0, 9.0]).unwrap());
        let (world, nothing) = (world.built(), World::default());
        let exact = Registration { sigma_place_m: 0.0, sigma_turn: 0.0, datum: Vec3::zeros() };
        let station = Station::new(Vec3::zeros(), &exact, &mut ChaCha8Rng::seed_from_u64(1));
        let receiver = Receiver { sigma_floor_m: 5e-4, sigma_signal_m: 7e-4, ..scanner().receiver };
        let scanner = Scanner { receiver, step: 0.002, ..scanner() };
        let scan = scanner.scan(&View { fixed: &world, passing: &nothing }, &station, 6);
        let near_normal = |o: &Vec3| o.x > 0.0 && o.y.hypot(o.z) < 0.1 * o.x;
        let errors: Vec<f64> = scan
            .shots
            .iter()
            .filter(|s| s.returned && near_normal(&s.offset))
            .map(|s| s.offset.norm() * (1.0 - 20.0 / s.offset.x))
            .collect();
        let sd = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        // Four times the reflectivity less and twice as far: 16 times less light.
        let want = 5e-4f64.hypot(7e-4 * 4.0);
        assert!(errors.len() > 5000 && (sd / want - 1.0).abs() < 0.03, "{sd} {want} {}", errors.len());
    }
}
