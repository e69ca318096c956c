//! What is narrower than the beams lie apart: no place of it is met by many, all of it together is.

use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::verify::{EvidenceModel, Question, Summary, SurveyObjects, Threads, Verdict, VerdictRule};

/// Beams lie 4 cm apart at the bar.
const STEP: f64 = 0.004;
const DISTANCE: f64 = 10.0;

/// A bar of 25 by 25 mm that is this high, 10 m away.
fn bar(height: f64) -> Solid {
    Solid::cuboid([DISTANCE, 0.005, -0.5 * height], [DISTANCE + 0.025, 0.03, 0.5 * height]).unwrap()
}

/// What is said of a bar of this height where it was built this far behind its place, or not at all; a wall stands 6 m
/// behind.
fn said(height: f64, built: Option<f64>) -> Summary {
    let beams = (-80..80).flat_map(|i| (-80..80).map(move |j| (f64::from(i), f64::from(j))));
    let met = |(i, j): (f64, f64)| {
        let direction = Vec3::new(1.0, STEP * i, STEP * j);
        let at = |x: f64| direction * x;
        let is_on_bar = |p: &Vec3| (0.005..0.03).contains(&p.y) && p.z.abs() < 0.5 * height;
        let bar = built.map(|behind| at(DISTANCE + behind)).filter(is_on_bar);
        Beam { offset: bar.unwrap_or_else(|| at(DISTANCE + 6.0)), returned: true }
    };
    // Along the bar every beam of one column meets it.
    let beams: Vec<Beam> = beams.map(|(i, j)| met((i + 0.4, j))).collect();
    let patches: Vec<Vec<u8>> =
        beams.chunks(4000).map(|b| Patch::encode(1, Vec3::zeros(), STEP, 1e-4, b).unwrap().to_bytes()).collect();
    let question = Question { loa: Loa::Loa20, ..Question::default() };
    let model = EvidenceModel { question, ..EvidenceModel::default() };
    let objects = SurveyObjects::new(vec![(bar(height), model)], Threads::Own, NEVER).unwrap();
    let all = objects.verified(&patches, 8, &VerdictRule::default(), Threads::Own, NEVER).unwrap();
    all[0].1.summary.clone()
}

#[test]
fn many_beams_are_enough_however_narrow_it_is() {
    for (built, verdict) in [(Some(0.0), Verdict::Confirmed), (Some(0.01), Verdict::Confirmed), (None, Verdict::Absent)]
    {
        let summary = said(3.0, built);
        assert_eq!(summary.verdict, verdict, "{built:?}: {summary:?}");
    }
    let as_drawn = said(3.0, Some(0.0));
    assert!(as_drawn.deviation.is_some_and(|(d, sd)| d.abs() < 3.0 * sd), "{as_drawn:?}");
}

#[test]
fn a_few_are_not() {
    for built in [Some(0.0), None] {
        assert_eq!(said(0.8, built).verdict, Verdict::Unobserved, "{built:?}");
    }
}
