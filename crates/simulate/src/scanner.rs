//! A terrestrial laser scanner with its errors.

use std::f64::consts::{PI, TAU};

use asbuilt_core::geometry::Vec3;
use nalgebra::Rotation3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};
use rayon::prelude::*;

use crate::scene::Scene;

/// How accurate the scanner is.
#[derive(Debug, Clone, Copy)]
pub struct Scanner {
    /// Angle between neighbouring beams, radians.
    pub step: f64,
    /// Standard deviation of a range at the scanner, metres.
    pub sigma_range: f64,
    /// Growth of the standard deviation of a range per metre of range.
    pub sigma_range_per_m: f64,
    /// Standard deviation of the range's zero point, metres: one error for all beams of a scan.
    pub sigma_zero: f64,
    /// Standard deviation of each of the two angles, radians.
    pub sigma_angle: f64,
    /// Standard deviation of the position it is registered at, metres per axis.
    pub sigma_registration: f64,
    /// Share of beams that hit an edge and average two surfaces: the range is too short by up to a tenth.
    pub mixed_pixels: f64,
    /// Range beyond which nothing returns, metres.
    pub max_range: f64,
    /// Lowest elevation, radians: below it the tripod stands in the way.
    pub min_elevation: f64,
}

/// A beam of the grid in the scanner's frame; without a return only its direction counts.
#[derive(Debug, Clone, Copy)]
pub struct Shot {
    /// Row of the grid, from below.
    pub row: u32,
    /// Column, counter-clockwise.
    pub column: u32,
    /// Return, metres; without one a unit direction.
    pub point: Vec3,
    /// Whether anything came back.
    pub returned: bool,
}

/// One simulated scan.
#[derive(Debug)]
pub struct SimulatedScan {
    /// The beams, column by column.
    pub shots: Vec<Shot>,
    /// Rows of the grid.
    pub rows: u32,
    /// Columns of the grid.
    pub columns: u32,
    /// The pose that the file will state: heading about z, and the registered position.
    pub heading: f64,
    /// Where registration says that the scanner stood; it differs from the truth by the registration's error.
    pub registered: Vec3,
}

impl SimulatedScan {
    /// Rotation from the scanner's frame to the world's.
    pub fn world_from_scan(&self) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&Vec3::z_axis(), self.heading)
    }
}

impl Scanner {
    /// Columns and rows of a scan.
    pub fn grid(&self) -> (u32, u32) {
        let rows = (PI / 2.0 - self.min_elevation) / self.step;
        ((TAU / self.step).floor() as u32, rows.floor() as u32)
    }

    /// Scans from `station`. The same seed gives the same scan with any number of threads.
    pub fn scan(&self, scene: &Scene, station: &Vec3, seed: u64) -> SimulatedScan {
        let (columns, rows) = self.grid();
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let heading = rng.random_range(0.0..TAU);
        let registered = station + Vec3::from_fn(|_, _| self.normal(self.sigma_registration, &mut rng));
        let zero = self.normal(self.sigma_zero, &mut rng);
        let shots = (0..columns)
            .into_par_iter()
            .flat_map_iter(|column| {
                let mut rng = ChaCha8Rng::seed_from_u64(seed);
                rng.set_stream(u64::from(column) + 1);
                self.column(scene, station, (heading, zero), column, rows, &mut rng)
            })
            .collect();
        SimulatedScan { shots, rows, columns, heading, registered }
    }

    fn column(
        &self,
        scene: &Scene,
        station: &Vec3,
        (heading, zero): (f64, f64),
        column: u32,
        rows: u32,
        rng: &mut ChaCha8Rng,
    ) -> Vec<Shot> {
        (0..rows)
            .map(|row| {
                let azimuth = (f64::from(column) + 0.5) * self.step;
                let elevation = self.min_elevation + (f64::from(row) + 0.5) * self.step;
                let range = scene.first_hit(station, &direction(azimuth + heading, elevation));
                let measured = direction(
                    azimuth + self.normal(self.sigma_angle, rng),
                    elevation + self.normal(self.sigma_angle, rng),
                );
                match range.filter(|r| *r <= self.max_range) {
                    Some(r) => {
                        Shot { row, column, point: measured * self.measured_range(r + zero, rng), returned: true }
                    }
                    None => Shot { row, column, point: measured, returned: false },
                }
            })
            .collect()
    }

    fn measured_range(&self, range: f64, rng: &mut ChaCha8Rng) -> f64 {
        let noise = self.normal(self.sigma_range, rng) + self.normal(self.sigma_range_per_m * range, rng);
        let short = if rng.random_bool(self.mixed_pixels) { rng.random_range(0.9..1.0) } else { 1.0 };
        ((range + noise) * short).max(0.01)
    }

    fn normal(&self, sigma: f64, rng: &mut ChaCha8Rng) -> f64 {
        Normal::new(0.0, sigma).map_or(0.0, |n| n.sample(rng))
    }
}

fn direction(azimuth: f64, elevation: f64) -> Vec3 {
    Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use asbuilt_core::geometry::Solid;

    #[test]
    fn noise_is_as_asked_and_seeds_repeat() {
        let scanner = Scanner {
            step: 0.01,
            sigma_range: 0.002,
            sigma_range_per_m: 0.0,
            sigma_zero: 0.0,
            sigma_angle: 0.0,
            sigma_registration: 0.0,
            mixed_pixels: 0.0,
            max_range: 50.0,
            min_elevation: -1.0,
        };
        let scene = Scene::new(&[Solid::cuboid([-4.0, -4.0, -2.0], [4.0, 4.0, 2.0]).unwrap()]);
        let station = Vec3::new(0.5, -0.3, 0.2);
        let scan = scanner.scan(&scene, &station, 7);
        let again = scanner.scan(&scene, &station, 7);
        assert_eq!(scan.shots[1000].point, again.shots[1000].point);
        let errors: Vec<f64> = scan
            .shots
            .iter()
            .map(|s| {
                let world = scan.world_from_scan() * s.point.normalize();
                s.point.norm() - scene.first_hit(&station, &world).unwrap()
            })
            .collect();
        let sd = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        assert!((sd / 0.002 - 1.0).abs() < 0.02, "{sd}");
    }
}
