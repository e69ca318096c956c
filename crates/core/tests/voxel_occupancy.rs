//! Occupancy against brute force: every voxel against every beam, by clipping, sharing no code with the carver.

use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec, Spacing};
use asbuilt_core::voxel::{Grid, Occupancy, VoxelState};
use asbuilt_core::{AtOnce, Error, NEVER};
use proptest::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const VOXEL: f64 = 0.1;

/// Length of the part of a segment inside a box; negative where it misses the box.
fn length_inside(start: &Vec3, end: &Vec3, b: &Aabb) -> f64 {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for axis in 0..3 {
        let (s, d) = (start[axis], end[axis] - start[axis]);
        if d == 0.0 {
            if s < b.min[axis] || s > b.max[axis] {
                return -1.0;
            }
            continue;
        }
        let (p, q) = ((b.min[axis] - s) / d, (b.max[axis] - s) / d);
        from = from.max(p.min(q));
        to = to.min(p.max(q));
    }
    (to - from) * (end - start).norm()
}

/// Patches of a scene around `centre`: fans of a tripod in every direction, and a moving platform.
fn scene(seed: u64, centre: Vec3, patches: usize) -> Vec<Vec<u8>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut out = Vec::new();
    for k in 0..patches {
        let around = |rng: &mut ChaCha8Rng, by: f64| Vec3::from_fn(|_, _| rng.random_range(-by..by));
        let origin = centre + around(&mut rng, 0.8);
        let axis = around(&mut rng, 1.0).normalize();
        let beam = |rng: &mut ChaCha8Rng| {
            let direction = (axis + around(rng, 0.4)).normalize();
            Beam { offset: direction * rng.random_range(0.05..2.5), returned: rng.random_bool(0.9) }
        };
        let beams: Vec<Beam> = (0..60).map(|_| beam(&mut rng)).collect();
        let moving = k % 4 == 3;
        let starts = moving.then(|| (0..beams.len()).map(|_| around(&mut rng, 0.5)).collect());
        let origins = if moving { Origins::Each } else { Origins::One };
        let setting =
            PatchSpec { origins, station: 1, origin, spacing: Spacing::of(origins, 0.01), quantum: Patch::QUANTUM_M };
        out.push(Patch::pack(&setting, &Beams { starts, ..Beams::of(beams) }).unwrap().to_bytes());
    }
    out
}

fn occupied(grid: Grid, patches: &[Vec<u8>]) -> Occupancy {
    let mut o = Occupancy::new(grid);
    patches.iter().for_each(|p| o.absorb(p, NEVER).unwrap());
    o
}

/// What brute force says about a voxel: returns in it, and the longest path of a beam through it.
fn brute(grid: &Grid, patches: &[(Vec3, Beams)], voxel: [i64; 3]) -> (u32, f64) {
    let low = Vec3::from(voxel.map(|i| i as f64 * grid.voxel));
    let own = Aabb { min: low.into(), max: (low + Vec3::repeat(grid.voxel)).into() };
    let (mut hits, mut longest) = (0, -1.0f64);
    for (origin, content) in patches {
        for (i, beam) in content.beams.iter().enumerate() {
            let (start, end) = (origin + content.start(i), origin + content.end(i));
            let range = beam.offset.norm();
            let stop = if beam.returned {
                if end.map(|c| (c / grid.voxel).floor()) == low.map(|c| (c / grid.voxel).round()) {
                    hits += 1;
                    continue;
                }
                // Behind the voxel of the return nothing is said, nor within the margin before it.
                let last = end.map(|c| (c / grid.voxel).floor() * grid.voxel);
                let last = Aabb { min: last.into(), max: (last + Vec3::repeat(grid.voxel)).into() };
                let own_part = length_inside(&start, &end, &last).max(0.0);
                (range - own_part).min(range - grid.margin).max(0.0)
            } else {
                grid.no_return_range
            };
            longest = longest.max(length_inside(&start, &(start + beam.offset * (stop / range)), &own));
        }
    }
    (hits, longest)
}

fn agrees(grid: Grid, patches: &[Vec<u8>], region: Aabb) -> (usize, usize, usize) {
    let o = occupied(grid, patches);
    let unpacked: Vec<(Vec3, Beams)> = patches
        .iter()
        .map(|p| {
            let (h, c) = Patch::content_of(p).unwrap();
            (h.origin, c)
        })
        .collect();
    let [low, high] = [region.min, region.max].map(|c| c.map(|x| (x / grid.voxel).floor() as i64));
    let (mut full, mut empty, mut unknown) = (0, 0, 0);
    for x in low[0]..=high[0] {
        for y in low[1]..=high[1] {
            for z in low[2]..=high[2] {
                let voxel = [x, y, z];
                let (hits, longest) = brute(&grid, &unpacked, voxel);
                let state = o.state(voxel, 2);
                if !grid.span().holds(voxel) {
                    assert_eq!(state, VoxelState::Unknown);
                    continue;
                }
                // Ways shorter than a millionth of a voxel may go either way: rounding at a coordinate of 6 000 000.
                let sure = longest > 1e-6 * grid.voxel;
                let possible = longest > -1e-6 * grid.voxel;
                let told = matches!(state, VoxelState::Empty | VoxelState::Ambiguous);
                assert_eq!(
                    matches!(state, VoxelState::Occupied | VoxelState::Ambiguous),
                    hits >= 2,
                    "{voxel:?}: {hits} returns, {state:?}"
                );
                assert!(!sure || told, "{voxel:?} is missed, {longest}");
                assert!(possible || !told, "{voxel:?} is no beam's way");
                full += usize::from(hits >= 2);
                empty += usize::from(told);
                unknown += usize::from(state == VoxelState::Unknown);
            }
        }
    }
    (full, empty, unknown)
}

