//! The report: docs/truth.md and its pictures.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};
use asbuilt_core::verify::Verdict;

use crate::building::Layout;
use crate::built::Case;
use crate::case::{Outcome, Setup};
use crate::picture;
use crate::tally::{BINS, Intervals, Share, calibration_error, false_absent, has_loa, loa_right, reliability, right};

/// What the report says about a scene.
pub struct SceneLine(String);

impl SceneLine {
    pub fn of(setup: &Setup) -> Self {
        let s = &setup.survey.scanner;
        Self(format!(
            "| {} | {} | {} | {} | {} | {} | {:.0} | {} | {} | {} |",
            setup.number,
            setup.building.layout.name(),
            setup.survey.seed,
            setup.building.objects.len(),
            setup.stations.len(),
            s.step * 1e3,
            setup.survey.max_incidence.to_degrees(),
            s.sigma_range * 1e3,
            s.sigma_registration * 1e3,
            s.mixed_pixels
        ))
    }
}

/// One evidence model's outcomes over the set.
pub struct Results {
    pub model: &'static str,
    pub outcomes: Vec<Outcome>,
}

impl Results {
    fn all(&self) -> impl Iterator<Item = &Outcome> {
        self.outcomes.iter()
    }

    pub fn verdicts(&self) -> Share {
        Share::of(self.all(), |o| right(o))
    }

    pub fn false_absent(&self) -> Share {
        Share::of(self.all(), |o| false_absent(o))
    }

    pub fn loa(&self, capped: bool) -> Share {
        Share::of(self.all().filter(|o| has_loa(o)), |o| loa_right(o, capped))
    }

    pub fn reliability(&self) -> [crate::tally::Bin; BINS] {
        reliability(self.all().flat_map(|o| &o.stated))
    }

    pub fn deviation(&self) -> Intervals {
        Intervals::of(self.all().filter_map(|o| o.deviation))
    }

    pub fn faces(&self) -> Intervals {
        Intervals::of(self.all().flat_map(|o| o.faces.iter().copied()))
    }

    pub fn shift(&self) -> Intervals {
        Intervals::of(self.all().flat_map(|o| o.shift.iter().copied()))
    }

    /// The head of the report, one line per question.
    fn row(&self, what: &str, f: impl Fn(&Self) -> String, other: Option<&Self>) -> String {
        format!("| {what} | {} | {} |\n", f(self), other.map_or_else(String::new, &f))
    }
}

/// What a line of the head takes from a model's results.
type Answer<'a> = &'a dyn Fn(&Results) -> String;

/// The tables as text.
pub fn text(surface: &Results, rays: Option<&Results>) -> String {
    let mut out = String::from("| | `surface` | `meyer2022` |\n| --- | --- | --- |\n");
    let rows: [(&str, Answer); 8] = [
        ("verdict right", &|r| r.verdicts().text()),
        ("said to be absent and is not", &|r| r.false_absent().text()),
        ("best LOA right or one class more cautious, of what the registration can prove", &|r| r.loa(true).text()),
        ("the same, of what was built", &|r| r.loa(false).text()),
        ("expected calibration error", &|r| format!("{:.4}", calibration_error(&r.reliability()))),
        ("95 % interval of the object's deviation holds", &|r| interval(r, r.deviation())),
        ("95 % interval of a face's deviation holds", &|r| interval(r, r.faces())),
        ("95 % interval of the shift holds", &|r| interval(r, r.shift())),
    ];
    for (what, f) in rows {
        out += &surface.row(what, f, rays);
    }
    out
}

fn interval(r: &Results, i: Intervals) -> String {
    if r.model == "surface" { i.text() } else { "states none".into() }
}

