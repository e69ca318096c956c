use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::scan::*;
use asbuilt_core::verify::*;
use asbuilt_read::ifc::read_within;
use asbuilt_read::{ReadOptions, read_scans};
use asbuilt_simulate::{Scanner, Scene};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::Path;

fn scanner(step: f64) -> Scanner {
    Scanner { step, sigma_range: 1e-3, sigma_range_per_m: 1e-5, sigma_zero: 1e-4, sigma_angle: 4e-5, sigma_registration: 0.0,
        mixed_pixels: 0.002, max_range: 60.0, min_elevation: -1.05 }
}

fn solids(path: &str) -> Result<Vec<Solid>> {
    let model = read_within(Path::new(path))?;
    let mut out = Vec::new();
    for p in &model.products { if let Some(s) = p.solid()? { out.push(s); } }
    Ok(out)
}

fn free_places(scene: &Scene, solids: &[Solid], n: usize) -> Vec<Vec3> {
    let mut lo = Vec3::repeat(1e9); let mut hi = Vec3::repeat(-1e9);
    for s in solids { for v in s.vertices() { lo = lo.inf(v); hi = hi.sup(v); } }
    let mut out: Vec<Vec3> = Vec::new();
    let dirs: Vec<Vec3> = (0..200).map(|i| { let z = 1.0 - 2.0 * (i as f64 + 0.5) / 200.0; let a = i as f64 * 2.39996; let r = (1.0 - z * z).sqrt(); Vec3::new(r * a.cos(), r * a.sin(), z) }).collect();
    let mut k = 0u64;
    let r = |k: u64, p: f64| (k as f64 * p).fract();
    let mut apart = 4.0;
    while out.len() < n && k < 20000 {
        k += 1;
        let p = Vec3::new(lo.x - 3.0 + (hi.x - lo.x + 6.0) * r(k, 0.819172513), lo.y - 3.0 + (hi.y - lo.y + 6.0) * r(k, 0.671043606), lo.z + 1.0 + (hi.z - lo.z - 1.0) * r(k, 0.549700477));
        let hits: Vec<f64> = dirs.iter().filter_map(|d| scene.first_hit(&p, d)).collect();
        let near = hits.iter().cloned().fold(1e9, f64::min);
        if near > 0.6 && hits.len() > 100 && out.iter().all(|o| (o - p).norm() > apart) { out.push(p); }
        if k % 500 == 0 { apart *= 0.8; }
    }
    out
}

fn fresh(scene: &Scene, place: &Vec3, station: i64, step: f64, no_returns: bool) -> Vec<Vec<u8>> {
    let scan = scanner(step).scan(scene, place, station as u64);
    let w = scan.world_from_scan();
    let beams: Vec<Beam> = scan.shots.iter().filter(|s| no_returns || s.returned).map(|s| Beam { offset: w * s.point, returned: s.returned }).collect();
    let all = Beams::of(beams);
    all.cut(Origins::One, NEVER).unwrap().par_iter().map(|t| {
        let own = all.select(t);
        let frame = PatchFrame { origins: Origins::One, station, origin: scan.registered, quantum: Patch::QUANTUM_M };
        Patch::pack(&frame.spaced(own.spacing(Origins::One)), &own).unwrap().to_bytes()
    }).collect()
}

fn thinned(p: &[Vec<u8>], c: f64) -> Vec<Vec<u8>> { p.par_iter().filter_map(|b| Patch::thinned(b, c).unwrap().map(|p| p.to_bytes())).collect() }

fn agg(p: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let mut g = PatchBuilder::default();
    for b in p {
        let (h, c) = Patch::content_of(b).unwrap();
        for i in 0..c.len() { if c.beams[i].returned {
            g.push(h.station, &Return { point: h.origin + c.end(i), origin: Some(h.origin), intensity: None, colour: None }, NEVER).unwrap();
        } }
    }
    g.patches(NEVER).unwrap().iter().map(|p| p.to_bytes()).collect()
}

fn verdicts(solids: &[Solid], patches: &[Vec<u8>]) -> Vec<Summary> {
    let model = EvidenceModel { spacing: 0.05, ..EvidenceModel::default() };
    let objects: Vec<_> = solids.iter().map(|s| (s.clone(), model)).collect();
    let mut v = Verifier::new(&objects, Threads::Pool, NEVER).unwrap();
    for b in patches.chunks(32) { v.absorb(b, NEVER).unwrap(); }
    v.into_evidence().into_par_iter().map(|e| e.summary(&model.question, &VerdictRule::default(), NEVER).unwrap()).collect()
}

fn compare(name: &str, a: &[Summary], b: &[Summary]) {
    let un = |s: &[Summary]| s.iter().filter(|s| s.verdict == Verdict::Unobserved).count();
    let diff = a.iter().zip(b).filter(|(a, b)| a.verdict != b.verdict).count();
    let off: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a.coverage - b.coverage).abs()).collect();
    println!("{name}: unobserved {} vs {}, verdicts differ {diff}, coverage off by > 0.02: {}, max {:.3}, mean {:.4}, mean coverage {:.3} {:.3}", un(a), un(b),
        off.iter().filter(|o| **o > 0.02).count(), off.iter().cloned().fold(0.0, f64::max), off.iter().sum::<f64>() / off.len() as f64,
        a.iter().map(|s| s.coverage).sum::<f64>() / a.len() as f64, b.iter().map(|s| s.coverage).sum::<f64>() / b.len() as f64);
}

