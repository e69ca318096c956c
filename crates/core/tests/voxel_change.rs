//! Change, masks and components against brute force that shares no code with them.

use std::collections::{HashMap, HashSet};

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::voxel::{ChangeClass, ChangeSettings, FillRule, Grid, Occupancy, VoxelChange, VoxelSet, VoxelState};
use proptest::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Voxel = [i64; 3];

/// Beams from one place onto a wall at `x`, with noise and a hole.
fn epoch(grid: Grid, seed: u64, x: f64) -> Occupancy {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut o = Occupancy::new(grid);
    for _ in 0..4 {
        let beam = |rng: &mut ChaCha8Rng| {
            let (y, z) = (rng.random_range(-0.8..0.8), rng.random_range(-0.4..0.4));
            let x = if y > 0.5 { 1.9 } else { x + rng.random_range(-0.02..0.02) };
            Beam { offset: Vec3::new(x, y * x, z * x), returned: rng.random_bool(0.95) }
        };
        let beams: Vec<Beam> = (0..1500).map(|_| beam(&mut rng)).collect();
        let origin = Vec3::from_fn(|_, _| rng.random_range(-0.1..0.1));
        let patch = Patch::encode(1, origin, 0.01, Patch::QUANTUM_M, &beams).unwrap().to_bytes();
        o.absorb(&patch, NEVER).unwrap();
    }
    o
}

/// Returns and traversal of every voxel about which something is known.
fn known(o: &Occupancy) -> HashMap<Voxel, (u8, bool)> {
    let mut out = HashMap::new();
    o.for_each(1, NEVER, |voxel, state, hits| {
        out.insert(voxel, (hits, matches!(state, VoxelState::Empty | VoxelState::Ambiguous)));
    })
    .unwrap();
    out
}

fn gap(a: Voxel, b: Voxel) -> f64 {
    (0..3).map(|i| (((a[i] - b[i]).abs() - 1).max(0) as f64).powi(2)).sum::<f64>().sqrt()
}

/// The rule as docs/voxels.md states it.
fn class(
    old: &HashMap<Voxel, (u8, bool)>,
    new: &HashMap<Voxel, (u8, bool)>,
    voxel: Voxel,
    threshold: u8,
    tolerance: f64,
) -> Option<ChangeClass> {
    let at = |side: &HashMap<Voxel, (u8, bool)>| side.get(&voxel).copied().unwrap_or_default();
    let (was, is) = (at(old).0 >= threshold, at(new).0 >= threshold);
    let (other, changed) = match (was, is) {
        (false, false) => return None,
        (true, true) => return Some(ChangeClass::Confirmed),
        (true, false) => (new, ChangeClass::Disappeared),
        (false, true) => (old, ChangeClass::New),
    };
    if tolerance > 0.0 {
        let reach = tolerance.ceil() as i64 + 1;
        let mut most = 0;
        for i in 0..(2 * reach + 1).pow(3) {
            let n = 2 * reach + 1;
            let there = [voxel[0] + i % n - reach, voxel[1] + i / n % n - reach, voxel[2] + i / n / n - reach];
            if gap(voxel, there) < tolerance {
                most = most.max(other.get(&there).map_or(0, |k| k.0));
            }
        }
        if most >= threshold {
            return Some(ChangeClass::Confirmed);
        }
        if most > 0 && at(other).1 {
            return Some(ChangeClass::Ambiguous);
        }
    }
    Some(if at(other).1 { changed } else { ChangeClass::Unknown })
}

#[test]
fn classes_are_those_of_brute_force() {
    let grid = Grid { exact: true, ..Grid::new(0.05, Grid::EVERYWHERE, 0.01, 1.0).unwrap() };
    let (old, new) = (epoch(grid, 1, 1.5), epoch(grid, 2, 1.2));
    let (k_old, k_new) = (known(&old), known(&new));
    let voxels: HashSet<Voxel> = k_old.keys().chain(k_new.keys()).copied().collect();
    let mut met = HashSet::new();
    for threshold in [1, 3, 10] {
        for tolerance in [0.0, 0.02, 0.08] {
            let change = VoxelChange::between(&old, &new, ChangeSettings { threshold, tolerance }, NEVER).unwrap();
            let mut counts = [0; 5];
            for &voxel in &voxels {
                let expected = class(&k_old, &k_new, voxel, threshold, tolerance / 0.05);
                assert_eq!(change.class(voxel), expected, "{voxel:?} at {threshold} {tolerance}");
                if let Some(c) = expected {
                    counts[c as usize - 1] += 1;
                    met.insert(c as u8);
                }
            }
            let tally = change.tally(None, 0.0, NEVER).unwrap();
            assert_eq!(tally.voxels, counts);
            assert!(tally.total() > 300 / u64::from(threshold).pow(2), "{threshold}: {tally:?}");
            let bytes = change.to_bytes(NEVER).unwrap();
            assert_eq!(VoxelChange::from_bytes(&bytes, NEVER).unwrap(), change);
        }
    }
    assert_eq!(met.len(), 5, "every class occurs");
}

