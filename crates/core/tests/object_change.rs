//! What became of an object between two epochs.

use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::verify::{
    Evidence, EvidenceModel, ObjectChange, ObjectChangeClass as Class, Question, SurveyObjects, SurveyedEpoch, Threads,
};
use asbuilt_core::{Error, NEVER};

const STEP: f64 = 0.004;
/// Beams a side.
const SIDE: usize = 128;

/// A panel drawn 0.2 m before a wall, both across all beams.
fn drawn() -> [Solid; 2] {
    let slab = |from: f64, to: f64| Solid::cuboid([from, -1.1, -1.1], [to, 1.1, 1.1]).unwrap();
    [slab(4.8, 4.85), slab(5.0, 5.2)]
}

/// What a station at the origin says of panel and wall where it meets planes at x = `distance`, by row and column of its
/// beams, from -1 to 1; nothing where it has no beam.
fn epoch(distance: impl Fn(f64, f64) -> Option<f64>) -> [Evidence; 2] {
    gathered(objects(EvidenceModel::default()), &scanned(distance)).try_into().unwrap()
}

fn objects(model: EvidenceModel) -> Vec<(Solid, EvidenceModel)> {
    drawn().map(|solid| (solid, model)).into()
}

/// The station's patches.
fn scanned(distance: impl Fn(f64, f64) -> Option<f64>) -> Vec<Vec<u8>> {
    let beam = |i: usize| {
        let [y, z] = [i % SIDE, i / SIDE].map(|k| (2.0 * k as f64 + 1.0) / SIDE as f64 - 1.0);
        let half = STEP * 0.5 * SIDE as f64;
        let ray = Vec3::new(1.0, y * half, z * half);
        distance(y, z).map(|x| Beam { offset: ray * x, returned: true })
    };
    let beams: Vec<Beam> = (0..SIDE * SIDE).filter_map(beam).collect();
    let patch = |beams| Patch::encode(1, Vec3::zeros(), STEP, 1e-4, beams).unwrap().to_bytes();
    beams.chunks(4096).map(patch).collect()
}

fn gathered(objects: Vec<(Solid, EvidenceModel)>, patches: &[Vec<u8>]) -> Vec<Evidence> {
    let objects = SurveyObjects::new(objects, Threads::Own, NEVER).unwrap();
    objects.evidence(patches, 1, Threads::Own, NEVER).unwrap()
}

fn there(_: f64, _: f64) -> Option<f64> {
    Some(4.8)
}

fn gone(_: f64, _: f64) -> Option<f64> {
    Some(5.0)
}

fn between(old: &[Evidence; 2], new: &[Evidence; 2]) -> [ObjectChange; 2] {
    [0, 1].map(|i| ObjectChange::between(&old[i], &new[i], NEVER).unwrap())
}

#[test]
fn a_case_for_each_class() {
    let old = epoch(there);
    let moved = |_, _| Some(4.788);
    let registered_otherwise = |_, _| Some(4.8015);
    let half = |y: f64, _| Some(if y < 0.0 { 4.8 } else { 5.0 });
    let a_strip = |y: f64, _| Some(if y < 0.9 { 4.8 } else { 5.0 });
    let tilted = |_, z: f64| Some(4.8 + 0.02 * z);
    let hidden = |y: f64, _| Some(if y < 0.5 { 4.0 } else { 4.8 });
    let all_hidden = |_, _| Some(4.0);
    let nothing = |_, _| None;
    type Distance<'a> = &'a dyn Fn(f64, f64) -> Option<f64>;
    let cases: [(Distance, Class); 9] = [
        (&there, Class::Unchanged),
        (&gone, Class::Gone),
        (&moved, Class::Moved),
        (&registered_otherwise, Class::Unchanged),
        (&half, Class::Partly),
        (&a_strip, Class::Unchanged),
        (&tilted, Class::Moved),
        (&hidden, Class::Unchanged),
        (&all_hidden, Class::NotComparable),
    ];
    for (i, (built, class)) in cases.into_iter().enumerate() {
        let change = between(&old, &epoch(built))[0].clone();
        assert_eq!(change.class, class, "case {i}: {change:?}");
    }
    assert_eq!(between(&old, &epoch(nothing))[0].class, Class::NotComparable);
    // It was hidden by the panel: nothing is known of the wall before.
    assert_eq!(between(&old, &epoch(gone)).map(|c| c.class), [Class::Gone, Class::NotComparable]);
    // Built in neither, and in both.
    assert_eq!(between(&epoch(gone), &epoch(gone)).map(|c| c.class), [Class::Unchanged; 2]);
}