#[test]
fn states_are_those_of_brute_force() {
    for (seed, centre) in
        [(1, Vec3::zeros()), (2, Vec3::new(600_000.3, 5_300_000.7, -12.0)), (3, Vec3::new(-6e6, 6e6, 0.0))]
    {
        let region = Aabb { min: centre.into(), max: centre.into() }.expanded(1.6);
        let tile = Aabb { min: centre.into(), max: centre.into() }.expanded(1.25);
        for (tile, margin) in [(tile, 0.0), (Grid::EVERYWHERE, 0.15)] {
            let grid = Grid { exact: true, ..Grid::new(VOXEL, tile, margin, 2.0).unwrap() };
            let patches = scene(seed, centre, 8);
            let (full, empty, unknown) = agrees(grid, &patches, region);
            assert!(full > 5 && empty > 1000 && unknown > 1000, "{full} {empty} {unknown}");
        }
    }
}

#[test]
fn order_and_parts_do_not_matter() {
    let grid = Grid::new(0.05, Aabb { min: [-1.5; 3], max: [1.5; 3] }, 0.02, 2.0).unwrap();
    let mut patches = scene(4, Vec3::zeros(), 12);
    let whole = occupied(grid, &patches);
    let (a, b) = patches.split_at(5);
    let mut merged = occupied(grid, b);
    merged.merge(&occupied(grid, a), NEVER).unwrap();
    assert_eq!(merged, whole);
    patches.reverse();
    assert_eq!(occupied(grid, &patches), whole);
    let other = Grid::new(0.04, grid.tile, 0.02, 2.0).unwrap();
    assert!(merged.merge(&Occupancy::new(other), NEVER).is_err());
}

#[test]
fn runaway_grids_stop() {
    let patches = scene(5, Vec3::zeros(), 6);
    let mut o = Occupancy::new(Grid::new(0.002, Grid::EVERYWHERE, 0.0, 30.0).unwrap());
    let stopped = patches.iter().find_map(|p| o.absorb(p, &AtOnce(1 << 16)).err()).unwrap();
    assert!(matches!(stopped, Error::OutOfMemory { .. }), "{stopped}");
    assert!(o.sorted(NEVER).unwrap().len() < 1 << 16);
}

proptest! {
    /// Axis-parallel and diagonal beams, ends on borders of voxels: no panic, and the way to a return is empty.
    #[test]
    fn beams_on_borders(
        ends in prop::collection::vec(prop::array::uniform3(-6i8..7), 1..40),
        voxel in prop::sample::select(vec![0.1, 0.25, 0.5]),
    ) {
        let offset = |e: &[i8; 3]| Vec3::from(e.map(|c| f64::from(c) * 0.25));
        let grid = Grid { exact: true, ..Grid::new(voxel, Grid::EVERYWHERE, 0.0, 1.0).unwrap() };
        for end in ends.iter().map(offset).filter(|v| v.norm() > 0.0) {
            let beam = Beam { offset: end, returned: true };
            let patch = Patch::encode(0, Vec3::new(1.0, -2.0, 0.5), 0.01, 1e-4, &[beam]).unwrap();
            let o = occupied(grid, &[patch.to_bytes()]);
            let mut hits = 0u32;
            o.for_each(1, NEVER, |_, _, count| hits += u32::from(count)).unwrap();
            prop_assert_eq!(hits, 1);
            let middle = grid.index(&(Vec3::new(1.0, -2.0, 0.5) + end * 0.31)).unwrap();
            let last = grid.index(&(Vec3::new(1.0, -2.0, 0.5) + end)).unwrap();
            let on_border = (0..3).any(|k| (([1.0, -2.0, 0.5][k] + end[k] * 0.31) / voxel).fract().abs() < 1e-6);
            let state = o.state(middle, 1);
            prop_assert!(middle == last || on_border || state == VoxelState::Empty, "{:?} {:?}", end, state);
        }
    }
}

