//! Where a scanner stood is recovered within its stated uncertainty, or not at all. The scanner and its rooms are made here.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::origin::{NotRecovered, RecoveredOrigin, recover};
use asbuilt_core::scan::Beam;
use nalgebra::{Rotation3, Unit};
use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;
use std::collections::HashSet;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ANCHOR: [f64; 3] = [500_000.0, 5_300_000.0, 100.0];

/// A room of boxes, corners in metres; without a roof there are no returns from above, and a window gives none.
#[derive(Clone)]
struct Room {
    high: Vec3,
    boxes: Vec<[Vec3; 2]>,
    has_roof: bool,
    window: bool,
}

impl Room {
    fn new(rng: &mut ChaCha8Rng) -> Self {
        let has_roof = rng.random_bool(0.75);
        let scale = if has_roof { 1.0 } else { 4.0 };
        let high =
            Vec3::new(rng.random_range(3.0..9.0), rng.random_range(3.0..7.0), rng.random_range(2.4..4.0)) * scale;
        let boxes = (0..rng.random_range(2..8)).map(|_| {
            let low = Vec3::new(rng.random_range(0.0..0.9) * high.x, rng.random_range(0.0..0.9) * high.y, 0.0);
            [low, low + Vec3::new(rng.random_range(0.2..1.5), rng.random_range(0.2..1.5), rng.random_range(0.4..2.2))]
        });
        Self { high, boxes: boxes.collect(), has_roof, window: rng.random_bool(0.5) }
    }

    /// A place for a tripod, off walls and furniture.
    fn place(&self, rng: &mut ChaCha8Rng) -> Vec3 {
        loop {
            let u = |low: f64, high: f64, rng: &mut ChaCha8Rng| rng.random_range(low..high);
            let p = Vec3::new(u(0.6, self.high.x - 0.6, rng), u(0.6, self.high.y - 0.6, rng), u(1.2, 1.9, rng));
            let is_near = |[low, high]: &[Vec3; 2]| (0..2).all(|k| p[k] > low[k] - 0.5 && p[k] < high[k] + 0.5);
            if !self.boxes.iter().any(is_near) {
                return p;
            }
        }
    }

    fn range(&self, from: &Vec3, d: &Vec3) -> Option<f64> {
        let slab = |low: &Vec3, high: &Vec3| {
            (0..3).fold((f64::NEG_INFINITY, f64::INFINITY), |(near, far), k| {
                let (a, b) = ((low[k] - from[k]) / d[k], (high[k] - from[k]) / d[k]);
                (near.max(a.min(b)), far.min(a.max(b)))
            })
        };
        let wall = slab(&Vec3::zeros(), &self.high).1;
        let front =
            self.boxes.iter().map(|[low, high]| slab(low, high)).filter(|(near, far)| near < far && *near > 0.0);
        let range = front.map(|(near, _)| near).fold(wall, f64::min);
        let p = from + d * range;
        let is_sky = !self.has_roof && p.z > self.high.z - 1e-6;
        let is_glass =
            self.window && p.y < 1e-6 && p.z > 1.0 && p.z < 2.0 && p.x > 0.3 * self.high.x && p.x < 0.6 * self.high.x;
        (!is_sky && !is_glass).then_some(range)
    }
}

#[derive(Clone, Copy)]
struct Scanner {
    step: f64,
    sigma_range: f64,
    sigma_angle: f64,
    rounding: f64,
    /// How much its axis leans, radians.
    lean: f64,
    /// A turn of the mirror sees both sides.
    is_full_circle: bool,
    goes_down: bool,
}

impl Scanner {
    fn new(rng: &mut ChaCha8Rng) -> Self {
        Self {
            step: rng.random_range(4e-3..8e-3),
            sigma_range: rng.random_range(3e-4..3e-3),
            sigma_angle: rng.random_range(1e-5..1e-4),
            rounding: [1e-5, 1e-4, 1e-3][rng.random_range(0..3)],
            lean: [0.0, 1e-4, 0.02][rng.random_range(0..3)],
            is_full_circle: rng.random_bool(0.5),
            goes_down: rng.random_bool(0.3),
        }
    }