/// The other way round everything is the other way round.
#[test]
fn old_and_new_exchanged() {
    let epochs = [epoch(there), epoch(gone), epoch(|_, _| Some(4.788)), epoch(|y, _| (y < 0.3).then_some(4.81))];
    let reversed = |class| match class {
        Class::Appeared => Class::Gone,
        Class::Gone => Class::Appeared,
        other => other,
    };
    let mut appeared = 0;
    for (a, b) in (0..4).flat_map(|a| (0..4).map(move |b| (a, b))) {
        let [forth, back] = [between(&epochs[a], &epochs[b]), between(&epochs[b], &epochs[a])];
        for (forth, back) in forth.iter().zip(&back) {
            assert_eq!(forth.class, reversed(back.class), "{a} {b}");
            assert_eq!((forth.samples.lost, forth.samples.won), (back.samples.won, back.samples.lost));
            assert_eq!(forth.seen_in_both(), back.seen_in_both());
            let shift = |c: &ObjectChange| c.displacement.as_ref().map(|d| d.shift.vector);
            let sum = shift(forth).zip(shift(back)).map(|(a, b)| (a + b).norm());
            assert!(sum.is_none_or(|s| s < 1e-6), "{sum:?}");
            appeared += u32::from(forth.class == Class::Appeared);
        }
    }
    assert!(appeared > 0);
}

#[test]
fn how_far_it_moved() {
    let old = epoch(there);
    for by in [-0.03, -0.012, 0.002, 0.008, 0.04] {
        let change = between(&old, &epoch(|_, _| Some(4.8 + by)))[0].clone();
        let displacement = change.displacement.expect("both epochs saw its face");
        let (shift, sd) = (displacement.shift.vector, displacement.shift.sd(0));
        assert!(displacement.shift.determines(0) && !displacement.shift.determines(1));
        assert!((shift.x - by).abs() < 2e-4, "{by}: {shift}");
        // One station an epoch, each registered to a millimetre.
        assert!((sd / (0.001 * 2f64.sqrt()) - 1.0).abs() < 0.05, "{sd}");
        assert_eq!(change.class == Class::Moved, by.abs() > 0.0043 * 2f64.sqrt(), "{by}");
    }
}

/// What all stations of an epoch have wrong moves nothing.
#[test]
fn a_datum_moves_nothing() {
    let model = EvidenceModel { sigma_model: 0.003, ..EvidenceModel::default() };
    let [old, new] = [4.8, 4.808].map(|x| gathered(objects(model), &scanned(|_, _| Some(x))));
    let change = ObjectChange::between(&old[0], &new[0], NEVER).unwrap();
    let displacement = change.displacement.expect("both epochs saw its face");
    assert!((displacement.shift.vector.x - 0.008).abs() < 2e-4);
    let sd = 2f64.sqrt() * 0.001f64.hypot(0.003);
    assert!((displacement.shift.sd(0) / sd - 1.0).abs() < 0.05 && (displacement.floor / (3.0 * sd) - 1.0).abs() < 1e-9);
    assert_eq!(change.class, Class::Unchanged);
}

