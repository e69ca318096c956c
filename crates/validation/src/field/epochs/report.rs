//! The numbers of pairs of epochs.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::verify::ObjectChangeClass;

use super::case::Case;
use super::deed::Done;
use crate::field::layout::Kind;
use crate::tally::Share;

const Z95: f64 = 1.959_964;

/// Each question with its answer, and how often each class was said of what was done.
pub fn tables(cases: &[Case]) -> String {
    let right = |of: &dyn Fn(&&Case) -> bool| Share::of(cases.iter().filter(|c| of(c)), |c| c.is_right()).text();
    let mut rows = vec![("class right".to_owned(), right(&|_| true))];
    rows.extend(Done::ALL.map(|done| (format!("— {}", done.name()), right(&|c| c.done == done))));
    rows.extend(Kind::ALL.map(|kind| (format!("— {}", kind.name()), right(&|c| c.kind == kind))));
    let unchanged = || cases.iter().filter(|c| c.is_unchanged());
    let errors: Vec<f64> = cases.iter().flat_map(|c| c.errors.iter().copied()).collect();
    let may_decline = |c: &&&Case| c.right.classes.contains(&ObjectChangeClass::NotComparable);
    rows.extend([
        ("unchanged and called changed".into(), Share::of(unchanged(), |c| c.is_called_changed()).text()),
        ("not_comparable".into(), Share::of(cases, |c| c.is_declined()).text()),
        (
            "not_comparable, though an ideal observer could tell".into(),
            Share::of(cases, |c| c.is_declined() && !may_decline(&c)).text(),
        ),
        ("95 % interval of the shift holds, by axis".into(), Share::of(&errors, |z| z.abs() <= Z95).text()),
    ]);
    let mut out = String::from("| | |\n| --- | --- |\n");
    for (what, share) in rows {
        let _ = writeln!(out, "| {what} | {share} |");
    }
    out + "\n" + &confusion(cases)
}

fn confusion(cases: &[Case]) -> String {
    let names: Vec<&str> = ObjectChangeClass::ALL.iter().map(|c| c.name()).collect();
    let mut out = format!("| done | {} |\n| --- |{}\n", names.join(" | "), " ---: |".repeat(names.len()));
    for done in Done::ALL {
        let count = |class| cases.iter().filter(|c| c.done == done && c.said.class == class).count().to_string();
        let _ = writeln!(out, "| {} | {} |", done.name(), ObjectChangeClass::ALL.map(count).join(" | "));
    }
    out
}

/// Writes a line for every case; the wrong ones first.
pub fn write_cases(path: &Path, cases: &[Case]) -> Result<()> {
    let mut out = format!("{}\n", Case::HEAD);
    for wanted in [false, true] {
        for case in cases.iter().filter(|c| c.is_right() == wanted) {
            let _ = writeln!(out, "{}", case.line());
        }
    }
    std::fs::write(path, out).with_context(|| format!("{}: cannot write", path.display()))
}

/// Writes the report.
pub fn write(path: &Path, tables: &str, cases: &[Case]) -> Result<()> {
    let wrong: String = cases
        .iter()
        .filter(|c| !c.is_right())
        .map(|c| {
            let right: Vec<&str> = c.right.classes.iter().map(|r| r.name()).collect();
            let [x, y, z] = c.moved_mm;
            format!(
                "- scene {} ({}), {} {}, {} ({x:.0}, {y:.0}, {z:.0} mm): {} right, said {}\n",
                c.scene,
                c.model,
                c.class,
                c.name,
                c.done.name(),
                right.join(" or "),
                c.said.class.name()
            )
        })
        .collect();
    let report = format!(include_str!("report.md"), cases = cases.len(), tables = tables, wrong = wrong);
    std::fs::write(path, report).with_context(|| format!("{}: cannot write", path.display()))
}

/// The short set's bounds: what is kept today, with room for the few cases.
pub fn check_short(cases: &[Case]) -> Result<()> {
    let right = Share::of(cases, |c| c.is_right());
    let called = Share::of(cases.iter().filter(|c| c.is_unchanged()), |c| c.is_called_changed());
    if right.value() < 0.85 || right.all < 60 || called.value() > 0.06 {
        bail!("short of what it must show: {} right, {} unchanged called changed", right.text(), called.text());
    }
    Ok(())
}