/// median d1/d2, share < 0.8, spread of log d3, mean step, rms d3
fn stats(bytes: &[u8]) -> Option<(f64, f64, f64, f64, f64, usize)> {
    let (h, c) = Patch::content_of(bytes).unwrap();
    let d: Vec<Vec3> = c.beams.iter().map(|b| b.offset.normalize()).collect();
    if d.len() < 30 { return None; }
    let probes = 64.min(d.len());
    let mut ratios = Vec::new(); let mut d3s = Vec::new();
    for p in 0..probes {
        let i = p * d.len() / probes;
        let mut near: Vec<f64> = d.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, o)| (o - d[i]).norm_squared()).collect();
        near.select_nth_unstable_by(2, f64::total_cmp);
        near[..2].sort_by(f64::total_cmp);
        ratios.push((near[0] / near[1].max(1e-30)).sqrt());
        d3s.push(near[2].sqrt());
    }
    ratios.sort_by(f64::total_cmp);
    let share = ratios.iter().filter(|r| **r < 0.8).count() as f64 / ratios.len() as f64;
    let logs: Vec<f64> = d3s.iter().map(|d| d.ln()).collect();
    let mean = logs.iter().sum::<f64>() / logs.len() as f64;
    let sd = (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / logs.len() as f64).sqrt();
    let rms = (d3s.iter().map(|d| d * d).sum::<f64>() / d3s.len() as f64).sqrt();
    Some((ratios[ratios.len() / 2], share, sd, h.spacing.number(), rms, d.len()))
}

fn told(name: &str, patches: &[Vec<u8>]) {
    let all: Vec<_> = patches.par_iter().filter_map(|p| stats(p)).collect();
    let q = |f: &dyn Fn(&(f64, f64, f64, f64, f64, usize)) -> f64| { let mut v: Vec<f64> = all.iter().map(f).collect(); v.sort_by(f64::total_cmp);
        if v.is_empty() { return "-".to_string(); }
        [0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0].map(|p| format!("{:.2}", v[((v.len() - 1) as f64 * p) as usize])).join(" ") };
    println!("{name}: {} patches (min 5 25 50 75 95 max)\n   median d1/d2 {}\n   share<.8     {}\n   sd ln d3     {}\n   rms d3/step  {}", all.len(), q(&|s| s.0), q(&|s| s.1), q(&|s| s.2), q(&|s| s.4 / s.3));
}

fn main() -> Result<()> {
    let args: Vec<String> = std::env::args().collect();
    let model = args.get(2).cloned().unwrap_or("/work/shared/data/ifc-duplex/Duplex_A_20110907.ifc".into());
    match args[1].as_str() {
        "stat" => {
            let s = solids(&model)?; let scene = Scene::new(&s);
            for step in [6e-4, 2e-3, 4e-3, 8e-3] {
                for place in free_places(&scene, &s, 3) {
                    let f = fresh(&scene, &place, 1, step, true);
                    told(&format!("fresh {step} {place:?}"), &f);
                    for c in [0.01, 0.03, 0.1] { let t = thinned(&f, c); told(&format!(" thin {c}"), &t); told(&format!(" thin+agg {c}"), &agg(&t)); }
                }
            }
        }
        "file" => {
            read_scans(Path::new(&args[2]), &ReadOptions::default(), &ProgressBar::hidden(), &mut |mut scan| {
                let mut f = Vec::new();
                asbuilt_read::packing::pack(&mut scan, 1, 0.4, |p| { f.push(p.to_vec()); Ok(()) })?;
                told("file", &f);
                for c in [0.01, 0.03, 0.1] { let t = thinned(&f, c); told(&format!(" thin {c}"), &t); }
                Ok(())
            })?;
        }
        "cmp" => {
            let step: f64 = args[3].parse()?; let n: usize = args[4].parse()?;
            let s = solids(&model)?; let scene = Scene::new(&s);
            let places = free_places(&scene, &s, n);
            println!("{} objects, {} stations, step {step}", s.len(), places.len());
            let scans: Vec<Vec<Vec<u8>>> = places.iter().enumerate().map(|(i, p)| fresh(&scene, p, i as i64 + 1, step, false)).collect();
            let flat = |f: &dyn Fn(&[Vec<u8>]) -> Vec<Vec<u8>>| scans.iter().flat_map(|s| f(s)).collect::<Vec<_>>();
            let base = verdicts(&s, &flat(&|p| p.to_vec()));
            let again = verdicts(&s, &flat(&|p| agg(p)));
            compare("fresh vs agg", &base, &again);
            let retile = |p: &[Vec<u8>]| Patch::retiled(&p.iter().map(|b| &b[..]).collect::<Vec<_>>(), NEVER).unwrap().iter().map(|p| p.to_bytes()).collect::<Vec<_>>();
            for c in [0.01, 0.03, 0.06, 0.1] {
                let t = verdicts(&s, &flat(&|p| thinned(p, c)));
                let a = verdicts(&s, &flat(&|p| agg(&thinned(p, c))));
                let r = verdicts(&s, &flat(&|p| retile(&thinned(p, c))));
                compare(&format!("fresh vs thin {c}"), &base, &t);
                compare(&format!("thin {c} vs agg"), &t, &a);
                compare(&format!("retile thin {c} vs agg"), &r, &a);
            }
        }
        _ => {}
    }
    Ok(())
}