/// What left its place and stands beside it was moved, however far; what stands nowhere near is gone.
#[test]
fn what_stands_beside_its_place_was_moved() {
    let model = EvidenceModel { reach: 0.3, ..EvidenceModel::default() };
    let panel_only = |model| SurveyObjects::new(vec![(drawn()[0].clone(), model)], Threads::Own, NEVER).unwrap();
    let within = |x: f64| move |y: f64, z: f64| Some(if y.abs().max(z.abs()) < 0.85 { x } else { 9.0 });
    let objects = panel_only(model);
    let surveyed = |x: f64| objects.evidence_and_sights(&scanned(within(x)), 1, Threads::Own, NEVER).unwrap();
    let between = |from: f64, to: f64| {
        let [mut old, mut new] = [surveyed(from), surveyed(to)];
        let epochs = [&old.1, &new.1].map(|sights| SurveyedEpoch { objects: &objects, sights });
        ObjectChange::looking_beside(0, [&mut old.0[0], &mut new.0[0]], epochs, NEVER).unwrap()
    };
    for (from, to, class) in
        [(4.8, 5.0, Class::Moved), (5.0, 4.8, Class::Moved), (4.8, 7.0, Class::Gone), (7.0, 4.8, Class::Appeared)]
    {
        let change = between(from, to);
        assert_eq!(change.class, class, "{from} to {to}: {change:?}");
        if class == Class::Moved {
            let shift = change.displacement.expect("the face was seen in both").shift;
            assert!((shift.vector.x - (to - from)).abs() < 3.0 * shift.sd(0), "{shift:?}");
            assert!(shift.determines(0) && !shift.determines(1) && !shift.determines(2));
        }
    }
}

/// Sample by sample, as each epoch says by itself.
#[test]
fn counts_are_those_of_the_beliefs() {
    let question = Question { loa: Loa::Loa20, ..Question::default() };
    // (Seen, there, empty) of every sample.
    let states = |e: &Evidence| {
        let mut out = Vec::new();
        let mut visit = |_: &Vec3, _: &Vec3, b: &asbuilt_core::verify::SampleBelief| {
            out.push((b.seen, b.mass.occupied >= 0.95, b.mass.empty >= 0.95));
        };
        e.for_each_sample(&question, NEVER, &mut visit).unwrap();
        out
    };
    let (old, new) =
        (epoch(|y, _| (y < 0.6).then_some(4.8)), epoch(|y, z| (z < 0.7).then_some(if y < 0.1 { 4.8 } else { 5.0 })));
    for object in 0..2 {
        let change = ObjectChange::between(&old[object], &new[object], NEVER).unwrap().samples;
        let pairs: Vec<_> = states(&old[object]).into_iter().zip(states(&new[object])).collect();
        type State = (bool, bool, bool);
        let count = |hit: fn(&(State, State)) -> bool| pairs.iter().filter(|p| p.0.0 && p.1.0 && hit(p)).count() as u64;
        let counted = [
            count(|_| true),
            count(|(a, b)| a.1 && b.1),
            count(|(a, b)| a.1 && b.2),
            count(|(a, b)| a.2 && b.1),
            count(|(a, b)| a.2 && b.2),
        ];
        assert_eq!(
            [change.seen_in_both, change.lost, change.won, change.empty],
            [counted[0], counted[2], counted[3], counted[4]],
            "{object}"
        );
        // Where few beams are sure by themselves, the surface as a whole still says that it is there.
        assert!((counted[1]..=counted[1] + counted[1] / 20).contains(&change.kept), "{object}: {}", change.kept);
        assert_eq!(change.samples, pairs.len() as u64);
        assert!(object == 1 || change.kept > 100 && change.lost > 100);
    }
}

#[test]
fn different_objects_and_samples_are_refused() {
    let old = epoch(there);
    let other = |o: Error| matches!(o, Error::Mismatch(_));
    assert!(ObjectChange::between(&old[0], &old[1], NEVER).is_err_and(other));
    let coarse = EvidenceModel { spacing: 0.05, ..EvidenceModel::default() };
    let [panel, _] = drawn();
    let coarse = gathered(vec![(panel, coarse)], &[]);
    assert!(ObjectChange::between(&old[0], &coarse[0], NEVER).is_err_and(other));
    assert_eq!(ObjectChange::between(&old[0], &old[0], &|| true), Err(Error::Interrupted));
}
