//! Objects verified together, and beams that count for less.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec, Spacing};
use asbuilt_core::verify::{
    Collector, Evidence, EvidenceModel, IntensityNoise, SurveyObjects, Threads, Verdict, VerdictRule,
};

const STEP: f64 = 0.004;

/// Beams from the origin of `station` that meet the plane x = `distance`, in four patches.
fn patches(
    station: i64,
    origin: Vec3,
    distance: impl Fn(usize) -> f64,
    intensity: Option<fn(usize) -> u16>,
) -> Vec<Vec<u8>> {
    let ray = |i: usize| Vec3::new(1.0, (i % 128) as f64 * STEP - 0.256, (i / 128) as f64 * STEP - 0.256);
    let beams: Vec<Beam> = (0..128 * 128).map(|i| Beam { offset: ray(i) * distance(i), returned: true }).collect();
    let pack = |part: usize| {
        let own = part * 4096..(part + 1) * 4096;
        let intensity = intensity.map(|of| own.clone().map(of).collect());
        let content = Beams { beams: beams[own].to_vec(), intensity, ..Beams::default() };
        let setting =
            PatchSpec { origins: Origins::One, station, origin, spacing: Spacing::Angle(STEP), quantum: 1e-4 };
        Patch::pack(&setting, &content).unwrap().to_bytes()
    };
    (0..4).map(pack).collect()
}

fn alone(solid: &Solid, model: EvidenceModel, patches: &[Vec<u8>]) -> Evidence {
    let mut c = Collector::new(solid, model, NEVER).unwrap();
    patches.iter().for_each(|p| c.absorb(p, NEVER).unwrap());
    c.into_evidence()
}

fn together(objects: &[(Solid, EvidenceModel)], patches: &[Vec<u8>], threads: Threads, batch: usize) -> Vec<Evidence> {
    let objects = SurveyObjects::new(objects.to_vec(), threads, NEVER).unwrap();
    objects.evidence(patches, batch, threads, NEVER).unwrap()
}

#[test]
fn batches_and_threads_change_nothing() {
    let model = EvidenceModel::default();
    let wall = Solid::cuboid([5.0, -1.0, -1.0], [5.2, 1.0, 1.0]).unwrap();
    let column = Solid::cylinder([3.0, 0.2, -1.0], 0.2, 2.0, 32).unwrap();
    let mut all = patches(1, Vec3::zeros(), |_| 5.0, None);
    all.extend(patches(2, Vec3::new(-1.0, 0.3, 0.1), |i| 6.0 + 0.001 * (i % 3) as f64, None));
    let objects = [(wall.clone(), model), (column.clone(), EvidenceModel { spacing: 0.03, ..model })];
    let one = together(&objects, &all, Threads::Own, 1);
    for (threads, batch) in [(Threads::Own, 3), (Threads::Pool, 8), (Threads::Pool, 1)] {
        assert_eq!(together(&objects, &all, threads, batch), one);
    }
    // Nothing hides either from the other: each by itself says the same.
    for ((solid, model), e) in objects.iter().zip(&one) {
        assert_eq!(alone(solid, *model, &all).stations(), e.stations());
    }
    let verdict = |e: &Evidence| e.verdict(&e.model().question, &VerdictRule::default(), NEVER).unwrap();
    assert_eq!((verdict(&one[0]), verdict(&one[1])), (Verdict::Confirmed, Verdict::Absent));
}

#[test]
fn a_drawn_cladding_does_not_displace_the_wall_behind_it() {
    let model = EvidenceModel::default();
    let wall = Solid::cuboid([5.05, -1.0, -1.0], [5.25, 1.0, 1.0]).unwrap();
    let cladding = Solid::cuboid([5.0, -1.0, -1.0], [5.05, 1.0, 1.0]).unwrap();
    let seen = patches(1, Vec3::zeros(), |_| 5.0, None);
    let verdict = |e: &Evidence| e.verdict(&e.model().question, &VerdictRule::default(), NEVER).unwrap();
    assert_eq!(verdict(&alone(&wall, model, &seen)), Verdict::Deviating);
    let both = together(&[(wall.clone(), model), (cladding.clone(), model)], &seen, Threads::Own, 4);
    assert_eq!((verdict(&both[0]), verdict(&both[1])), (Verdict::Unobserved, Verdict::Confirmed));
    // Without it, beams that met the wall pierced its place.
    let bare = patches(1, Vec3::zeros(), |_| 5.05, None);
    let both = together(&[(wall.clone(), model), (cladding.clone(), model)], &bare, Threads::Own, 4);
    assert_eq!((verdict(&both[0]), verdict(&both[1])), (Verdict::Confirmed, Verdict::Absent));
    assert_eq!(verdict(&alone(&cladding, model, &bare)), Verdict::Deviating);
    // Where the cladding is 30 mm off, it explains nothing.
    let off = patches(1, Vec3::zeros(), |_| 4.97, None);
    let both = together(&[(wall, model), (cladding, model)], &off, Threads::Own, 4);
    assert_eq!(verdict(&both[1]), Verdict::Deviating);
}

