//! One building, built and scanned.

use std::path::{Path, PathBuf};

use anyhow::Result;
use asbuilt_core::geometry::Vec3;
use asbuilt_fieldscan::station::Registration;
use asbuilt_fieldscan::{Receiver, Scan, Scanner, Station, View, World};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;

use super::clutter::{passing, scatter};
use super::fate::{Fate, fates};
use super::layout::Layout;
use super::places::{Standpoint, chosen, standpoints};
use super::samples::{Sample, samples};
use super::standing::{SIGMA_BIAS_M, Standing, furnish, standing};

/// Models below ../shared/data, and how many scenes are made of each.
const SHARED: [(&str, usize); 10] = [
    ("ifc-duplex/Duplex_A_20110907.ifc", 4),
    ("ifc-fzk-haus/AC20-FZK-Haus.ifc", 4),
    ("ifc-bimwhale/LargeBuilding.ifc", 2),
    ("ifc-bimwhale/TallBuilding.ifc", 2),
    ("ifc-tiny/IfcOpenHouse_IFC4.ifc", 4),
    ("ifc-tiny/building-architecture.ifc", 2),
    ("ifc-tiny/hello-wall.ifc", 2),
    ("ifc-bimwhale/SimpleWall.ifc", 1),
    ("schependomlaan/XELLA-Begane_grond.ifc", 1),
    ("schependomlaan/ROOT-kalkzandsteen.ifc", 1),
];
/// Scenes of each model in demo/models.
const OWN: usize = 2;
/// Small models that the short form takes.
const SHORT: [&str; 3] = ["AC20-FZK-Haus.ifc", "IfcOpenHouse_IFC4.ifc", "building-architecture.ifc"];

/// Values that alternate from scene to scene.
const STEPS_MRAD: [f64; 5] = [4.0, 5.0, 3.5, 6.0, 4.5];
const REGISTRATIONS_MM: [f64; 4] = [1.0, 0.5, 2.0, 1.5];
const STATIONS: [usize; 3] = [10, 6, 14];
/// Noise (floor, and signal at the reference), millimetres, and resolution along the beam, metres, of a phase scanner, a
/// hybrid one and a pulsed one.
const RECEIVERS: [(f64, f64, f64); 3] = [(0.3, 0.5, 1.5), (0.5, 0.8, 0.5), (1.5, 1.5, 0.6)];

/// What a scene is made from.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Its number in the set.
    pub number: usize,
    /// IFC file.
    pub model: PathBuf,
    /// Of all that is random in it.
    pub seed: u64,
    /// The scanner.
    pub scanner: Scanner,
    /// Registration: σ of place and turn.
    pub registration: Registration,
    /// Most stations.
    pub stations: usize,
}

impl Plan {
    /// The model's name.
    pub fn name(&self) -> String {
        self.model.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    fn new(number: usize, model: PathBuf, seed: u64) -> Self {
        let pick = |values: &[f64]| values[number % values.len()];
        let (floor, signal, resolution) = RECEIVERS[number % RECEIVERS.len()];
        let receiver = Receiver {
            resolution_m: resolution,
            sigma_floor_m: floor * 1e-3,
            sigma_signal_m: signal * 1e-3,
            reference_power: Receiver::WHITE_AT_10_M,
            min_power: 4e-5,
        };
        let scanner = Scanner {
            step: pick(&STEPS_MRAD) * 1e-3,
            divergence: 3e-4,
            sigma_angle: 4e-5,
            max_range: 80.0,
            min_elevation: (-60f64).to_radians(),
            receiver,
        };
        let sigma_place_m = pick(&REGISTRATIONS_MM) * 1e-3;
        let registration = Registration { sigma_place_m, sigma_turn: 5e-5, datum: Vec3::zeros() };
        let stations = STATIONS[number % STATIONS.len()];
        Self { number, model, seed: seed + number as u64, scanner, registration, stations }
    }
}

/// All scenes of the set, in the order of their numbers; models that are not there are named and left out, and the
/// others keep their numbers.
pub fn plans(seed: u64, short: bool) -> Result<Vec<Plan>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files: Vec<(PathBuf, usize)> =
        SHARED.iter().map(|(path, count)| (root.join("../shared/data").join(path), *count)).collect();
    let mut own: Vec<PathBuf> = std::fs::read_dir(root.join("demo/models"))
        .map(|all| all.flatten().map(|entry| entry.path()).collect())
        .unwrap_or_default();
    own.retain(|path| path.extension().is_some_and(|e| e == "ifc"));
    own.sort();
    files.extend(own.into_iter().map(|path| (path, OWN)));
    let mut out = Vec::new();
    let mut number = 0;
    for (path, count) in files {
        let is_there = path.is_file();
        if !is_there {
            eprintln!("SKIPPED: {} is not there; {count} scenes are missing", path.display());
        }
        let is_small = SHORT.iter().any(|s| path.ends_with(s));
        for k in 0..count {
            if is_there && (!short || is_small && k == 0) {
                out.push(Plan::new(number, path.clone(), seed));
            }
            number += 1;
        }
    }
    Ok(out)
}