/// A raster of a tripod in a room: a wall with a step in it, a thin post before it.
fn raster(step: f64, axis: Vec3) -> (Vec3, Vec<Beam>, Vec<u8>) {
    let turn = nalgebra::Rotation3::rotation_between(&Vec3::x(), &axis).unwrap();
    let beam = |i: usize| {
        let (a, e) = (((i % 64) as f64 - 32.0) * step, ((i / 64) as f64 - 32.0) * step);
        let range = if (a - 0.02).abs() < 2.0 * step {
            1.1
        } else if e > 0.0 {
            3.0 / a.cos()
        } else {
            2.4
        };
        Beam { offset: turn * Vec3::new(e.cos() * a.cos(), e.cos() * a.sin(), e.sin()) * range, returned: true }
    };
    let beams: Vec<Beam> = (0..4096).map(beam).collect();
    let origin = Vec3::new(0.31, -0.22, 1.57);
    let patch = Patch::encode(1, origin, step, Patch::QUANTUM_M, &beams).unwrap().to_bytes();
    (origin, beams, patch)
}

/// How `exact => false` differs: a voxel filled between rays lies among rays that all reach beyond it; one that is
/// missed is grazed by the outermost rays; returns are the same.
#[test]
fn filling_between_rays_is_bounded() {
    for (k, axis) in
        [Vec3::x(), -Vec3::y(), Vec3::new(0.6, 0.7, -0.4), Vec3::new(-0.5, 0.3, 0.8)].into_iter().enumerate()
    {
        for (step, voxel) in [(0.003, 0.04), (0.008, 0.012)] {
            let (origin, beams, patch) = raster(step, axis.normalize());
            let filled = Grid::new(voxel, Grid::EVERYWHERE, 0.0, 0.0).unwrap();
            let [fast, exact] =
                [filled, Grid { exact: true, ..filled }].map(|g| occupied(g, std::slice::from_ref(&patch)));
            let passed = |o: &Occupancy| {
                let (mut out, mut hits) = (std::collections::BTreeSet::new(), 0u64);
                o.for_each(1, NEVER, |v, state, n| {
                    hits += u64::from(n);
                    if matches!(state, VoxelState::Empty | VoxelState::Ambiguous) {
                        out.insert(v);
                    }
                })
                .unwrap();
                (out, hits)
            };
            let ((fast, fast_hits), (exact, exact_hits)) = (passed(&fast), passed(&exact));
            assert_eq!(fast_hits, exact_hits);
            let (more, less): (Vec<_>, Vec<_>) = (fast.difference(&exact).collect(), exact.difference(&fast).collect());
            // Directions of all rays, and how far they reach.
            let rays: Vec<(Vec3, f64)> = beams.iter().map(|b| (b.offset.normalize(), b.offset.norm())).collect();
            let near = |at: &Vec3, within: f64| {
                let d = at.normalize();
                rays.iter()
                    .filter(move |(r, _)| r.cross(&d).norm() < within && r.dot(&d) > 0.0)
                    .map(|r| r.1)
                    .collect::<Vec<_>>()
            };
            for v in more.iter().step_by(1 + more.len() / 3000) {
                let at = filled.centre(**v) - origin;
                let around = near(&at, 5.0 * step);
                assert!(!around.is_empty(), "{k} {step}: {v:?} lies beside all rays");
                let least = near(&at, 1.4 * step).into_iter().fold(f64::INFINITY, f64::min);
                assert!(least > at.norm() - 1.75 * voxel, "{k} {step}: {v:?} at {} behind {least}", at.norm());
            }
            for v in less.iter().step_by(1 + less.len() / 3000) {
                let at = filled.centre(**v) - origin;
                // It lies in the skin of a surface, which slanting rays say nothing of; or at the border of the raster,
                // where fewer rays are around it than inside.
                let skin = near(&at, (2.5 * step).max(1.25 * voxel / at.norm()))
                    .into_iter()
                    .any(|r| (r - at.norm()).abs() < 6.0 * voxel);
                let around = near(&at, (3.0 * step).max(1.25 * voxel / at.norm())).len() as f64;
                let full = std::f64::consts::PI * ((3.0 * step).max(1.25 * voxel / at.norm()) / step).powi(2);
                assert!(
                    skin || around < 0.85 * full,
                    "{k} {step}: {v:?} at {} inside is missed, {around} of {full:.0} rays, {:?}",
                    at.norm(),
                    near(&at, 2.5 * step)
                );
            }
            assert!(
                exact.len() > 4000 && less.len() as f64 <= 0.2 * exact.len() as f64,
                "{k} {step}: {} of {}",
                less.len(),
                exact.len()
            );
            if step < 0.005 {
                // 3 mrad at 3 m: every voxel of 4 cm inside is passed by a ray.
                assert!(
                    more.len() as f64 <= 0.03 * exact.len() as f64,
                    "{k}: {} more than {}",
                    more.len(),
                    exact.len()
                );
            } else {
                assert!(more.len() as f64 >= 0.1 * exact.len() as f64, "{k}: {} more than {}", more.len(), exact.len());
            }
        }
    }
}