/// Sum of the signed solid angles of all triangles: 4π inside (van Oosterom and Strackee 1983).
fn winding(solid: &Solid, p: &Vec3) -> f64 {
    let angle = |t: usize| {
        let [a, b, c] = solid.corners(t).map(|v| v - p);
        let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
        2.0 * a.dot(&b.cross(&c)).atan2(la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb)
    };
    (0..solid.triangles().len()).map(angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
}

fn turned(solid: &Solid, by: Vec3, shift: Vec3) -> Solid {
    let r = nalgebra::Rotation3::new(by);
    Solid::new(solid.vertices().iter().map(|v| r * v + shift).collect(), solid.triangles().to_vec()).unwrap()
}

/// A cuboid whose top is cut into two more triangles, at a vertex that its side does not have.
fn with_t_junction() -> Solid {
    let c = Solid::cuboid([0.0; 3], [1.0, 0.7, 0.4]).unwrap();
    let mut vertices = c.vertices().to_vec();
    let mut triangles = c.triangles().to_vec();
    let t = triangles.remove(3);
    let [a, b] = [vertices[t[0] as usize], vertices[t[1] as usize]];
    vertices.push(a + (b - a) / 3.0);
    let m = vertices.len() as u32 - 1;
    triangles.extend([[t[0], m, t[2]], [m, t[1], t[2]]]);
    Solid::new(vertices, triangles).unwrap()
}

fn distance_to_triangle(p: &Vec3, [a, b, c]: [Vec3; 3]) -> f64 {
    // The least of a dense set of barycentric points, good to the mesh width.
    let mut least = f64::INFINITY;
    for i in 0..=60 {
        for j in 0..=60 - i {
            let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
            least = least.min((a + (b - a) * u + (c - a) * v - p).norm());
        }
    }
    least
}

#[test]
fn masks_are_those_of_the_winding_number() {
    let solids = [
        Solid::cuboid([0.0; 3], [1.0, 0.5, 0.25]).unwrap(),
        turned(
            &Solid::cuboid([0.0; 3], [1.0, 0.5, 0.25]).unwrap(),
            Vec3::new(0.3, -0.2, 0.9),
            Vec3::new(5e5, 6e6, -3.0),
        ),
        turned(
            &Solid::cylinder([0.0; 3], 0.3, 0.9, 32).unwrap(),
            Vec3::new(0.1, 1.2, 0.0),
            Vec3::new(0.013, -2.0, 0.4),
        ),
        turned(&with_t_junction(), Vec3::new(0.0, 0.0, 0.41), Vec3::zeros()),
        with_t_junction(),
    ];
    for (k, solid) in solids.iter().enumerate() {
        let grid = Grid::new(0.05, Grid::EVERYWHERE, 0.0, 0.0).unwrap();
        let [centre, cover, surface] = [FillRule::Centre, FillRule::Cover, FillRule::Surface]
            .map(|rule| VoxelSet::of(solid, &grid, rule, NEVER).unwrap());
        let bounds = solid.bounds().expanded(0.1);
        let (low, high) = (grid.index(&bounds.min.into()).unwrap(), grid.index(&bounds.max.into()).unwrap());
        let mut inside = 0;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let voxel = [x, y, z];
                    let at = grid.centre(voxel);
                    let w = winding(solid, &at);
                    // On the surface itself either will do.
                    if (w - 0.5).abs() < 0.4 {
                        continue;
                    }
                    inside += u64::from(w > 0.5);
                    assert_eq!(centre.holds(voxel), w > 0.5, "solid {k}, {voxel:?}, winding {w}");
                    assert_eq!(cover.holds(voxel), centre.holds(voxel) || surface.holds(voxel), "{k} {voxel:?}");
                }
            }
        }
        assert!(inside > 100, "{k}: {inside}");
        assert!((inside as f64 * 0.05f64.powi(3) / solid.volume().unwrap() - 1.0).abs() < 0.12, "{k}: {inside}");
        // Points of the surface lie in its voxels, and no voxel is farther from it than half its diagonal.
        let mut rng = ChaCha8Rng::seed_from_u64(k as u64);
        for _ in 0..2000 {
            let [a, b, c] = solid.corners(rng.random_range(0..solid.triangles().len()));
            let (u, v) = (rng.random_range(0.0..1.0f64), rng.random_range(0.0..1.0f64));
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let p = a + (b - a) * u + (c - a) * v;
            let near_border = p.iter().any(|c| (c / 0.05 - (c / 0.05).round()).abs() < 1e-6);
            assert!(near_border || surface.holds(grid.index(&p).unwrap()), "{k}: {p:?}");
        }
        let mut checked = 0;
        for x in low[0]..=high[0] {
            for y in (low[1]..=high[1]).step_by(3) {
                let z = low[2] + (x + y).rem_euclid(high[2] - low[2] + 1);
                if surface.holds([x, y, z]) {
                    let at = grid.centre([x, y, z]);
                    let d = (0..solid.triangles().len()).map(|t| distance_to_triangle(&at, solid.corners(t)));
                    assert!(d.fold(f64::INFINITY, f64::min) < 0.0433 + 0.02, "{k}: [{x}, {y}, {z}]");
                    checked += 1;
                }
            }
        }
        assert!(checked > 3, "{k}");
    }
}

