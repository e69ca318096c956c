//! Patches that were thinned, filtered, joined or cut anew tell of objects what patches made anew of the same beams tell.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Patch, PatchBuilder, Return};
use asbuilt_core::verify::{EvidenceModel, Summary, SurveyObjects, Threads, VerdictRule};

const STEP: f64 = 0.006;

type Box3 = ([f64; 3], [f64; 3]);

/// A room of 8 m, with a column, a table and a pipe.
const ROOM: [Box3; 9] = [
    ([-4.0, -3.0, -0.2], [4.0, 3.0, 0.0]),
    ([-4.0, -3.0, 2.8], [4.0, 3.0, 3.0]),
    ([-4.2, -3.0, 0.0], [-4.0, 3.0, 2.8]),
    ([4.0, -3.0, 0.0], [4.2, 3.0, 2.8]),
    ([-4.0, 3.0, 0.0], [4.0, 3.2, 2.8]),
    ([-4.0, -3.2, 0.0], [4.0, -3.0, 2.8]),
    ([2.0, 1.0, 0.0], [2.4, 1.4, 2.8]),
    ([-2.0, 1.2, 0.7], [-0.6, 2.0, 0.74]),
    ([-3.6, -2.5, 2.3], [3.6, -2.4, 2.4]),
];

/// The first of them have no narrow sides.
const WIDE: usize = 6;

fn first(from: &Vec3, d: &Vec3) -> Option<f64> {
    let slab = |(min, max): &Box3| {
        let (mut near, mut far) = (0.0f64, f64::INFINITY);
        for k in 0..3 {
            let (a, b) = ((min[k] - from[k]) / d[k], (max[k] - from[k]) / d[k]);
            (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        }
        (near > 0.0 && near <= far).then_some(near)
    };
    ROOM.iter().filter_map(slab).min_by(f64::total_cmp)
}

/// What a scanner with steps of 6 mrad in azimuth and elevation sees of it.
fn scanned() -> Vec<Vec<u8>> {
    let station = Vec3::new(-0.4, -0.7, 1.6);
    let (rows, columns) = ((2.6 / STEP) as i32, (std::f64::consts::TAU / STEP) as i32);
    let mut returns = Vec::new();
    for (i, j) in (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j))) {
        let (azimuth, elevation) = (f64::from(i) * STEP, f64::from(j) * STEP - 1.05);
        let d = Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin());
        returns.extend(first(&station, &d).map(|range| (station + d * range, station)));
    }
    anew(&returns)
}

/// Patches of these returns, each with where its beam starts, as `ab_scan_agg` makes them.
fn anew(returns: &[(Vec3, Vec3)]) -> Vec<Vec<u8>> {
    let mut builder = PatchBuilder::default();
    for (point, origin) in returns {
        let one = Return { point: *point, origin: Some(*origin), intensity: None, colour: None };
        builder.push(1, &one, NEVER).unwrap();
    }
    builder.patches(NEVER).unwrap().iter().map(Patch::to_bytes).collect()
}

fn returns(patches: &[Vec<u8>]) -> Vec<(Vec3, Vec3)> {
    let all = patches.iter().flat_map(|bytes| {
        let (header, content) = Patch::beams_of(bytes).unwrap();
        content.beams.into_iter().map(move |b| (b.offset + header.origin, header.origin))
    });
    all.collect()
}

fn judged(patches: &[Vec<u8>]) -> Vec<Summary> {
    let model = EvidenceModel { spacing: 0.04, ..EvidenceModel::default() };
    let solids = ROOM.iter().map(|b| (Solid::cuboid(b.0, b.1).unwrap(), model)).collect();
    let objects = SurveyObjects::new(solids, Threads::Own, NEVER).unwrap();
    let all = objects.verified(patches, 16, &VerdictRule::default(), Threads::Own, NEVER).unwrap();
    all.into_iter().map(|(_, judged)| judged.summary).collect()
}

fn each(patches: &[Vec<u8>], edit: impl Fn(&[u8]) -> Option<Patch>) -> Vec<Vec<u8>> {
    patches.iter().filter_map(|p| edit(p)).map(|p| p.to_bytes()).collect()
}

#[test]
fn an_edited_patch_tells_what_one_made_anew_tells() {
    let scan = scanned();
    let thinned = |side: f64| each(&scan, |p| Patch::thinned(p, side).unwrap());
    let retiled = |patches: &[Vec<u8>]| {
        let all: Vec<&[u8]> = patches.iter().map(|p| &**p).collect();
        Patch::retiled(&all, NEVER).unwrap().iter().map(Patch::to_bytes).collect::<Vec<_>>()
    };
    let near = each(&scan, |p| Patch::between(p, 0.0, 3.5).unwrap());
    let every_other = each(&scan, |p| Patch::filtered(p, |_, _, i| i % 3 == 0).unwrap());
    // What the patches are cut into differs, and with it how far apart they hold their beams to be: on slim objects, whose
    // sides are thinned more than what stands around them, that shows in their coverage.
    for (what, edited, in_wide, in_slim) in [
        ("thinned to 2 cm", thinned(0.02), 0.02, 0.06),
        ("thinned to 4 cm", thinned(0.04), 0.02, 0.08),
        ("thinned to 4 cm, cut anew", retiled(&thinned(0.04)), 1e-3, 1e-3),
        ("up to 3.5 m", near, 0.02, 0.06),
        ("every third beam", every_other.clone(), 0.02, 0.02),
        ("every third beam, cut anew", retiled(&every_other), 1e-3, 1e-3),
    ] {
        let (edited, anew) = (judged(&edited), judged(&anew(&returns(&edited))));
        for (object, (a, b)) in edited.iter().zip(&anew).enumerate() {
            let most = if object < WIDE { in_wide } else { in_slim };
            let same = a.verdict == b.verdict && (a.coverage - b.coverage).abs() <= most;
            assert!(same, "{what}, object {object}: {:?} {} and {:?} {}", a.verdict, a.coverage, b.verdict, b.coverage);
        }
    }
}

/// How far apart beams are is what `ab_scan_agg` says of them, whatever was done to the patch.
#[test]
fn the_step_of_an_edited_patch_is_that_of_its_beams() {
    let step = |bytes: &[u8]| Patch::beams_of(bytes).unwrap().0.spacing.number();
    for patch in scanned().iter().step_by(7) {
        for edited in [Patch::thinned(patch, 0.05).unwrap(), Patch::filtered(patch, |_, _, i| i % 5 == 0).unwrap()] {
            let edited = edited.unwrap().to_bytes();
            let found: f64 = anew(&returns(std::slice::from_ref(&edited))).iter().map(|p| step(p)).fold(0.0, f64::max);
            assert!((step(&edited) / found - 1.0).abs() < 0.05, "{} and {found}", step(&edited));
            assert!(step(&edited) > 1.2 * step(patch) || Patch::beams_of(&edited).unwrap().1.len() > 3000);
        }
        // A crop leaves what it keeps as dense as it was, and two halves are as dense as the whole.
        let crop = Patch::between(patch, 0.0, 4.0).unwrap();
        assert!(crop.is_none_or(|crop| step(&crop.to_bytes()) == step(patch)));
        let halves = [0, 1].map(|k| Patch::filtered(patch, |_, _, i| i % 2 == k).unwrap().unwrap().to_bytes());
        let whole = Patch::union(&[&halves[0], &halves[1]], NEVER).unwrap().unwrap();
        assert!((step(&whole.to_bytes()) / step(patch) - 1.0).abs() < 0.05);
    }
}
