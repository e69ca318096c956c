//! Edited patches have the step of their beams, and say what patches made anew of the same beams say.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Aabb, Solid, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchBuilder, PatchFrame, Return};
use asbuilt_core::verify::{EvidenceModel, Summary, SurveyObjects, Threads, VerdictRule};
use proptest::prelude::*;

/// The room's length, width and height, metres.
const SIZE: Vec3 = Vec3::new(9.0, 4.0, 3.0);
/// Half the width of a square column that stands in the middle of the room.
const HALF_COLUMN_M: f64 = 0.2;

/// How far a line goes from `from` until it meets a wall of the room or the column, metres.
fn range(from: &Vec3, direction: &Vec3) -> f64 {
    let wall = |k: usize| (if direction[k] > 0.0 { SIZE[k] - from[k] } else { -from[k] }) / direction[k];
    let room = (0..3).map(wall).filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min);
    // Slabs along x and y.
    let slab = |k: usize| {
        let ends = [-HALF_COLUMN_M, HALF_COLUMN_M].map(|side| (SIZE[k] / 2.0 + side - from[k]) / direction[k]);
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    };
    let (x, y) = (slab(0), slab(1));
    let [near, far] = [x[0].max(y[0]), x[1].min(y[1])];
    if near > 0.0 && near < far { near.min(room) } else { room }
}

/// The room scanned in equal steps of azimuth and elevation, as a scanner's patches.
fn scanned(station: i64, origin: Vec3, step: f64) -> Vec<Vec<u8>> {
    let (columns, rows) = ((TAU / step) as usize, (2.4 / step) as usize);
    let direction = |i: usize| {
        let (azimuth, elevation) = ((i / rows) as f64 * step, (i % rows) as f64 * step - 1.0);
        Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin())
    };
    let beam = |d: Vec3| Beam { offset: d * range(&origin, &d), returned: true };
    let all = Beams::of((0..columns * rows).map(direction).map(beam).collect());
    let frame = PatchFrame { origins: Origins::One, station, origin, quantum: Patch::QUANTUM_M };
    let pack = |tile: &Vec<u32>| {
        let own = all.select(tile);
        Patch::pack(&frame.spaced(own.spacing(Origins::One)), &own).unwrap().to_bytes()
    };
    all.cut(Origins::One, NEVER).unwrap().iter().map(pack).collect()
}

/// What `ab_scan_agg` makes of the returns of one station's patches.
fn made_anew(patches: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let mut builder = PatchBuilder::default();
    for (header, content) in patches.iter().map(|p| Patch::content_of(p).unwrap()) {
        for i in (0..content.len()).filter(|i| content.beams[*i].returned) {
            let (point, origin) = (header.origin + content.end(i), Some(header.origin));
            builder.push(header.station, &Return { point, origin, intensity: None, colour: None }, NEVER).unwrap();
        }
    }
    builder.patches(NEVER).unwrap().iter().map(Patch::to_bytes).collect()
}

fn edited(patches: &[Vec<u8>], edit: impl Fn(&[u8]) -> Option<Patch>) -> Vec<Vec<u8>> {
    patches.iter().filter_map(|p| edit(p)).map(|p| p.to_bytes()).collect()
}

fn thinned(patches: &[Vec<u8>], side: f64) -> Vec<Vec<u8>> {
    edited(patches, |p| Patch::thinned(p, side).unwrap())
}

fn within(patches: &[Vec<u8>], bounds: &Aabb) -> Vec<Vec<u8>> {
    edited(patches, |p| Patch::within(p, bounds).unwrap())
}

fn retiled(patches: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let all: Vec<&[u8]> = patches.iter().map(|p| &**p).collect();
    Patch::retiled(&all, NEVER).unwrap().iter().map(Patch::to_bytes).collect()
}

/// Pairs of patches joined.
fn united(patches: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let join = |pair: &[Vec<u8>]| {
        let pair: Vec<&[u8]> = pair.iter().map(|p| &**p).collect();
        Patch::union(&pair, NEVER).unwrap().unwrap().to_bytes()
    };
    patches.chunks(2).map(join).collect()
}