/// A building as built, its stations and what they measured.
pub struct Scene {
    /// What it is made from.
    pub plan: Plan,
    /// As drawn.
    pub layout: Layout,
    /// Places on every object.
    pub samples: Vec<Vec<Sample>>,
    /// What became of every object.
    pub fates: Vec<Fate>,
    /// Every object as built.
    pub standing: Vec<Standing>,
    /// What stands there for good.
    pub world: World,
    /// What passed, a world for each station.
    pub passing: Vec<World>,
    /// Stations.
    pub stations: Vec<Station>,
    /// What they measured.
    pub scans: Vec<Scan>,
}

impl Scene {
    /// Builds and scans a building.
    pub fn build(plan: &Plan, layout: Layout) -> Result<Self> {
        Self::built(plan, layout, fates)
    }

    /// The same with these fates of its objects.
    pub fn built(
        plan: &Plan,
        mut layout: Layout,
        fates: impl FnOnce(&Layout, &mut ChaCha8Rng) -> Vec<Fate>,
    ) -> Result<Self> {
        let mut rng = ChaCha8Rng::seed_from_u64(plan.seed);
        let samples: Vec<Vec<Sample>> = layout.objects.par_iter().map(samples).collect::<Result<_>>()?;
        mark_twins(&mut layout, &samples);
        let floor = standpoints(&layout, &mut rng);
        let places = chosen(&layout, &samples, &floor, plan.stations, &mut rng);
        let eyes: Vec<Vec3> = places.iter().map(Standpoint::eye).collect();
        let fates = fates(&layout, &mut rng);
        let standing = standing(&layout, &fates);
        let mut world = World::default();
        furnish(&mut world, &layout, &standing, &mut rng);
        scatter(&mut world, &floor, &eyes, &mut rng)?;
        let world = world.built();
        let registration = Registration { datum: datum(&mut rng), ..plan.registration };
        let stations: Vec<Station> = eyes.iter().map(|e| Station::new(*e, &registration, &mut rng)).collect();
        let pass = |p: &Standpoint| passing(&p.eye(), p.outdoors, &floor, &mut rng);
        let passing: Vec<World> = places.iter().map(pass).collect::<Result<_>>()?;
        let mut out =
            Self { plan: plan.clone(), layout, samples, fates, standing, world, passing, stations, scans: Vec::new() };
        out.scans = (0..out.stations.len())
            .map(|i| plan.scanner.scan(&out.view(i), &out.stations[i], plan.seed.wrapping_mul(1009) + i as u64))
            .collect();
        Ok(out)
    }

    /// What a station sees.
    pub fn view(&self, station: usize) -> View<'_> {
        View { fixed: &self.world, passing: &self.passing[station] }
    }

    /// Returns of all stations by object.
    pub fn returns(&self) -> Vec<usize> {
        let mut out = vec![0; self.layout.objects.len()];
        for owner in self.scans.iter().flat_map(|s| &s.shots).filter_map(|shot| shot.owner) {
            if let Some(count) = out.get_mut(owner as usize) {
                *count += 1;
            }
        }
        out
    }

    /// Standard deviation of what the stations of this survey have wrong in common at an object, metres: registration,
    /// datum, and the range's bias by material.
    pub fn common_sd(&self) -> f64 {
        let place = self.plan.registration.sigma_place_m;
        (place * place + DATUM_M * DATUM_M + SIGMA_BIAS_M * SIGMA_BIAS_M).sqrt()
    }
}

/// Standard deviation of the epoch's datum, metres per axis.
pub const DATUM_M: f64 = 0.0005;

fn datum(rng: &mut ChaCha8Rng) -> Vec3 {
    Vec3::from_fn(|_, _| DATUM_M * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng))
}

/// Marks objects nearly all of whose surface lies on that of one other: they are one body, drawn twice.
fn mark_twins(layout: &mut Layout, samples: &[Vec<Sample>]) {
    const COINCIDE_M: f64 = 0.01;
    const SHARE: f64 = 0.95;
    let twins: Vec<bool> = samples
        .par_iter()
        .enumerate()
        .map(|(i, own)| {
            let on: Vec<Option<usize>> =
                own.iter().map(|s| layout.coincident(&s.place, &s.normal, i, COINCIDE_M).map(|c| c.0)).collect();
            let one = on.iter().flatten().next().copied();
            let count = |other: usize| on.iter().filter(|o| **o == Some(other)).count();
            one.is_some_and(|other| count(other) as f64 >= SHARE * own.len() as f64)
        })
        .collect();
    layout.objects.iter_mut().zip(twins).for_each(|(o, twin)| o.twin = twin);
}
