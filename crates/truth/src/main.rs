//! Verdicts, beliefs and intervals against scenes whose truth is known: `make truth`.

mod building;
mod built;
mod case;
mod survey;
mod truth;

use anyhow::Result;
use asbuilt_core::verify::ModelKind;
use asbuilt_simulate::Scene;
use clap::Parser;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use building::Building;
use built::Built;
use case::{Outcome, Setup};
use survey::Survey;

#[derive(Parser)]
struct Args {
    /// Scenes of the set
    #[arg(long, default_value_t = 28)]
    scenes: usize,
    #[arg(long, default_value_t = 0)]
    from: usize,
    /// Seed of the set
    #[arg(long, default_value_t = 20_260_000)]
    seed: u64,
    /// Evidence models
    #[arg(long)]
    meyer: bool,
}

fn setup(number: usize, seed: u64) -> Result<Setup> {
    let survey = Survey::number(number, seed);
    let mut rng = ChaCha8Rng::seed_from_u64(survey.seed);
    let building = Building::draw(&mut rng)?;
    let built = Built::of(&building, &mut rng)?;
    let places = survey.places(&building, &mut rng);
    let stations: Vec<_> = places.iter().map(|p| building.world_from_plan.point(p)).collect();
    let scene = Scene::new(&built.solids());
    let mut patches = Vec::new();
    for (i, station) in stations.iter().enumerate() {
        patches.extend(survey.scan(&scene, station, i as i64 + 1)?);
    }
    Ok(Setup { number, building, built, survey, scene, stations, patches })
}

fn main() -> Result<()> {
    let args = Args::parse();
    let mut outcomes: Vec<Outcome> = Vec::new();
    for number in args.from..args.scenes {
        let start = std::time::Instant::now();
        let setup = setup(number, args.seed)?;
        let kind = if args.meyer { ModelKind::Meyer2022 } else { ModelKind::Surface };
        let scanned = start.elapsed().as_secs_f64();
        outcomes.extend(setup.outcomes(kind)?);
        eprintln!("scene {number}: scanned {scanned:.1} s, {:.1} s", start.elapsed().as_secs_f64());
    }
    quick(&outcomes);
    Ok(())
}