#[test]
fn open_surfaces_have_no_inside() {
    let sheet = Solid::new(vec![Vec3::zeros(), Vec3::x(), Vec3::y()], vec![[0, 1, 2]]).unwrap();
    let grid = Grid::new(0.1, Grid::EVERYWHERE, 0.0, 0.0).unwrap();
    for rule in [FillRule::Centre, FillRule::Cover] {
        let e = VoxelSet::of(&sheet, &grid, rule, NEVER).unwrap_err();
        assert!(e.to_string().contains("open"), "{e}");
    }
    // The 55 voxels of the triangle, its upper borders owned by the next ones.
    let shell = VoxelSet::of(&sheet, &grid, FillRule::Surface, NEVER).unwrap();
    assert!((55..=66).contains(&shell.len()), "{}", shell.len());
}

#[test]
fn a_model_against_an_epoch() {
    let grid = Grid { exact: true, ..Grid::new(0.05, Grid::EVERYWHERE, 0.01, 1.0).unwrap() };
    let seen = epoch(grid, 3, 1.4);
    let solid = Solid::cuboid([1.38, -2.0, -1.0], [1.55, 0.3, 1.0]).unwrap();
    let model = VoxelSet::of(&solid, &grid, FillRule::Centre, NEVER).unwrap().into_model(grid, NEVER).unwrap();
    assert_eq!(model.state([0, 0, 0], 3), VoxelState::Empty);
    let settings = ChangeSettings { threshold: 3, tolerance: 0.03 };
    let change = VoxelChange::between(&model, &seen, settings, NEVER).unwrap();
    let tally = change.tally(None, 0.0, NEVER).unwrap();
    assert!(
        tally.of(ChangeClass::Confirmed) > 200
            && tally.of(ChangeClass::New) > 20
            && tally.of(ChangeClass::Unknown) > 500,
        "{tally:?}"
    );
    assert_eq!(
        (change.class_name(ChangeClass::New), change.class_name(ChangeClass::Disappeared)),
        ("unmodelled", "absent")
    );
    // A block of air before the wall is drawn, and seen empty.
    let air = Solid::cuboid([0.6, -0.3, -0.2], [0.9, 0.3, 0.2]).unwrap();
    let model = VoxelSet::of(&air, &grid, FillRule::Centre, NEVER).unwrap();
    let drawn = model.len();
    let change = VoxelChange::between(&model.into_model(grid, NEVER).unwrap(), &seen, settings, NEVER).unwrap();
    let inside = VoxelSet::of(&air, &grid, FillRule::Cover, NEVER).unwrap();
    let tally = change.tally(Some(&inside), 0.0, NEVER).unwrap();
    assert!(
        tally.of(ChangeClass::Disappeared) as f64 > 0.95 * drawn as f64 && tally.of(ChangeClass::Confirmed) == 0,
        "{tally:?}"
    );
}

