//! Long work asks for interrupts as it goes: four times the work, about four times the questions; and it stops at once
//! whenever it is told to.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel, VerdictRule};
use asbuilt_core::{Error, Interrupt, NEVER, Result};

/// A slightly wavy sheet of n × n cells of 2 cm.
fn sheet(n: u32) -> Solid {
    let at = |i: u32, j: u32| Vec3::new(0.02 * f64::from(i), 0.02 * f64::from(j), 1e-3 * f64::from((i * j) % 3));
    let vertices = (0..=n).flat_map(|i| (0..=n).map(move |j| at(i, j))).collect();
    let cell = |i: u32, j: u32| {
        let a = i * (n + 1) + j;
        [[a, a + n + 1, a + 1], [a + 1, a + n + 1, a + n + 2]]
    };
    Solid::new(vertices, (0..n).flat_map(|i| (0..n).flat_map(move |j| cell(i, j))).collect()).unwrap()
}

/// Patches over the sheet from 3 m above it.
fn patches(n: u32) -> Vec<Vec<u8>> {
    let origin = Vec3::new(0.01 * f64::from(n), 0.01 * f64::from(n), 3.0);
    let beam = |i: u32, j: u32| Vec3::new(0.02 * f64::from(i), 0.02 * f64::from(j), 0.0) - origin;
    let patch = |i: u32, j: u32| {
        let tile = (i..i + 50).flat_map(|i| (j..j + 50).map(move |j| (i, j)));
        let beams: Vec<Beam> = tile.map(|(i, j)| Beam { offset: beam(i, j), returned: true }).collect();
        Patch::encode(0, origin, 0.007, 1e-4, &beams).unwrap().to_bytes()
    };
    (0..n).step_by(50).flat_map(|i| (0..n).step_by(50).map(move |j| (i, j))).map(|(i, j)| patch(i, j)).collect()
}

type Work<'a> = (&'static str, Box<dyn Fn(Interrupt) -> Result<()> + 'a>);

/// How often `work` asks, after checking that it stops when told at some of these times.
fn questions((what, work): &Work) -> usize {
    let asked = AtomicUsize::new(0);
    let stop_at = |k: usize| {
        asked.store(0, Relaxed);
        work(&|| asked.fetch_add(1, Relaxed) + 1 == k)
    };
    stop_at(usize::MAX).unwrap();
    let total = asked.load(Relaxed);
    for k in (1..=total).step_by(total.div_ceil(10).max(1)) {
        assert_eq!(stop_at(k), Err(Error::Interrupted), "{what}: question {k} of {total}");
        assert_eq!(asked.load(Relaxed), k, "{what} went on after it was told to stop");
    }
    total
}

fn all_questions(n: u32) -> Vec<(&'static str, usize)> {
    let solid = sheet(n);
    let stored = solid.to_bytes(NEVER).unwrap();
    let model = EvidenceModel::default();
    let patches = patches(n);
    let gather = |i: Interrupt| {
        let mut c = Collector::new(&solid, model, i)?;
        patches.iter().try_for_each(|p| c.absorb(p, i))?;
        Ok(c.into_evidence())
    };
    let evidence = gather(NEVER).unwrap();
    let bytes = evidence.to_bytes(NEVER).unwrap();
    let works: [Work; 9] = [
        (
            "make a solid",
            Box::new(|i| Solid::interruptible(solid.vertices().to_vec(), solid.triangles().to_vec(), i).map(drop)),
        ),
        ("write a solid", Box::new(|i| solid.to_bytes(i).map(drop))),
        ("read a solid", Box::new(|i| Solid::from_stored(&stored, i).map(drop))),
        ("prepare a solid", Box::new(|i| Collector::new(&solid, model, i).map(drop))),
        ("gather evidence", Box::new(|i| gather(i).map(drop))),
        ("write evidence", Box::new(|i| evidence.to_bytes(i).map(drop))),
        ("read evidence", Box::new(|i| Evidence::from_bytes(&bytes, i).map(drop))),
        ("add evidence", Box::new(|i| evidence.without_stations().merge(&evidence, i))),
        ("judge evidence", Box::new(|i| evidence.summary(&model.question, &VerdictRule::default(), i).map(drop))),
    ];
    works.iter().map(|w| (w.0, questions(w))).collect()
}

#[test]
fn questions_grow_with_the_work() {
    for (small, large) in all_questions(100).into_iter().zip(all_questions(200)) {
        let growth = large.1 as f64 / small.1 as f64;
        assert!(growth > 1.7, "{}: asks {} times, and {} times for four times the work", small.0, small.1, large.1);
    }
}
