//! Objects that stand farther from their place than beams are added up there: found by a second look, or not theirs.

use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::verify::{
    Evidence, EvidenceModel, Judged, Question, Summary, SurveyObjects, Threads, Verdict, VerdictRule,
};
use rand::SeedableRng;
use rand_distr::{Distribution, Normal};

/// Coarser than by default.
fn model() -> EvidenceModel {
    EvidenceModel { spacing: 0.05, ..EvidenceModel::default() }
}

type Box3 = ([f64; 3], [f64; 3]);

const STEP: f64 = 0.006;
const PANEL: Box3 = ([5.0, -1.5, -1.2], [5.12, 1.5, 1.2]);
const FAR: Box3 = ([12.0, -20.0, -20.0], [12.5, 20.0, 20.0]);

/// The first of these boxes that a ray from the origin meets.
fn first(boxes: &[Box3], d: &Vec3) -> Option<f64> {
    let slab = |(min, max): &Box3| {
        let (mut near, mut far) = (0.0f64, f64::INFINITY);
        for k in 0..3 {
            let (a, b) = (min[k] / d[k], max[k] / d[k]);
            (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        }
        (near > 0.0 && near <= far).then_some(near)
    };
    boxes.iter().filter_map(slab).min_by(f64::total_cmp)
}

/// Beams from the origin towards +x among these boxes, with a noise of 1 mm.
fn scan(built: &[Box3]) -> Vec<Vec<u8>> {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(11);
    let noise = Normal::new(0.0, 0.001).unwrap();
    let mut beams = Vec::new();
    for (i, j) in (-75..75).flat_map(|i| (-75..75).map(move |j| (i, j))) {
        let d = Vec3::new(1.0, f64::from(i) * STEP, f64::from(j) * STEP).normalize();
        if let Some(range) = first(built, &d) {
            beams.push(Beam { offset: d * (range + noise.sample(&mut rng)), returned: true });
        }
    }
    beams.chunks(4000).map(|b| Patch::encode(1, Vec3::zeros(), STEP, 1e-4, b).unwrap().to_bytes()).collect()
}

/// What is said of the first of these drawn boxes.
fn judged(drawn: &[Box3], built: &[Box3], model: EvidenceModel) -> (Evidence, Judged) {
    let solids = drawn.iter().map(|b| (Solid::cuboid(b.0, b.1).unwrap(), model)).collect();
    let objects = SurveyObjects::new(solids, Threads::Own, NEVER).unwrap();
    let all = objects.verified(&scan(built), 4, &VerdictRule::default(), Threads::Own, NEVER).unwrap();
    all.into_iter().next().unwrap()
}

fn said(drawn: &[Box3], built: &[Box3]) -> Summary {
    judged(drawn, built, model()).1.summary
}

fn moved(b: Box3, x: f64) -> Box3 {
    let by = |mut c: [f64; 3]| {
        c[0] += x;
        c
    };
    (by(b.0), by(b.1))
}

/// Its front looks towards -x: moved by x along that, the face deviates by -x along its normal.
#[test]
fn a_displaced_panel_has_a_number_up_to_the_reach() {
    for mm in [-280, -200, -120, -105, -95, -80, 60, 80, 120, 140, 155, 170, 200, 280] {
        let x = f64::from(mm) * 1e-3;
        let (evidence, Judged { summary, .. }) = judged(&[PANEL, FAR], &[moved(PANEL, x), FAR], model());
        assert_eq!(summary.verdict, Verdict::Deviating, "{mm}: {summary:?}");
        let (deviation, sd) = summary.deviation.unwrap_or_else(|| panic!("{mm}: {summary:?}"));
        assert!((deviation + x).abs() < (3.0 * sd).max(0.002), "{mm}: {deviation} ± {sd}");
        assert!(summary.deviation_face.unwrap().1.x < -0.99 && summary.best_loa.is_none_or(|l| l == Loa::Loa10));
        // What is stored says the same.
        let stored = Evidence::from_bytes(&evidence.to_bytes(NEVER).unwrap(), NEVER).unwrap();
        let question = stored.model().question;
        assert_eq!(stored.summary(&question, &VerdictRule::default(), NEVER).unwrap(), summary);
        let why = stored.explain(&question, &VerdictRule::default(), NEVER).unwrap();
        let side = if deviation > 0.0 { "outside" } else { "inside" };
        assert!(why.contains(&format!("{:.1} mm {side} the drawing", 1e3 * deviation.abs())), "{mm}: {why}");
    }
}

/// Cupboards that nobody drew hide most of a displaced panel: what is left of it is its place.
#[test]
fn what_hides_a_displaced_panel_does_not_speak_against_it() {
    let near = ([4.6, -1.5, -1.2], [4.7, 0.3, 1.2]);
    let nearer = ([3.5, -1.1, -0.9], [4.0, 0.4, 0.9]);
    for (x, hidden_by) in [(-0.12, nearer), (-0.2, nearer), (0.2, near), (0.2, nearer), (0.28, near)] {
        let summary = said(&[PANEL, FAR], &[moved(PANEL, x), hidden_by, FAR]);
        assert_eq!(summary.verdict, Verdict::Deviating, "{x}: {summary:?}");
        let (deviation, sd) = summary.deviation.unwrap_or_else(|| panic!("{x}: {summary:?}"));
        assert!((deviation + x).abs() < (3.0 * sd).max(0.002), "{x}: {deviation} ± {sd}");
        // Where the panel is missing, they are not taken for it.
        let missing = said(&[PANEL, FAR], &[hidden_by, FAR]);
        assert!(matches!(missing.verdict, Verdict::Absent | Verdict::Unobserved), "{x}: {missing:?}");
        assert_eq!(missing.deviation, None);
    }
}

#[test]
fn it_is_looked_for_as_far_as_asked() {
    let built = [moved(PANEL, 0.4), FAR];
    assert_eq!(said(&[PANEL, FAR], &built).verdict, Verdict::Absent);
    let farther = EvidenceModel { reach: 0.5, ..model() };
    let (evidence, Judged { summary, .. }) = judged(&[PANEL, FAR], &built, farther);
    assert_eq!(summary.verdict, Verdict::Deviating);
    assert!((summary.deviation.unwrap().0 + 0.4).abs() < 0.005, "{summary:?}");
    // Evidence itself does not depend on how far somebody looked.
    assert_eq!(*evidence.model(), model());
    let none = EvidenceModel { reach: 0.0, ..model() };
    assert_eq!(judged(&[PANEL, FAR], &[moved(PANEL, 0.2), FAR], none).1.summary.verdict, Verdict::Absent);
}

/// Of a missing panel nothing else makes a displaced one.
#[test]
fn what_is_not_the_panel_does_not_displace_it() {
    let hidden = Verdict::Unobserved;
    let cases: [(&str, &[Box3], &[Box3], Verdict); 8] = [
        ("nothing", &[], &[], Verdict::Absent),
        (
            "a wall drawn behind",
            &[([5.2, -3.0, -3.0], [5.4, 3.0, 3.0])],
            &[([5.2, -3.0, -3.0], [5.4, 3.0, 3.0])],
            Verdict::Absent,
        ),
        ("a wall that nobody drew, behind", &[], &[([5.2, -3.0, -3.0], [5.4, 3.0, 3.0])], Verdict::Absent),
        ("a small thing behind", &[], &[([5.2, -0.6, -0.6], [5.4, 0.6, 0.5])], Verdict::Absent),
        (
            "a slanting thing behind",
            &[],
            &[
                ([5.16, -1.5, -1.2], [5.2, -0.5, 1.2]),
                ([5.2, -0.5, -1.2], [5.24, 0.5, 1.2]),
                ([5.25, 0.5, -1.2], [5.29, 1.5, 1.2]),
            ],
            Verdict::Absent,
        ),
        ("a larger thing before it", &[], &[([4.75, -1.9, -1.6], [4.8, 1.9, 1.6])], hidden),
        (
            "what is drawn on it, displaced",
            &[([4.98, -1.5, -1.2], [5.0, 1.5, 1.2])],
            &[([4.86, -1.5, -1.2], [4.88, 1.5, 1.2]), PANEL],
            hidden,
        ),
        (
            "an object drawn before it",
            &[([4.75, -1.5, -1.2], [4.8, 1.5, 1.2])],
            &[([4.75, -1.5, -1.2], [4.8, 1.5, 1.2])],
            hidden,
        ),
    ];
    for (what, drawn, built, expected) in cases {
        let drawn: Vec<Box3> = [PANEL, FAR].into_iter().chain(drawn.iter().copied()).collect();
        let built: Vec<Box3> = built.iter().copied().chain([FAR]).collect();
        let summary = said(&drawn, &built);
        assert_eq!((summary.verdict, summary.deviation), (expected, None), "{what}: {summary:?}");
    }
}

/// Found 0.12 m off, the panel is out of LOA20 and within LOA10: asked of the same evidence.
#[test]
fn what_was_found_within_the_tolerance_displaces_nothing() {
    let (evidence, _) = judged(&[PANEL, FAR], &[moved(PANEL, -0.12), FAR], model());
    let said = |loa| {
        let question = Question { loa, ..Question::default() };
        evidence.summary(&question, &VerdictRule::default(), NEVER).unwrap().verdict
    };
    assert_eq!(said(Loa::Loa20), Verdict::Deviating);
    assert_ne!(said(Loa::Loa10), Verdict::Deviating);
}