/// Plaster is off its place; the wall behind it, drawn against it, cannot be what was met.
#[test]
fn displaced_plaster_does_not_displace_the_wall_that_it_covers() {
    let model = EvidenceModel::default();
    let wall = Solid::cuboid([5.015, -1.0, -1.0], [5.25, 1.0, 1.0]).unwrap();
    let plaster = Solid::cuboid([5.0, -1.0, -1.0], [5.015, 1.0, 1.0]).unwrap();
    let verdict = |e: &Evidence| e.verdict(&e.model().question, &VerdictRule::default(), NEVER).unwrap();
    for off in [0.02, 0.03, 0.07] {
        let seen = patches(1, Vec3::zeros(), |_| 5.0 - off, None);
        let both = together(&[(wall.clone(), model), (plaster.clone(), model)], &seen, Threads::Own, 4);
        assert_eq!((verdict(&both[0]), verdict(&both[1])), (Verdict::Unobserved, Verdict::Deviating), "{off}");
    }
}

/// No beam aimed at a pole meets it where it is displaced by more than its thickness; those beside it do.
#[test]
fn a_slim_pole_beside_its_place_is_not_absent() {
    let model = EvidenceModel::default();
    let wall = Solid::cuboid([6.0, -2.0, -2.0], [6.2, 2.0, 2.0]).unwrap();
    // Along (1, y, z), the nearer root of |(t, ty) - (4, cy)| = r.
    let with_pole = |cy: f64, r: f64| {
        patches(
            1,
            Vec3::zeros(),
            move |i| {
                let y = (i % 128) as f64 * STEP - 0.256;
                let (a, b, c) = (1.0 + y * y, -2.0 * (4.0 + y * cy), 16.0 + cy * cy - r * r);
                let discriminant = b * b - 4.0 * a * c;
                if discriminant < 0.0 { 6.0 } else { (-b - discriminant.sqrt()) / (2.0 * a) }
            },
            None,
        )
    };
    for radius in [0.02, 0.03, 0.04] {
        let pole = Solid::cylinder([4.0, 0.0, -1.0], radius, 2.0, 24).unwrap();
        let verdict = |seen: &[Vec<u8>]| {
            let both = together(&[(wall.clone(), model), (pole.clone(), model)], seen, Threads::Own, 4);
            both[1].verdict(&model.question, &VerdictRule::default(), NEVER).unwrap()
        };
        assert_eq!(verdict(&with_pole(0.0, radius)), Verdict::Confirmed, "{radius}");
        for off in [0.03, 0.045, 0.06] {
            assert_eq!(verdict(&with_pole(off, radius)), Verdict::Deviating, "{radius} {off}");
        }
        assert_eq!(verdict(&patches(1, Vec3::zeros(), |_| 6.0, None)), Verdict::Absent, "{radius}");
    }
}

/// Something undrawn stands in front of a face; the face is behind it, however little of it is left to see.
#[test]
fn a_cupboard_does_not_displace_the_wall_that_it_hides() {
    let model = EvidenceModel::default();
    let wall = Solid::cuboid([5.0, -1.2, -1.2], [5.2, 1.2, 1.2]).unwrap();
    let judged = |hidden: f64| {
        let edge = (128.0 * hidden) as usize;
        let seen = patches(1, Vec3::zeros(), |i| if i % 128 < edge { 4.9 } else { 5.004 }, None);
        alone(&wall, model, &seen).summary(&model.question, &VerdictRule::default(), NEVER).unwrap()
    };
    for hidden in [0.3, 0.5, 0.65] {
        let s = judged(hidden);
        assert_eq!(s.verdict, Verdict::Confirmed, "{hidden}");
        let (deviation, sd) = s.deviation.unwrap();
        assert!((deviation + 0.004).abs() < 3.0 * sd, "{hidden}: {deviation} ± {sd}");
    }
    // All of it in front: the wall itself was built there.
    assert_eq!(judged(1.0).verdict, Verdict::Deviating);
}

#[test]
fn dark_beams_are_worth_less() {
    let wall = Solid::cuboid([5.0, -1.0, -1.0], [5.2, 1.0, 1.0]).unwrap();
    // Every other beam is dark, and 9 mm off.
    let seen = patches(
        1,
        Vec3::zeros(),
        |i| if i % 2 == 0 { 5.0 } else { 5.009 },
        Some(|i| if i % 2 == 0 { 4000 } else { 40 }),
    );
    let plain = EvidenceModel::default();
    let noise = Some(IntensityNoise::new(2000, 1.0).unwrap());
    let deviation = |model: EvidenceModel| {
        alone(&wall, model, &seen)
            .summary(&model.question, &VerdictRule::default(), NEVER)
            .unwrap()
            .deviation
            .unwrap()
            .0
    };
    assert!((deviation(plain) + 0.0045).abs() < 1e-3, "{}", deviation(plain));
    // Shares 1 and 1/50.
    let expected = -0.009 / 51.0;
    let found = deviation(EvidenceModel { intensity: noise, ..plain });
    assert!((found - expected).abs() < 2e-4, "{found} {expected}");
}