/// The step at every beam, by the place of its return in quanta.
fn steps(patches: &[Vec<u8>]) -> BTreeMap<[i64; 3], f64> {
    let mut out = BTreeMap::new();
    for (header, content) in patches.iter().map(|p| Patch::content_of(p).unwrap()) {
        for (i, beam) in content.beams.iter().enumerate() {
            let step = content.steps.as_ref().map_or(header.spacing.angle(), |steps| steps[i].into());
            out.insert(beam.offset.map(|x| (x / header.quantum).round() as i64).into(), step);
        }
    }
    out
}

/// Steps of the same beams agree within 5 %: beam by beam in the median, and in what all cover.
fn assert_same_steps(edited: &[Vec<u8>], anew: &[Vec<u8>], what: &str) {
    let (edited, anew) = (steps(edited), steps(anew));
    assert!(edited.keys().eq(anew.keys()), "{what}: other beams");
    let mut ratios: Vec<f64> = edited.values().zip(anew.values()).map(|(a, b)| a / b).collect();
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    let area = |s: &BTreeMap<[i64; 3], f64>| s.values().map(|s| s * s).sum::<f64>();
    let covering = (area(&edited) / area(&anew)).sqrt();
    assert!((median - 1.0).abs() < 0.05 && (covering - 1.0).abs() < 0.05, "{what}: {median} {covering}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Whatever changes the density finds the steps anew.
    #[test]
    fn edited_patches_have_the_step_of_their_beams(
        x in 0.6..3.8f64,
        y in 0.6..3.4f64,
        step in 8e-3..16e-3f64,
        side in 0.04..0.2f64,
    ) {
        let fresh = scanned(1, Vec3::new(x, y, 1.6), step);
        let anew = made_anew(&fresh);
        prop_assert!(anew.iter().all(|p| Patch::content_of(p).unwrap().1.steps.is_none()), "a grid has one step");
        assert_same_steps(&anew, &fresh, "made anew");
        assert_same_steps(&retiled(&fresh), &fresh, "cut anew");
        let thin = thinned(&fresh, side);
        let anew = made_anew(&thin);
        assert_same_steps(&thin, &anew, "thinned");
        assert_same_steps(&retiled(&thin), &anew, "thinned and cut anew");
        assert_same_steps(&united(&thin), &anew, "thinned and joined");
        let half = within(&thin, &Aabb::new([0.0; 3], [x + 2.0, 4.0, 3.0]).unwrap());
        assert_same_steps(&half, &made_anew(&half), "thinned and filtered");
        // Thinned twice is thinned once, by the coarser cubes.
        assert_same_steps(&thinned(&thinned(&fresh, 0.5 * side), side), &anew, "thinned twice");
        // Every other beam of a patch makes a sparser one; together they are as dense as before.
        let half = |p: &[u8], first: u32| {
            let (header, content) = Patch::content_of(p).unwrap();
            let own: Vec<u32> = (first..header.beams).step_by(2).collect();
            Some(Patch::pack_found(&header.frame(), content.select(&own)).unwrap())
        };
        let halves = [0, 1].map(|first| edited(&fresh, |p| half(p, first)));
        let pairs: Vec<Vec<u8>> = halves[0].iter().zip(&halves[1]).flat_map(|(a, b)| [a.clone(), b.clone()]).collect();
        assert_same_steps(&united(&pairs), &fresh, "joined");
    }

    /// What is filtered by place keeps its density, and its steps to the bit.
    #[test]
    fn a_filter_keeps_the_steps(x in 0.6..3.8f64, side in 0.04..0.3f64, cut in 1.0..8.0f64) {
        let thin = thinned(&scanned(1, Vec3::new(x, 1.7, 1.6), 0.012), side);
        let before = steps(&thin);
        let near = edited(&thin, |p| Patch::between(p, 1.0, cut).unwrap());
        for kept in [within(&thin, &Aabb::new([0.0; 3], [cut, 4.0, 3.0]).unwrap()), near] {
            prop_assert!(!kept.is_empty() && steps(&kept).iter().all(|(place, step)| before[place] == *step));
            for (header, content) in kept.iter().map(|p| Patch::content_of(p).unwrap()) {
                let widest = content.steps.map(|s| f64::from(s.into_iter().fold(0.0, f32::max)));
                prop_assert_eq!(header.spacing.angle(), widest.unwrap_or(header.spacing.angle()));
            }
        }
    }
}

/// Walls, floor and ceiling as drawn, the column, and another one that is missing.
fn objects() -> Vec<Solid> {
    let (size, thick) = (SIZE, 0.2);
    let wall = |k: usize, low: bool| {
        let (mut min, mut max) = (Vec3::zeros(), size);
        (min[k], max[k]) = if low { (-thick, 0.0) } else { (size[k], size[k] + thick) };
        Solid::cuboid(min.into(), max.into()).unwrap()
    };
    let column = |x: f64, y: f64| {
        let half = HALF_COLUMN_M;
        Solid::cuboid([x - half, y - half, 0.0], [x + half, y + half, size.z]).unwrap()
    };
    let mut out: Vec<Solid> = (0..3).flat_map(|k| [wall(k, true), wall(k, false)]).collect();
    out.extend([column(size.x / 2.0, size.y / 2.0), column(7.5, 1.0)]);
    out
}

fn summaries(objects: &[Solid], patches: &[Vec<u8>]) -> Vec<Summary> {
    let model = EvidenceModel { spacing: 0.05, ..EvidenceModel::default() };
    let objects: Vec<_> = objects.iter().map(|s| (s.clone(), model)).collect();
    let objects = SurveyObjects::new(objects, Threads::Own, NEVER).unwrap();
    let judged = objects.evidence(patches, 64, Threads::Own, NEVER).unwrap().into_iter();
    judged.map(|e| e.summary(&model.question, &VerdictRule::default(), NEVER).unwrap()).collect()
}

/// Two stations' scans, edited, say the same of every object as what is made anew of their beams, and hardly less than
/// the whole scans.
#[test]
fn edited_patches_say_what_their_beams_say() {
    let stations = [scanned(1, Vec3::new(1.3, 1.1, 1.6), 6e-3), scanned(2, Vec3::new(7.0, 3.0, 1.5), 6e-3)];
    let each = |edit: &dyn Fn(&[Vec<u8>]) -> Vec<Vec<u8>>| stations.iter().flat_map(|s| edit(s)).collect::<Vec<_>>();
    let objects = objects();
    let whole = summaries(&objects, &each(&<[_]>::to_vec));
    let same = |edited: &[Summary], anew: &[Summary], what: &str| {
        for (i, (a, b)) in edited.iter().zip(anew).enumerate() {
            assert_eq!(a.verdict, b.verdict, "{what}: object {i}, coverage {} and {}", a.coverage, b.coverage);
            assert!((a.coverage - b.coverage).abs() <= 0.02, "{what}: object {i}, {} and {}", a.coverage, b.coverage);
        }
    };
    same(&whole, &summaries(&objects, &each(&|p| made_anew(p))), "made anew");
    for side in [0.02, 0.04, 0.08] {
        let anew = summaries(&objects, &each(&|p| made_anew(&thinned(p, side))));
        same(&whole, &anew, &format!("{side}: whole"));
        same(&summaries(&objects, &each(&|p| thinned(p, side))), &anew, &format!("{side}: thinned"));
        same(&summaries(&objects, &each(&|p| retiled(&thinned(p, side)))), &anew, &format!("{side}: cut anew"));
        same(&summaries(&objects, &each(&|p| united(&thinned(p, side)))), &anew, &format!("{side}: joined"));
        let part = Aabb::new([-1.0; 3], [6.0, 5.0, 4.0]).unwrap();
        let filtered = each(&|p| within(&thinned(p, side), &part));
        let anew = summaries(&objects, &each(&|p| made_anew(&within(&thinned(p, side), &part))));
        same(&summaries(&objects, &filtered), &anew, &format!("{side}: filtered"));
    }
}