    fn scan(&self, room: &Room, place: &Vec3, rng: &mut ChaCha8Rng) -> Vec<Beam> {
        let heading = Rotation3::from_axis_angle(&Vec3::z_axis(), rng.random_range(0.0..TAU));
        let about = Unit::new_normalize(Vec3::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0), 0.0));
        let turned = Rotation3::from_axis_angle(&about, self.lean) * heading;
        let (first, last, around) = if self.is_full_circle { (-1.05, PI + 1.05, PI) } else { (-1.05, FRAC_PI_2, TAU) };
        let (columns, rows) = ((around / self.step) as u32, ((last - first) / self.step) as u32);
        let mut normal = |sigma: f64| sigma * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng);
        let mut out = Vec::new();
        for column in 0..columns {
            for row in 0..rows {
                let row = if self.goes_down { rows - 1 - row } else { row };
                let (az, el) = (f64::from(column) * self.step, first + f64::from(row) * self.step);
                let d = |az: f64, el: f64| turned * Vec3::new(el.cos() * az.cos(), el.cos() * az.sin(), el.sin());
                let Some(range) = room.range(place, &d(az, el)) else { continue };
                // One in a hundred is lost.
                if normal(1.0) > 2.33 {
                    continue;
                }
                let noisy = d(az + normal(self.sigma_angle), el + normal(self.sigma_angle));
                let p = place + noisy * (range + normal(self.sigma_range));
                let offset = p.map(|c| (c / self.rounding).round() * self.rounding);
                out.push(Beam { offset, returned: true });
            }
        }
        out
    }
}

fn of(beams: &[Beam]) -> Result<RecoveredOrigin, NotRecovered> {
    recover(&Vec3::from(ANCHOR), beams)
}

fn error(found: &RecoveredOrigin, place: &Vec3) -> f64 {
    (found.position_world - Vec3::from(ANCHOR) - place).amax()
}

#[test]
fn whole_scans_are_recovered_within_their_uncertainty() {
    let cases: Vec<(usize, bool, bool, String)> = (0..60u64)
        .into_par_iter()
        .map(|seed| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let (room, scanner) = (Room::new(&mut rng), Scanner::new(&mut rng));
            let place = room.place(&mut rng);
            let beams = scanner.scan(&room, &place, &mut rng);
            let said = |what: String| {
                format!(
                    "{seed}: {what}; {} points, step {:.4}, rounding {}, lean {}, roof {}, full {}, down {}",
                    beams.len(),
                    scanner.step,
                    scanner.rounding,
                    scanner.lean,
                    room.has_roof,
                    scanner.is_full_circle,
                    scanner.goes_down
                )
            };
            match of(&beams) {
                Ok(found) => {
                    let error = error(&found, &place);
                    let line = said(format!("error {error:.5} m, sd {:.5} m", found.sd));
                    (1, error <= 3.0 * found.sd, found.sd < 0.02, line)
                }
                Err(why) => (0, true, true, said(why.to_string())),
            }
        })
        .collect();
    cases.iter().for_each(|c| eprintln!("{}", c.3));
    let recovered: usize = cases.iter().map(|c| c.0).sum();
    let right = cases.iter().filter(|c| c.0 == 1 && c.1).count();
    let sharp = cases.iter().filter(|c| c.0 == 1 && c.2).count();
    assert!(recovered * 10 >= cases.len() * 9, "{recovered} of {}", cases.len());
    assert!(right * 100 >= recovered * 95, "{right} of {recovered} within 3 sd");
    assert!(sharp * 10 >= recovered * 9, "{sharp} of {recovered} to 2 cm");
}

fn thinned(beams: &[Beam], cell: f64) -> Vec<Beam> {
    let mut taken = HashSet::new();
    beams.iter().filter(|b| taken.insert([0, 1, 2].map(|k| (b.offset[k] / cell).floor() as i64))).copied().collect()
}

/// Clouds whose order does not tell where their points were measured from.
#[test]
fn other_clouds_are_not_recovered() {
    let claimed: Vec<String> = (100..112u64)
        .into_par_iter()
        .flat_map_iter(|seed| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let (room, scanner) = (Room::new(&mut rng), Scanner { lean: 0.0, ..Scanner::new(&mut rng) });
            let scan = |rng: &mut ChaCha8Rng| {
                let place = room.place(rng);
                scanner.scan(&room, &place, rng)
            };
            let (a, b, c) = (scan(&mut rng), scan(&mut rng), scan(&mut rng));
            let merged = [&a[..], &b[..], &c[..]].concat();
            let small = [&a[..], &b[..a.len().min(b.len()) / 12]].concat();
            let mut shuffled = a.clone();
            shuffled.shuffle(&mut rng);
            // As thinning programs write: in the order of cells.
            let mut sorted = thinned(&merged, 0.03);
            sorted.sort_by_key(|b| [2, 1, 0].map(|k| (b.offset[k] / 0.03).floor() as i64));
            let clouds = [
                ("merged", merged.clone()),
                ("a twelfth of another station", small),
                ("shuffled", shuffled),
                ("merged and thinned", thinned(&merged, 0.03)),
                ("merged, thinned and sorted", sorted),
                ("thinned evenly", a.iter().filter(|_| rng.random_bool(0.3)).copied().collect()),
                ("dense matching", matched(&room, &mut rng)),
                ("sampled from a model", sampled(&room)),
            ];
            clouds.into_iter().filter_map(move |(what, cloud)| {
                let found = of(&cloud);
                eprintln!("{seed} {what}: {found:?}");
                found.ok().map(|_| format!("{seed} {what}"))
            })
        })
        .collect();
    assert!(claimed.is_empty(), "{claimed:?}");
}

