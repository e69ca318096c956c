//! The report: tables as text, and docs/truth-field.md.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};

use super::cases::Case;
use super::layout::Kind;
use super::patches::Delivery;
use super::scene::Scene;
use super::score::Score;

const DELIVERIES: [Delivery; 2] = [Delivery::Stations, Delivery::Merged];

/// The head of the report.
pub fn tables(score: &Score) -> String {
    let mut out = String::from("| | by station | merged, without origins |\n| --- | --- | --- |\n");
    let [stations, merged] = DELIVERIES.map(|d| score.rows(d));
    for ((what, a), (_, b)) in stations.iter().zip(&merged) {
        let _ = writeln!(out, "| {what} | {a} | {b} |");
    }
    out
}

/// A scene in one line.
pub fn scene_line(scene: &Scene) -> String {
    let plan = &scene.plan;
    let receiver = &plan.scanner.receiver;
    format!(
        "| {} | {} | {} | {} | {} | {:.1} | {:.1} | {} | {} |",
        plan.number,
        plan.name(),
        plan.seed,
        scene.layout.objects.len(),
        scene.stations.len(),
        plan.scanner.step * 1e3,
        receiver.sigma(asbuilt_fieldscan::Receiver::WHITE_AT_10_M) * 1e3,
        receiver.resolution_m,
        plan.registration.sigma_place_m * 1e3,
    )
}

fn confusion(score: &Score, delivery: Delivery) -> String {
    let names: Vec<&str> = Score::VERDICTS.iter().map(|v| v.name()).collect();
    let mut out = format!("| right is | {} |\n| --- |{}\n", names.join(" | "), " ---: |".repeat(5));
    for (right, counts) in score.confusion(delivery) {
        let _ = writeln!(out, "| {right} | {} |", counts.map(|n| n.to_string()).join(" | "));
    }
    out
}

fn bins(score: &Score, delivery: Delivery) -> String {
    let mut out = String::from("| belief | samples | mean belief | was within |\n| --- | ---: | ---: | ---: |\n");
    for b in score.bins(delivery) {
        let _ = writeln!(out, "| {:.3} - {:.3} | {} | {:.3} | {:.3} |", b.from, b.to, b.count, b.stated, b.kept);
    }
    out
}

fn wrong(score: &Score, delivery: Delivery) -> String {
    let line = |c: &Case| {
        let right: Vec<&str> = c.right.verdicts.iter().map(|v| v.name()).collect();
        let [x, y, z] = c.displaced_mm;
        format!(
            "- scene {}, {} {}, {} ({x:.0}, {y:.0}, {z:.0} mm), {}: {} right, said {}\n",
            c.scene,
            c.class,
            c.name,
            c.deed.name(),
            c.loa.name(),
            right.join(" or "),
            c.said.name()
        )
    };
    score.of_delivery(delivery).filter(|c| !c.is_right()).map(line).collect()
}

/// Writes the report.
pub fn write(path: &Path, seed: u64, score: &Score, scenes: &[String]) -> Result<()> {
    let by_station = || score.of_delivery(Delivery::Stations);
    let count = |hit: &dyn Fn(&&Case) -> bool| by_station().filter(|c| hit(c)).count();
    let report = format!(
        include_str!("report.md"),
        cases = by_station().count(),
        count = scenes.len(),
        seed = seed,
        missing = count(&|c| c.deed == super::fate::Deed::Missing),
        glazed = count(&|c| c.glazed),
        furniture = count(&|c| c.kind == Kind::Furniture),
        doors = count(&|c| c.kind == Kind::Door),
        open = count(&|c| c.deed == super::fate::Deed::Open),
        head = tables(score),
        bins = bins(score, Delivery::Stations),
        confusion = confusion(score, Delivery::Stations),
        confusion_merged = confusion(score, Delivery::Merged),
        wrong = wrong(score, Delivery::Stations),
        scenes = scenes.join("\n"),
    );
    std::fs::write(path, report).with_context(|| format!("{}: cannot write", path.display()))
}