#[test]
fn lattices_must_agree() {
    let [a, b] = [0.05, 0.04].map(|voxel| Occupancy::new(Grid::new(voxel, Grid::EVERYWHERE, 0.01, 1.0).unwrap()));
    let settings = ChangeSettings { threshold: 3, tolerance: 0.0 };
    let e = VoxelChange::between(&a, &b, settings, NEVER).unwrap_err();
    assert!(e.to_string().contains("0.05 m and of 0.04 m"), "{e}");
    for tolerance in [-0.01, f64::NAN, 0.5] {
        assert!(VoxelChange::between(&a, &a, ChangeSettings { threshold: 3, tolerance }, NEVER).is_err());
    }
    assert!(ChangeSettings::threshold(0).is_err() && ChangeSettings::threshold(256).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Components are the equivalence classes of "the gap is small", found by looking at all pairs.
    #[test]
    fn components_are_those_of_all_pairs(
        seed: u64,
        n in 1usize..120,
        gap_voxels in prop::sample::select(vec![0.0f64, 1.01, 2.01]),
    ) {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let grid = Grid::new(0.1, Grid::EVERYWHERE, 0.0, 0.0).unwrap();
        let mut model = Occupancy::of_model(grid);
        let mut voxels: Vec<Voxel> = Vec::new();
        for _ in 0..n {
            let voxel: Voxel = std::array::from_fn(|_| rng.random_range(-12..12));
            let corner = |by: f64| (grid.centre(voxel) + Vec3::repeat(by)).into();
            let at = Solid::cuboid(corner(-0.01), corner(0.01)).unwrap();
            let mask = VoxelSet::of(&at, &grid, FillRule::Cover, NEVER).unwrap();
            model.merge(&mask.into_model(grid, NEVER).unwrap(), NEVER).unwrap();
            voxels.push(voxel);
        }
        voxels.sort();
        voxels.dedup();
        let nothing = Occupancy::of_model(grid);
        let settings = ChangeSettings { threshold: 1, tolerance: 0.0 };
        let change = VoxelChange::between(&nothing, &model, settings, NEVER).unwrap();
        let mut of: Vec<usize> = (0..voxels.len()).collect();
        for i in 0..voxels.len() {
            for j in 0..i {
                if gap(voxels[i], voxels[j]) < gap_voxels.max(0.5) {
                    let (a, b) = (of[i], of[j]);
                    of.iter_mut().filter(|c| **c == a).for_each(|c| *c = b);
                }
            }
        }
        let mut sizes: HashMap<usize, u64> = HashMap::new();
        of.iter().for_each(|c| *sizes.entry(*c).or_default() += 1);
        let mut expected: Vec<u64> = sizes.into_values().collect();
        expected.sort_by(|a, b| b.cmp(a));
        let found = change.components(ChangeClass::New, 1, gap_voxels * 0.1, NEVER).unwrap();
        prop_assert_eq!(found.iter().map(|c| c.voxels).collect::<Vec<_>>(), expected);
        let mean = voxels.iter().map(|&v| grid.centre(v)).sum::<Vec3>() / voxels.len() as f64;
        let joint: Vec3 = found.iter().map(|c| c.centroid * c.voxels as f64).sum::<Vec3>() / voxels.len() as f64;
        prop_assert!((mean - joint).norm() < 1e-9);
        prop_assert!(found.iter().all(|c| c.bounds.holds(&c.centroid)));
    }

    /// Twice as coarse: returns are kept, and a large voxel knows what any of its eight knew.
    #[test]
    fn downsampling_keeps_returns(seed in 0u64..1000) {
        let grid = Grid::new(0.05, Grid::EVERYWHERE, 0.01, 1.0).unwrap();
        let fine = epoch(grid, seed, 1.3);
        let coarse = fine.downsampled(NEVER).unwrap();
        prop_assert_eq!(coarse.grid().voxel, 0.1);
        let mut expected: HashMap<Voxel, (u8, bool)> = HashMap::new();
        for (voxel, (hits, passed)) in known(&fine) {
            let large = expected.entry(voxel.map(|i| i.div_euclid(2))).or_default();
            *large = (large.0.saturating_add(hits), large.1 || passed);
        }
        prop_assert_eq!(known(&coarse), expected);
    }

    /// Voxels without neighbours are removed, and nothing else.
    #[test]
    fn denoising_counts_neighbours(seed in 0u64..1000, neighbours in 1u32..5) {
        let grid = Grid::new(0.05, Grid::EVERYWHERE, 0.01, 1.0).unwrap();
        let noisy = epoch(grid, seed, 1.3);
        let clean = noisy.denoised(neighbours, 1, NEVER).unwrap();
        let (before, after) = (known(&noisy), known(&clean));
        for (voxel, (hits, passed)) in &before {
            let there = before.iter().filter(|(v, k)| k.0 > 0 && *v != voxel && gap(**v, *voxel) < 0.5).count();
            let keeps = if there as u32 >= neighbours { *hits } else { 0 };
            prop_assert_eq!(after.get(voxel).copied().unwrap_or_default(), (keeps, *passed));
            if before.len() > 3000 && there > 20 { break; }
        }
    }
}
