//! Objects that know each other: faces that two share, panes and leaves, bodies drawn twice, clouds without origin, and
//! why something was not seen.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Part, Parts, Solid, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec, Spacing};
use asbuilt_core::verify::{
    Evidence, EvidenceModel, Sights, Summary, SurveyObjects, Threads, Unseen, Verdict, VerdictRule, Verifier, Why,
};

const STEP: f64 = 0.004;

/// Beams from `station` towards +x, each with what `range` says of its direction (None: nothing returned).
fn view(station: Vec3, range: impl Fn(&Vec3) -> Option<f64>) -> Vec<Vec<u8>> {
    let mut beams = Vec::new();
    for (i, j) in (-110..110).flat_map(|i| (-110..110).map(move |j| (i, j))) {
        let d = Vec3::new(1.0, f64::from(i) * STEP, f64::from(j) * STEP).normalize();
        let met = range(&d);
        beams.push(Beam { offset: d * met.unwrap_or(1.0), returned: met.is_some() });
    }
    let patch = |beams| Patch::encode(1, station, STEP, 1e-4, beams).unwrap().to_bytes();
    beams.chunks(4000).map(patch).collect()
}

/// The first of these boxes that a ray from a place meets.
fn first(boxes: &[([f64; 3], [f64; 3])], from: Vec3, d: &Vec3) -> Option<f64> {
    let slab = |(min, max): &([f64; 3], [f64; 3])| {
        let (mut near, mut far) = (0.0f64, f64::INFINITY);
        for k in 0..3 {
            let (a, b) = ((min[k] - from[k]) / d[k], (max[k] - from[k]) / d[k]);
            (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        }
        (near > 0.0 && near <= far).then_some(near)
    };
    boxes.iter().filter_map(slab).min_by(f64::total_cmp)
}

fn cuboid(b: &([f64; 3], [f64; 3])) -> Solid {
    Solid::cuboid(b.0, b.1).unwrap()
}

fn objects(solids: &[Solid]) -> SurveyObjects {
    let all = solids.iter().map(|s| (s.clone(), EvidenceModel::default())).collect();
    SurveyObjects::new(all, Threads::Own, NEVER).unwrap()
}

fn judged(solids: &[Solid], patches: &[Vec<u8>]) -> Vec<Summary> {
    let evidence = objects(solids).evidence(patches, 4, Threads::Own, NEVER).unwrap();
    evidence.iter().map(summary).collect()
}

fn summary(e: &Evidence) -> Summary {
    e.summary(&e.model().question, &VerdictRule::default(), NEVER).unwrap()
}

const SLAB: ([f64; 3], [f64; 3]) = ([5.0, -2.0, -2.0], [5.3, 2.0, 2.0]);

/// A rafter drawn inside a slab, its face in the plane of the slab's: seen is that one of them is there.
#[test]
fn a_face_that_two_objects_share_confirms_neither_alone() {
    for depth in [0.0, 0.004, -0.004] {
        let rafter = ([5.0 + depth, -0.06, -1.5], [5.2, 0.06, 1.5]);
        let seen = view(Vec3::zeros(), |d| first(&[SLAB], Vec3::zeros(), d));
        let both = judged(&[cuboid(&SLAB), cuboid(&rafter)], &seen);
        assert_eq!((both[0].verdict, both[1].verdict), (Verdict::Confirmed, Verdict::Unobserved), "{depth}");
        assert_eq!(both[1].best_loa, None);
    }
    // One that stands out of it can be told: there, and missing.
    let rafter = ([4.9, -0.06, -1.5], [5.2, 0.06, 1.5]);
    let there = view(Vec3::zeros(), |d| first(&[SLAB, rafter], Vec3::zeros(), d));
    assert_eq!(judged(&[cuboid(&SLAB), cuboid(&rafter)], &there)[1].verdict, Verdict::Confirmed);
    let missing = view(Vec3::zeros(), |d| first(&[SLAB], Vec3::zeros(), d));
    assert_eq!(judged(&[cuboid(&SLAB), cuboid(&rafter)], &missing)[1].verdict, Verdict::Absent);
}

/// Studs behind a board of 12.5 mm: pressed in by half of that, the board is no stud that stands out; taken off, it lays
/// the studs bare.
#[test]
fn what_lies_between_two_layers_shows_neither() {
    let slab = |from: f64, to: f64| ([from, -2.0, -2.0], [to, 2.0, 2.0]);
    let (board, studs) = (slab(5.0, 5.0125), slab(5.0125, 5.1));
    let drawn = [cuboid(&board), cuboid(&studs)];
    for (built, of_board, of_studs) in [
        (5.0, Verdict::Confirmed, Verdict::Unobserved),
        (5.0065, Verdict::Unobserved, Verdict::Unobserved),
        (5.0125, Verdict::Absent, Verdict::Confirmed),
    ] {
        let seen = view(Vec3::zeros(), |d| first(&[slab(built, 5.1)], Vec3::zeros(), d));
        let said = judged(&drawn, &seen);
        assert_eq!((said[0].verdict, said[1].verdict), (of_board, of_studs), "{built}: {said:?}");
    }
}

/// The same wall in two models is one body; what coincides in part is not.
#[test]
fn a_body_drawn_twice_is_judged_as_one() {
    let again = ([5.002, -2.003, -2.0], [5.3, 2.0, 2.004]);
    let seen = view(Vec3::zeros(), |d| first(&[SLAB], Vec3::zeros(), d));
    let solids = [cuboid(&SLAB), cuboid(&again), cuboid(&([5.0, -2.0, -2.0], [5.3, 1.0, 2.0]))];
    let all = objects(&solids);
    assert_eq!([0, 1, 2].map(|i| all.drawn_twice(i)), [Some(1), Some(0), None]);
    let verdicts: Vec<Verdict> = judged(&solids[..2], &seen).iter().map(|s| s.verdict).collect();
    assert_eq!(verdicts, [Verdict::Confirmed; 2]);
}

/// Frame and pane as parts: what passes the pane says nothing of it, the frame tells of the window.
#[test]
fn glass_and_leaves_count_where_they_were_met() {
    let frame = [
        ([5.0, -0.8, -0.8], [5.06, -0.6, 0.8]),
        ([5.0, 0.6, -0.8], [5.06, 0.8, 0.8]),
        ([5.0, -0.6, -0.8], [5.06, 0.6, -0.6]),
        ([5.0, -0.6, 0.6], [5.06, 0.6, 0.8]),
    ];
    let pane = ([5.02, -0.6, -0.6], [5.03, 0.6, 0.6]);
    let window = |transparent: bool, movable: bool| {
        let (mut vertices, mut triangles, mut part) = (Vec::new(), Vec::new(), Vec::new());
        for (b, number) in frame.iter().map(|b| (b, 0)).chain([(&pane, 1)]) {
            let (solid, start) = (cuboid(b), vertices.len() as u32);
            vertices.extend(solid.vertices());
            triangles.extend(solid.triangles().iter().map(|t| t.map(|v| v + start)));
            part.resize(triangles.len(), number);
        }
        let parts = vec![Part::default(), Part { name: None, is_transparent: transparent, is_movable: movable }];
        Solid::new(vertices, triangles).unwrap().with_parts(Parts::new(part, parts).unwrap()).unwrap()
    };
    let room = ([9.0, -9.0, -9.0], [9.2, 9.0, 9.0]);
    let built: Vec<_> = frame.iter().copied().chain([room]).collect();
    let seen = view(Vec3::zeros(), |d| first(&built, Vec3::zeros(), d));
    let verdict = |window: Solid, seen: &[Vec<u8>]| judged(&[window], seen)[0].verdict;
    assert_eq!(verdict(window(true, false), &seen), Verdict::Confirmed);
    assert_eq!(verdict(window(false, true), &seen), Verdict::Confirmed, "a leaf that stands open");
    assert_ne!(verdict(window(false, false), &seen), Verdict::Confirmed, "an opaque panel that is missing");
    // What is met 25 mm behind a leaf or a pane, its stop or its other side, displaces neither.
    let stop = ([5.045, -0.6, -0.6], [5.06, 0.6, 0.6]);
    let built: Vec<_> = frame.iter().copied().chain([stop, room]).collect();
    let behind = view(Vec3::zeros(), |d| first(&built, Vec3::zeros(), d));
    assert_eq!(verdict(window(true, false), &behind), Verdict::Confirmed);
    assert_eq!(verdict(window(false, true), &behind), Verdict::Confirmed);
    assert_eq!(verdict(window(false, false), &behind), Verdict::Deviating);
    // Without the frame, the window is missing.
    let empty = view(Vec3::zeros(), |d| first(&[room], Vec3::zeros(), d));
    assert_eq!(verdict(window(true, false), &empty), Verdict::Absent);
    // All of it glass: nothing can be said of it, and little where a strip beside its frame was met.
    let only = Parts::new(vec![0; 12], vec![Part { is_transparent: true, ..Part::default() }]).unwrap();
    let panel = cuboid(&pane).with_parts(only).unwrap();
    assert_eq!(verdict(panel.clone(), &empty), Verdict::Unobserved);
    let strip = ([5.02, -0.6, -0.6], [5.03, -0.59, 0.6]);
    let beside = view(Vec3::zeros(), |d| first(&[strip, room], Vec3::zeros(), d));
    let summary = &judged(&[panel], &beside)[0];
    assert!(summary.coverage < 0.1 && summary.verdict != Verdict::Conflicting, "{summary:?}");
}

/// A shelf under glass, and beams that end behind it: at a glancing angle they may show what the glass mirrors.
#[test]
fn what_lies_behind_glass_may_be_a_mirror_image() {
    let under_glass = |pane: ([f64; 3], [f64; 3]), shelf: ([f64; 3], [f64; 3])| {
        let (glass, shelf) = (cuboid(&pane), cuboid(&shelf));
        let vertices = glass.vertices().iter().chain(shelf.vertices()).copied().collect();
        let moved = shelf.triangles().iter().map(|t| t.map(|v| v + glass.vertices().len() as u32));
        let triangles: Vec<[u32; 3]> = glass.triangles().iter().copied().chain(moved).collect();
        let part = (0..triangles.len()).map(|t| u16::from(t >= 12)).collect();
        let parts = vec![Part { is_transparent: true, ..Part::default() }, Part::default()];
        Solid::new(vertices, triangles).unwrap().with_parts(Parts::new(part, parts).unwrap()).unwrap()
    };
    let seen = |solid: Solid, behind| {
        let beams = view(Vec3::zeros(), |d| first(&[behind], Vec3::zeros(), d));
        judged(&[solid], &beams)[0].verdict
    };
    let glancing = under_glass(([3.0, 1.5, -1.2], [6.0, 1.51, 1.2]), ([3.8, 1.6, -0.7], [5.0, 1.62, 0.7]));
    assert_eq!(seen(glancing, ([3.0, 1.72, -2.0], [8.0, 1.8, 2.0])), Verdict::Unobserved);
    let head_on = under_glass(([5.0, -0.7, -0.7], [5.01, 0.7, 0.7]), ([5.1, -0.7, -0.7], [5.12, 0.7, 0.7]));
    assert_eq!(seen(head_on, ([5.22, -2.0, -2.0], [5.3, 2.0, 2.0])), Verdict::Deviating);
}

/// A missing column, its ends in the planes of floor and ceiling, under points without origin.
#[test]
fn floor_and_ceiling_do_not_confirm_a_column_in_a_cloud() {
    let floor = ([-2.0, -2.0, -0.2], [2.0, 2.0, 0.0]);
    let ceiling = ([-2.0, -2.0, 2.5], [2.0, 2.0, 2.7]);
    let column = Solid::cylinder([0.0; 3], 0.15, 2.5, 32).unwrap();
    let grid = |z: f64| {
        (0..40_000).map(move |i| Vec3::new(f64::from(i % 200) * 0.02 - 2.0, f64::from(i / 200) * 0.02 - 2.0, z))
    };
    let pack_some = |points: &[Vec3]| {
        let beams = points.iter().map(|p| Beam { offset: *p, returned: true }).collect();
        let spacing = Spacing::Distance(0.02);
        let spec = PatchSpec { origins: Origins::Unknown, station: 1, origin: Vec3::zeros(), spacing, quantum: 1e-4 };
        Patch::pack(&spec, &Beams::of(beams)).unwrap().to_bytes()
    };
    let pack = |points: Vec<Vec3>| points.chunks(4000).map(pack_some).collect::<Vec<_>>();
    let seen = [pack(grid(0.0).collect()), pack(grid(2.5).collect())].concat();
    let all = judged(&[cuboid(&floor), cuboid(&ceiling), column.clone()], &seen);
    let verdicts: Vec<Verdict> = all.iter().map(|s| s.verdict).collect();
    assert_eq!(verdicts, [Verdict::Confirmed, Verdict::Confirmed, Verdict::Unobserved]);
    // The column itself, seen all around, is confirmed.
    let around = (0..12_000).map(|i| {
        let angle = f64::from(i % 96) / 96.0 * std::f64::consts::TAU;
        Vec3::new(0.15 * angle.cos(), 0.15 * angle.sin(), f64::from(i / 96) * 0.02)
    });
    let seen = [seen, pack(around.collect())].concat();
    assert_eq!(judged(&[cuboid(&floor), cuboid(&ceiling), column], &seen)[2].verdict, Verdict::Confirmed);
}

/// A bench of which the front rail hides nothing but itself: beams that pass a rail and meet the other one, or the board
/// behind, do not displace it.
#[test]
fn a_return_belongs_to_the_nearest_part_of_the_object() {
    let rails: Vec<_> = (0..12)
        .map(|i| {
            let y = -0.66 + 0.11 * f64::from(i);
            ([4.0, y, -0.5], [4.03, y + 0.03, 0.5])
        })
        .chain([([4.09, -0.7, -0.5], [4.12, 0.7, 0.5])])
        .collect();
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for b in &rails {
        let (solid, start) = (cuboid(b), vertices.len() as u32);
        vertices.extend(solid.vertices());
        triangles.extend(solid.triangles().iter().map(|t| t.map(|v| v + start)));
    }
    let bench = Solid::new(vertices, triangles).unwrap();
    // Built 3 mm beside where it is drawn.
    let from = Vec3::new(0.0, 0.003, 0.0);
    let seen = view(Vec3::zeros(), |d| first(&rails, from, d).or(Some(12.0)));
    let found = &judged(std::slice::from_ref(&bench), &seen)[0];
    assert_eq!(found.verdict, Verdict::Confirmed, "{found:?}");
}

fn why(solids: &[Solid], object: u32, patches: &[Vec<u8>]) -> (Option<Unseen>, Option<u32>) {
    let objects = objects(solids);
    let mut sights = Sights::default();
    let batches = objects.batches();
    let mut verifier = Verifier::new(&objects, &batches[0], Threads::Own, NEVER).unwrap();
    verifier.absorb(patches, Some(&mut sights), NEVER).unwrap();
    let mut evidence = verifier.into_evidence().find(|(i, _)| *i == object).unwrap().1;
    assert_eq!(summary(&evidence).verdict, Verdict::Unobserved);
    let hider = objects.judge(object, &mut evidence, &sights, &VerdictRule::default(), NEVER).unwrap().hidden_by;
    let kept = Evidence::from_bytes(&evidence.to_bytes(NEVER).unwrap(), NEVER).unwrap();
    assert_eq!((kept.unseen(), summary(&kept).unseen), (evidence.unseen(), evidence.unseen()));
    (evidence.unseen(), hider)
}

#[test]
fn why_an_object_was_not_seen() {
    let board = ([8.0, -0.5, -0.5], [8.02, 0.5, 0.5]);
    let wall = ([6.0, -4.0, -4.0], [6.2, 4.0, 4.0]);
    let far = ([20.0, -20.0, -20.0], [20.5, 20.0, 20.0]);
    // Seen from in front: half of the board looks away.
    let told = |drawn: &[([f64; 3], [f64; 3])], built: &[([f64; 3], [f64; 3])], from: Vec3| {
        let solids: Vec<Solid> = drawn.iter().map(cuboid).collect();
        let (unseen, hider) = why(&solids, 0, &view(from, |d| first(built, from, d)));
        (unseen.unwrap(), hider)
    };
    let front = |u: &Unseen, why: Why| u.shares()[why as usize] > 0.4;
    let (unseen, hider) = told(&[board, wall, far], &[wall, far, board], Vec3::zeros());
    assert!(front(&unseen, Why::HiddenByObject) && front(&unseen, Why::NotLookedAt), "{unseen:?}");
    assert_eq!(hider, Some(1));
    let (unseen, hider) = told(&[board, far], &[wall, far, board], Vec3::zeros());
    assert!(front(&unseen, Why::HiddenByOther) && hider.is_none(), "{unseen:?}");
    // A wall that nothing shows but its edge, at 84 degrees.
    let along = ([1.0, 0.35, -0.3], [9.0, 0.4, 0.3]);
    let (unseen, _) = told(&[along, far], &[along, far], Vec3::new(-3.0, 0.0, 0.0));
    assert!(unseen.shares()[Why::TooSteep as usize] > 0.3, "{unseen:?}");
    // Behind the station.
    let behind = ([-9.0, -0.5, -0.5], [-8.9, 0.5, 0.5]);
    let (unseen, _) = told(&[behind, far], &[behind, far], Vec3::zeros());
    assert_eq!((unseen.main(), unseen.shares()[Why::NotLookedAt as usize]), (Why::NotLookedAt, 1.0));
    // In the plane of a slab.
    let rafter = ([5.0, -0.3, -1.0], [5.2, 0.3, 1.0]);
    let (unseen, _) = told(&[rafter, SLAB], &[SLAB], Vec3::zeros());
    assert!(unseen.shares()[Why::SharedFace as usize] > 0.3, "{unseen:?}");
}

/// Whatever the batches, whoever is in them: the same evidence to the bit.
#[test]
fn batches_do_not_matter() {
    let mut solids: Vec<Solid> = vec![cuboid(&SLAB)];
    let mut built = vec![SLAB];
    for i in 0..6 {
        let y = -1.5 + 0.5 * f64::from(i);
        let column = ([4.5, y, -1.5], [4.7, y + 0.2, 1.5]);
        solids.push(cuboid(&column));
        solids.push(cuboid(&([4.7, y, -1.5], [5.0, y + 0.2, 1.5])));
        built.extend((i % 2 == 0).then_some(column));
    }
    let from = [Vec3::zeros(), Vec3::new(0.0, 0.7, 0.1)];
    let seen: Vec<Vec<u8>> = from.iter().flat_map(|from| view(*from, |d| first(&built, *from, d))).collect();
    let objects = objects(&solids);
    let whole = objects.evidence(&seen, 4, Threads::Own, NEVER).unwrap();
    assert_eq!(objects.batches().len(), 1);
    for samples in [1.0, 8_000.0, 60_000.0] {
        let batches = objects.batches_of(samples);
        assert!(batches.len() > 1);
        for batch in &batches {
            let mut verifier = Verifier::new(&objects, batch, Threads::Own, NEVER).unwrap();
            verifier.absorb(&seen, None, NEVER).unwrap();
            for (object, evidence) in verifier.into_evidence() {
                assert_eq!(evidence.to_bytes(NEVER).unwrap(), whole[object as usize].to_bytes(NEVER).unwrap());
            }
        }
    }
}