fn confusion(r: &Results) -> String {
    const VERDICTS: [Verdict; 5] =
        [Verdict::Confirmed, Verdict::Deviating, Verdict::Absent, Verdict::Unobserved, Verdict::Conflicting];
    let mut out = String::from("| right is | confirmed | deviating | absent | unobserved | conflicting |\n");
    out += "| --- | ---: | ---: | ---: | ---: | ---: |\n";
    let mut kinds: Vec<&[Verdict]> = r.all().map(|o| o.expected.verdicts.as_slice()).collect();
    kinds.sort_by_key(|k| k.iter().map(|v| *v as u8).collect::<Vec<_>>());
    kinds.dedup();
    for kind in kinds {
        let names: Vec<&str> = kind.iter().map(|v| v.name()).collect();
        let count = |v: Verdict| r.all().filter(|o| o.expected.verdicts == kind && o.verdict == v).count().to_string();
        let _ = writeln!(out, "| {} | {} |", names.join(" or "), VERDICTS.map(count).join(" | "));
    }
    out
}

fn by<K: PartialOrd + Copy>(
    r: &Results,
    head: &str,
    name: impl Fn(K) -> String,
    key: impl Fn(&Outcome) -> K,
) -> String {
    let mut keys: Vec<K> = r.all().map(&key).collect();
    keys.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    keys.dedup_by(|a, b| a == b);
    let mut out = format!(
        "| {head} | verdict right | best LOA | deviation holds | shift holds |\n| --- | --- | --- | --- | --- |\n"
    );
    for k in keys {
        let of = || r.outcomes.iter().filter(|o| key(o) == k);
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} |",
            name(k),
            Share::of(of(), |o| right(o)).text(),
            Share::of(of().filter(|o| has_loa(o)), |o| loa_right(o, true)).text(),
            Intervals::of(of().filter_map(|o| o.deviation)).holds.text(),
            Intervals::of(of().flat_map(|o| o.shift.iter().copied())).holds.text(),
        );
    }
    out
}

/// Writes the report and its pictures beside it.
pub fn write(path: &Path, seed: u64, scenes: &[SceneLine], surface: &Results, rays: &Results) -> Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let put = |name: &Path, text: &str| {
        std::fs::write(name, text).with_context(|| format!("{}: cannot write", name.display()))
    };
    let models = [("surface", surface.reliability()), ("meyer2022", rays.reliability())];
    put(&folder.join("truth-reliability.svg"), &picture::reliability(&models))?;
    let (deviation, faces, shift) = (surface.deviation(), surface.faces(), surface.shift());
    let errors = [("deviation of objects", &*deviation.z), ("deviation of faces", &faces.z), ("shift", &shift.z)];
    put(&folder.join("truth-intervals.svg"), &picture::errors(&errors))?;
    let mut bins =
        String::from("| belief | share of samples | mean belief | was within |\n| --- | ---: | ---: | ---: |\n");
    let table = surface.reliability();
    let all: f64 = table.iter().map(|b| b.count).sum();
    for (i, b) in table.iter().enumerate() {
        let low = i as f64 / BINS as f64;
        let (share, stated, kept) = (b.count / all, b.stated / b.count, b.kept / b.count);
        let _ = writeln!(bins, "| {low:.1} - {:.1} | {share:.4} | {stated:.3} | {kept:.3} |", low + 0.1);
    }
    let wrong: String = surface.all().filter(|o| !right(o)).map(|o| format!("- {}\n", o.account)).collect();
    let milli = |x: i64| format!("{} mm", x as f64 / 1e3);
    let micro = |x: f64| (x * 1e6).round() as i64;
    let report = format!(
        include_str!("report.md"),
        cases = surface.outcomes.len(),
        count = scenes.len(),
        seed = seed,
        head = text(surface, Some(rays)),
        confusion = confusion(surface),
        confusion_rays = confusion(rays),
        bins = bins,
        by_case = by(surface, "built", |i: usize| Case::ALL[i].name().into(), |o| o.case as usize),
        by_layout = by(surface, "layout", |l: Layout| l.name().into(), |o| o.layout),
        by_registration = by(surface, "registration σ", milli, |o| micro(o.scanner.sigma_registration)),
        by_range = by(surface, "range σ", milli, |o| micro(o.scanner.sigma_range)),
        by_step = by(surface, "angular step", |x: i64| format!("{} mrad", x as f64 / 1e3), |o| micro(o.scanner.step)),
        wrong = if wrong.is_empty() { "None.\n".into() } else { wrong },
        scenes = scenes.iter().map(|s| format!("{}\n", s.0)).collect::<String>(),
    );
    put(path, &report)
}