fn quick(outcomes: &[Outcome]) {
    let n = outcomes.len() as f64;
    let right = |o: &&Outcome| o.expected.verdicts.contains(&o.verdict);
    let border = |o: &Outcome| o.expected.margin < 2.0 * o.survey_sd.max(1e-4);
    println!("cases {n}, right {:.4}", outcomes.iter().filter(right).count() as f64 / n);
    let clear: Vec<&Outcome> = outcomes.iter().filter(|o| !border(o)).collect();
    println!("clear {} right {:.4}", clear.len(), clear.iter().filter(|o| right(&&***o)).count() as f64 / clear.len() as f64);
    let fa = outcomes.iter().filter(|o| o.verdict == asbuilt_core::verify::Verdict::Absent && !right(o)).count();
    println!("false absent {fa}");
    let rank = |l: Option<asbuilt_core::evidence::Loa>| l.map_or(-1, |l| l as i32);
    let judged: Vec<&Outcome> = outcomes.iter().filter(|o| o.expected.verdicts.len() == 1 && o.verdict != asbuilt_core::verify::Verdict::Unobserved).collect();
    let loa = |strict: bool| {
        let ok = judged.iter().filter(|o| {
            let t = rank(o.expected.loa);
            let t = if strict { t } else { t.min(o.provable as i32) };
            let b = rank(o.best_loa);
            b == t || b == t - 1
        }).count();
        ok as f64 / judged.len() as f64
    };
    println!("loa right or one cautious: {:.4} of provable, {:.4} of geometry ({} judged)", loa(false), loa(true), judged.len());
    for (name, f) in [("occupied", (|s: &case::Stated| s.occupied) as fn(&case::Stated) -> f64), ("pignistic", |s| s.pignistic)] {
        let mut bins = [[0f64; 3]; 10];
        for s in outcomes.iter().flat_map(|o| &o.stated) {
            let b = ((f(s) * 10.0) as usize).min(9);
            bins[b][0] += 1.0; bins[b][1] += f(s); bins[b][2] += f64::from(u8::from(s.within));
        }
        let total: f64 = bins.iter().map(|b| b[0]).sum();
        let ece: f64 = bins.iter().map(|b| (b[1] - b[2]).abs()).sum::<f64>() / total;
        println!("ECE {name} {ece:.4} of {total}");
        for b in bins { println!("   {:.4} {:.3} {:.3}", b[0] / total, b[1] / b[0], b[2] / b[0]); }
    }
    let cover = |name: &str, e: Vec<case::Estimate>| {
        let z: Vec<f64> = e.iter().map(|e| (e.value - e.truth) / e.sd).collect();
        let within = z.iter().filter(|z| z.abs() <= 1.96).count() as f64 / z.len() as f64;
        let bias = e.iter().map(|e| e.value - e.truth).sum::<f64>() / e.len() as f64;
        let mut a: Vec<f64> = z.iter().map(|z| z.abs()).collect();
        a.sort_by(f64::total_cmp);
        println!("{name}: {} intervals, cover {within:.4}, bias {:.2} mm, |z| median {:.2}, 95% {:.2}", z.len(), bias * 1e3, a[a.len() / 2], a[a.len() * 95 / 100]);
    };
    cover("deviation", outcomes.iter().filter_map(|o| o.deviation).collect());
    cover("faces", outcomes.iter().flat_map(|o| o.faces.clone()).collect());
    cover("shift", outcomes.iter().flat_map(|o| o.shift.clone()).collect());
    for case in built::Case::ALL {
        let of = |f: fn(&Outcome) -> Vec<case::Estimate>| {
            let e: Vec<_> = outcomes.iter().filter(|o| o.case == case).flat_map(f).collect();
            let bad = e.iter().filter(|e| ((e.value - e.truth) / e.sd).abs() > 1.96).count();
            format!("{bad}/{} bias {:.2}", e.len(), e.iter().map(|e| e.value - e.truth).sum::<f64>() / e.len() as f64 * 1e3)
        };
        println!("{}: deviation {}, faces {}, shift {}", case.name(), of(|o| o.deviation.into_iter().collect()), of(|o| o.faces.clone()), of(|o| o.shift.clone()));
    }
    for reg in [0.0, 0.5, 1.0, 2.0, 3.0] {
        let of = |f: fn(&Outcome) -> Vec<case::Estimate>| {
            let e: Vec<_> = outcomes.iter().filter(|o| (o.registration * 1e3 - reg).abs() < 0.01).flat_map(f).collect();
            let bad = e.iter().filter(|e| ((e.value - e.truth) / e.sd).abs() > 1.96).count();
            format!("{bad}/{}", e.len())
        };
        println!("reg {reg}: deviation {}, faces {}, shift {}", of(|o| o.deviation.into_iter().collect()), of(|o| o.faces.clone()), of(|o| o.shift.clone()));
    }
    for o in outcomes {
        let bad = |e: &case::Estimate| ((e.value - e.truth) / e.sd).abs() > 1.96;
        let show = |e: &case::Estimate| format!("{:.2}±{:.2} true {:.2}", e.value * 1e3, e.sd * 1e3, e.truth * 1e3);
        if let Some(d) = o.deviation.filter(bad) { println!("DEV {} | {}", show(&d), o.account); }
        for f in o.faces.iter().filter(|e| bad(e)) { println!("FACE {} | {}", show(f), o.account); }
        for f in o.shift.iter().filter(|e| bad(e)) { println!("SHIFT {} | {}", show(f), o.account); }
    }
    for o in outcomes.iter().filter(|o| !right(o)) { println!("WRONG {}", o.account); }
    for o in judged { { let t = rank(o.expected.loa).min(o.provable as i32); let b = rank(o.best_loa); if b > t || b < t - 1 { println!("LOA {}", o.account); } } }
}
