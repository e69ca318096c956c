//! Beams of a moving platform against a wall whose truth is known: the same verdicts as from a tripod, and beams that
//! agree with those of one origin where all start at one place.

use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec, Spacing};
use asbuilt_core::verify::{Collector, EvidenceModel, Summary, Verdict, VerdictRule};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

const BASE: Vec3 = Vec3::new(6e6, 6e6, 500.0);
const STEP: f64 = 3e-3;

/// A wall 2 m by 2 m, its seen face at x = 0.
fn wall() -> Solid {
    Solid::cuboid((BASE - Vec3::x() * 0.2).into(), (BASE + Vec3::new(0.0, 2.0, 2.0)).into()).unwrap()
}

/// Profiles of a trolley that moves along y, 4 m in front of what was built at x = `at`.
fn drive(at: f64) -> Beams {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let noise = Normal::new(0.0, 0.001).unwrap();
    let mut content = Beams { starts: Some(Vec::new()), ..Beams::default() };
    for i in 0..160 {
        let start = Vec3::new(4.0, f64::from(i) * 4.0 * STEP, 1.2);
        for k in -80..60 {
            let angle = f64::from(k) * STEP;
            let direction = Vec3::new(-angle.cos(), 0.0, angle.sin());
            let range = (4.0 - at) / angle.cos() + noise.sample(&mut rng);
            content.starts.as_mut().unwrap().push(start);
            content.beams.push(Beam { offset: direction * range, returned: true });
        }
    }
    content
}

fn judged(content: &Beams, origins: Origins, origin: Vec3) -> Summary {
    let setting =
        PatchSpec { origins, station: 7, origin, spacing: Spacing::of(origins, STEP), quantum: Patch::QUANTUM_M };
    let mut c = Collector::new(&wall(), EvidenceModel::default(), NEVER).unwrap();
    let all: Vec<u32> = (0..content.len() as u32).collect();
    for part in all.chunks(4000) {
        let patch = Patch::pack(&setting, &content.select(part)).unwrap();
        c.absorb(&patch.to_bytes(), NEVER).unwrap();
    }
    let e = c.into_evidence();
    assert_eq!(e.stations().len(), 1);
    e.summary(&e.model().question, &VerdictRule::default(), NEVER).unwrap()
}

#[test]
fn moving_beams_confirm_displace_and_refute() {
    let there = judged(&drive(0.0), Origins::Each, BASE);
    assert_eq!(there.verdict, Verdict::Confirmed, "{there:?}");
    assert!(there.best_loa >= Some(Loa::Loa30) && there.deviation.unwrap().0.abs() < 5e-4);
    let displaced = judged(&drive(0.03), Origins::Each, BASE);
    assert_eq!(displaced.verdict, Verdict::Deviating, "{displaced:?}");
    assert!((displaced.shift.unwrap().vector.x - 0.03).abs() < 1e-3);
    let gone = judged(&drive(-3.0), Origins::Each, BASE);
    assert_eq!(gone.verdict, Verdict::Absent, "{gone:?}");
}

/// A sheet without thickness, driven past on both sides: both see it 6 mm along its normal.
#[test]
fn both_sides_of_an_open_surface_agree() {
    let corner = |y: f64, z: f64| BASE + Vec3::new(0.0, y, z);
    let corners = vec![corner(0.0, 0.0), corner(2.0, 0.0), corner(2.0, 2.0), corner(0.0, 2.0)];
    let sheet = Solid::new(corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let mut c = Collector::new(&sheet, EvidenceModel::default(), NEVER).unwrap();
    for side in [1.0, -1.0] {
        let mut content = drive(0.006 * side);
        for (start, beam) in content.starts.as_mut().unwrap().iter_mut().zip(&mut content.beams) {
            (start.x, beam.offset.x) = (start.x * side, beam.offset.x * side);
        }
        let spacing = Spacing::Angle(STEP);
        let setting =
            PatchSpec { origins: Origins::Each, station: 7, origin: BASE, spacing, quantum: Patch::QUANTUM_M };
        for part in (0..content.len() as u32).collect::<Vec<_>>().chunks(4000) {
            c.absorb(&Patch::pack(&setting, &content.select(part)).unwrap().to_bytes(), NEVER).unwrap();
        }
    }
    let e = c.into_evidence();
    let seen = e.summary(&e.model().question, &VerdictRule::default(), NEVER).unwrap();
    assert!((seen.deviation.unwrap().0.abs() - 0.006).abs() < 5e-4, "{seen:?}");
    assert_eq!(seen.verdict, Verdict::Confirmed);
}

#[test]
fn a_platform_that_stands_still_is_a_tripod() {
    let place = Vec3::new(4.0, 1.0, 1.0);
    let beam = |i: i32| {
        let direction = Vec3::new(-1.0, f64::from(i % 120 - 60) * STEP, f64::from(i / 120 - 60) * STEP);
        Beam { offset: direction * 4.0, returned: true }
    };
    let tripod = Beams::of((0..14_400).map(beam).collect());
    let still = Beams { starts: Some(vec![place; tripod.len()]), ..tripod.clone() };
    let (a, b) = (judged(&tripod, Origins::One, BASE + place), judged(&still, Origins::Each, BASE));
    assert_eq!((a.verdict, a.best_loa), (Verdict::Confirmed, b.best_loa));
    assert_eq!(a.verdict, b.verdict);
    assert!((a.coverage - b.coverage).abs() < 0.02, "{} {}", a.coverage, b.coverage);
}