/// A thinned scan whose order is kept may still tell; then it tells the truth.
#[test]
fn a_thinned_scan_is_recovered_rightly_or_not() {
    let wrong: Vec<String> = (200..212u64)
        .into_par_iter()
        .filter_map(|seed| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let (room, scanner) = (Room::new(&mut rng), Scanner::new(&mut rng));
            let place = room.place(&mut rng);
            let beams = thinned(&scanner.scan(&room, &place, &mut rng), 0.015);
            let found = of(&beams);
            eprintln!("{seed}: {} {:?} {found:?}", beams.len(), found.map(|f| error(&f, &place)));
            found.ok().filter(|found| error(found, &place) > 4.0 * found.sd).map(|f| format!("{seed}: {f:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

/// No value is too odd to be told.
#[test]
fn odd_points_are_told() {
    type Place = fn(f64) -> Vec3;
    let places: [Place; 8] = [
        |_| Vec3::zeros(),
        |i| Vec3::new(i, 0.0, 0.0),
        |i| Vec3::new(0.0, 0.0, i),
        |i| Vec3::new(f64::NAN, i, i),
        |i| Vec3::new(f64::INFINITY, -i, f64::NEG_INFINITY),
        |i| Vec3::new(1e300 * i, -1e300, 1e300 / (i + 1.0)),
        |i| Vec3::new((i * 0.7).sin(), (i * 0.7).cos(), 1e-300 * i),
        |i| Vec3::new(f64::MIN_POSITIVE, i % 2.0, f64::MAX * (i % 3.0)),
    ];
    for place in places {
        let beams: Vec<Beam> = (0..8000).map(|i| Beam { offset: place(f64::from(i)), returned: true }).collect();
        assert!(of(&beams).is_err());
    }
    assert_eq!(of(&[]), Err(NotRecovered::TooFewPoints(0)));
}

/// Points of photographs: on surfaces, with noise, in the rows of images taken on a walk.
fn matched(room: &Room, rng: &mut ChaCha8Rng) -> Vec<Beam> {
    let mut out = Vec::new();
    for _ in 0..20 {
        let (place, heading) = (room.place(rng), rng.random_range(0.0..TAU));
        let turned = Rotation3::from_euler_angles(rng.random_range(-0.1..0.1), rng.random_range(-0.3..0.3), heading);
        for (row, column) in (0..80).flat_map(|row| (0..120).map(move |column| (row, column))) {
            let image = Vec3::new(1.0, (f64::from(column) - 60.0) / 80.0, (40.0 - f64::from(row)) / 80.0);
            let d = turned * image.normalize();
            let noise = 1.0 + 0.005 * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng);
            out.extend(room.range(&place, &d).map(|r| Beam { offset: place + d * r * noise, returned: true }));
        }
    }
    out
}

/// Points in rows over all faces of the boxes.
fn sampled(room: &Room) -> Vec<Beam> {
    let mut out = Vec::new();
    for [low, high] in room.boxes.iter().copied().chain([[Vec3::zeros(), room.high]]) {
        for (axis, side) in (0..3).flat_map(|axis| [(axis, low), (axis, high)]) {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let count = |k: usize| ((high[k] - low[k]) / 0.03) as u32;
            for (i, j) in (0..count(u)).flat_map(|i| (0..count(v)).map(move |j| (i, j))) {
                let mut p = side;
                (p[u], p[v]) = (low[u] + f64::from(i) * 0.03, low[v] + f64::from(j) * 0.03);
                out.push(Beam { offset: p, returned: true });
            }
        }
    }
    out
}
