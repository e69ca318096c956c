//! Surveys: where the scanner stands, how well it measures, and its scans as the patches of the database.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec};
use asbuilt_simulate::{Scanner, Scene, SimulatedScan};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::building::{Building, Footprint};

/// The properties of a survey.
#[derive(Debug, Clone, Copy)]
pub struct Survey {
    pub seed: u64,
    pub scanner: Scanner,
    pub stations: usize,
    /// Steepest incidence that the verifier takes into account, radians.
    pub max_incidence: f64,
}

/// Values that alternate, in ever new combinations.
const STEPS_MRAD: [f64; 14] = [8.0, 3.0, 6.0, 2.0, 4.0, 1.5, 1.0, 8.0, 3.0, 6.0, 2.0, 4.0, 1.5, 0.6];
const SIGMA_RANGES_MM: [f64; 6] = [1.0, 0.5, 2.0, 3.0, 1.5, 5.0];
const REGISTRATIONS_MM: [f64; 5] = [1.0, 0.0, 0.5, 2.0, 3.0];
const MIXED: [f64; 4] = [0.002, 0.0, 0.01, 0.002];
const MAX_INCIDENCES_DEG: [f64; 11] = [80.0, 85.0, 80.0, 80.0, 85.0, 80.0, 85.0, 80.0, 80.0, 80.0, 85.0];
/// Zero point of a good scanner's range, metres.
const SIGMA_ZERO: f64 = 1e-4;
/// Angle error of a terrestrial scanner, radians: 8 arc seconds.
const SIGMA_ANGLE: f64 = 4e-5;

impl Survey {
    /// Survey number `i` of a set.
    pub fn number(i: usize, seed: u64) -> Self {
        let step_mrad = STEPS_MRAD[i % STEPS_MRAD.len()];
        let scanner = Scanner {
            step: step_mrad * 1e-3,
            sigma_range: SIGMA_RANGES_MM[i % SIGMA_RANGES_MM.len()] * 1e-3,
            sigma_range_per_m: 1e-5,
            sigma_zero: SIGMA_ZERO,
            sigma_angle: SIGMA_ANGLE,
            sigma_registration: REGISTRATIONS_MM[i % REGISTRATIONS_MM.len()] * 1e-3,
            mixed_pixels: MIXED[i % MIXED.len()],
            max_range: 60.0,
            min_elevation: (-60f64).to_radians(),
        };
        // Dense scans from fewer stations: the set is to be done in minutes.
        let most = if step_mrad < 1.2 {
            1
        } else if step_mrad < 1.8 {
            2
        } else {
            6
        };
        let max_incidence = MAX_INCIDENCES_DEG[i % MAX_INCIDENCES_DEG.len()].to_radians();
        Self { seed: seed + i as u64, scanner, stations: (1 + i % 5).min(most), max_incidence }
    }

    /// Places to stand, with room around them and well apart, plan metres.
    pub fn places(&self, building: &Building, rng: &mut ChaCha8Rng) -> Vec<Vec3> {
        let mut out: Vec<Vec3> = Vec::new();
        let mut apart = 0.5 * building.size.xy().norm();
        while out.len() < self.stations {
            let p = Vec3::new(
                rng.random_range(0.6..building.size.x - 0.6),
                rng.random_range(0.6..building.size.y - 0.6),
                rng.random_range(1.4..1.8),
            );
            let own = Footprint { min: [p.x, p.y], max: [p.x, p.y] };
            let free = !building.standing.iter().any(|f| f.near(&own, 0.4));
            if free && out.iter().all(|o| (o - p).norm() > apart) {
                out.push(p);
            } else {
                apart *= 0.98;
            }
        }
        out
    }

    /// Scans from one place, as packed patches. `station` counts from 1.
    pub fn scan(&self, scene: &Scene, place: &Vec3, station: i64) -> Result<Vec<Vec<u8>>> {
        let scan = self.scanner.scan(scene, place, self.seed.wrapping_mul(1_000_003).wrapping_add(station as u64));
        pack(&scan, station)
    }
}

/// As `asbuilt load` does.
fn pack(scan: &SimulatedScan, station: i64) -> Result<Vec<Vec<u8>>> {
    let world_from_scan = scan.world_from_scan();
    let beams = scan.shots.iter().map(|s| Beam { offset: world_from_scan * s.point, returned: s.returned }).collect();
    let content = Beams::of(beams);
    let patch = |tile: &Vec<u32>| {
        let (own, origins) = (content.select(tile), Origins::One);
        let spacing = own.spacing(origins);
        let setting = PatchSpec { origins, station, origin: scan.registered, spacing, quantum: Patch::QUANTUM_M };
        Ok(Patch::pack(&setting, &own)?.to_bytes())
    };
    content.cut(Origins::One, NEVER)?.par_iter().map(patch).collect()
}
