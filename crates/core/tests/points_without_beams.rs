//! Dense clouds without origin and tie points with their cameras, against a wall whose truth is known.

use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec, Spacing};
use asbuilt_core::uncertain::UncertainPoint;
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel, ModelKind, Summary, Verdict, VerdictRule};
use nalgebra::Matrix3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// A wall 2 m by 2 m, 0.2 m thick, its seen face at x = 0, in a projected system.
const BASE: Vec3 = Vec3::new(600_000.0, 5_300_000.0, 500.0);

fn wall() -> Solid {
    Solid::cuboid((BASE - Vec3::x() * 0.2).into(), (BASE + Vec3::new(0.0, 2.0, 2.0)).into()).unwrap()
}

/// Points in the plane x = `at`, 1 cm apart, with 1 mm noise.
fn cloud(at: f64) -> Vec<Vec3> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let noise = Normal::new(0.0, 0.001).unwrap();
    let place = |i: i32| Vec3::new(at, f64::from(i % 200) * 0.01, f64::from(i / 200) * 0.01);
    (0..40_000).map(|i| BASE + place(i) + Vec3::x() * noise.sample(&mut rng)).collect()
}

fn judged(e: &Evidence) -> Summary {
    let summary = e.summary(&e.model().question, &VerdictRule::default(), NEVER).unwrap();
    let bytes = e.to_bytes(NEVER).unwrap();
    assert_eq!(Evidence::from_bytes(&bytes, NEVER).unwrap().to_bytes(NEVER).unwrap(), bytes);
    summary
}

fn from_cloud(at: f64, model: EvidenceModel) -> Summary {
    let mut c = Collector::new(&wall(), model, NEVER).unwrap();
    for part in cloud(at).chunks(4000) {
        let origin = part[0].map(f64::round);
        let setting = PatchSpec {
            origins: Origins::Unknown,
            station: 7,
            origin,
            spacing: Spacing::Distance(0.01),
            quantum: 1e-4,
        };
        let beams = part.iter().map(|p| Beam { offset: p - origin, returned: true }).collect();
        let patch = Patch::pack(&setting, &Beams::of(beams)).unwrap();
        c.absorb(&patch.to_bytes(), NEVER).unwrap();
    }
    judged(c.evidence())
}

#[test]
fn dense_clouds_say_occupied_or_nothing() {
    let model = EvidenceModel::default();
    let there = from_cloud(0.0, model);
    assert_eq!((there.verdict, there.best_loa), (Verdict::Confirmed, Some(Loa::Loa40)));
    assert!(there.deviation.unwrap().0.abs() < 5e-4 && there.coverage > 0.3, "{there:?}");
    // 30 mm in front: a displaced face. 30 mm behind: no ray says that the face's place is empty.
    let before = from_cloud(0.03, model);
    assert_eq!(before.verdict, Verdict::Deviating, "{before:?}");
    assert!((before.shift.unwrap().vector.x - 0.03).abs() < 1e-3);
    let behind = from_cloud(-0.03, model);
    assert!(!matches!(behind.verdict, Verdict::Absent | Verdict::Confirmed), "{behind:?}");
    assert_eq!(behind.shares.unwrap().confirmed, 0.0);
    // Far away it says nothing.
    let away = from_cloud(3.0, model);
    assert_eq!((away.verdict, away.coverage), (Verdict::Unobserved, 0.0));
    let published = from_cloud(0.0, EvidenceModel { kind: ModelKind::Meyer2022, ..model });
    assert_eq!(published.shares.unwrap().refuted, 0.0, "{published:?}");
}

/// Tie points 2 cm apart on what was built at x = `at`, seen by two cameras.
fn from_tie_points(at: f64, sd: f64) -> Summary {
    let mut c = Collector::new(&wall(), EvidenceModel::default(), NEVER).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let noise = Normal::new(0.0, sd).unwrap();
    let cameras = [Vec3::new(4.0, 0.2, 1.0), Vec3::new(3.5, 1.8, 1.2)].map(|c| BASE + c);
    for _ in 0..20_000 {
        let p = Vec3::new(at + noise.sample(&mut rng), rng.random_range(0.0..2.0), rng.random_range(0.0..2.0));
        let point = UncertainPoint { position: BASE + p, covariance: Matrix3::identity() * sd * sd };
        c.absorb_tie_point(&point, &cameras, NEVER).unwrap();
    }
    judged(c.evidence())
}

#[test]
fn tie_points_confirm_and_their_rays_refute() {
    let there = from_tie_points(0.0, 0.001);
    assert_eq!(there.verdict, Verdict::Confirmed, "{there:?}");
    let gone = from_tie_points(-1.0, 0.001);
    assert_eq!(gone.verdict, Verdict::Absent, "{gone:?}");
    // A point's own uncertainty counts: with 20 mm no 15 mm tolerance is told.
    let loose = from_tie_points(0.0, 0.02);
    assert!(loose.best_loa < there.best_loa, "{loose:?}");
}
