//! A building model into `building_object`.

use std::collections::HashMap;
use std::path::Path;

use anyhow::{Context, Result};
use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Aabb, Closedness};
use postgres::Transaction;
use postgres::types::{Json, Type};
use serde_json::{Map, Value};

use super::{LoadArgs, shown, source};
use crate::database::connect::explain;
use crate::database::copy;
use crate::database::names::Names;
use crate::output::{say, spinner};
use asbuilt_read::ifc;

/// What is written of a product; a level of accuracy goes by its name.
const COLUMNS: [(&str, Type); 8] = [
    ("global_id", Type::TEXT),
    ("ifc_class", Type::TEXT),
    ("name", Type::TEXT),
    ("storey", Type::TEXT),
    ("loa", Type::TEXT),
    ("solid", Type::BYTEA),
    ("properties", Type::JSONB),
    ("source", Type::TEXT),
];

pub fn load(args: &LoadArgs, file: &Path, names: &Names, tx: &mut Transaction) -> Result<()> {
    let bar = spinner(&format!("meshing {}", file.display()));
    let model = ifc::read(file, args.reading.limits())?;
    let model = model.in_unit(args.reading.options.file_unit).with_context(|| format!("{}", file.display()))?;
    bar.finish_and_clear();
    let source = source(file);
    let delete = names.sql("DELETE FROM @building_object WHERE source = $1::text");
    let replaced = tx.execute(&delete, &[&source]).map_err(explain)?;
    if replaced > 0 {
        say!("{source}: replaces {replaced} objects loaded before from a file of that name");
    }
    let mut copy = copy::start(tx, &names.table("building_object"), &COLUMNS)?;
    let (mut bounds, mut open, mut seen) = (Aabb::EMPTY, Vec::new(), HashMap::new());
    let (mut meshed, mut twice) = (0, Vec::new());
    for p in &model.products {
        if let Some(first) = seen.insert(&p.global_id, p) {
            twice.push(format!("{}: has the GlobalId {} of {}", p.shown(), p.global_id, first.shown()));
            seen.insert(&p.global_id, first);
            continue;
        }
        let loa = level(p, args.loa)?;
        let solid = p.solid().with_context(|| p.shown())?;
        if let Some(s) = &solid {
            meshed += 1;
            bounds = bounds.union(&s.bounds());
            if s.closedness() == Closedness::Open {
                open.push(p.shown());
            }
        }
        let solid = solid.map(|s| s.to_bytes(NEVER)).transpose()?;
        let text = |s: &str| s.replace('\0', "");
        let storey = p.storey.as_deref().map(text);
        copy.write(&[
            &text(&p.global_id),
            &text(&p.ifc_class),
            &text(&p.name),
            &storey,
            &loa.name(),
            &solid,
            &Json(properties(p)),
            &text(&source),
        ])
        .map_err(explain)?;
    }
    copy.finish().map_err(explain)?;
    report(&source, &model, meshed, &open, &bounds);
    list("left out", &twice);
    Ok(())
}

/// The object's own level of accuracy, or the given one. A property that names no level is reported, not guessed.
fn level(p: &ifc::Product, default: Loa) -> Result<Loa> {
    match &p.level_of_accuracy {
        None => Ok(default),
        Some(text) => Ok(Loa::parse(text).unwrap_or_else(|_| {
            say!("warning: {} has LevelOfAccuracy \"{text}\", which is none; {} taken", p.shown(), default.name());
            default
        })),
    }
}

fn properties(p: &ifc::Product) -> Value {
    let clean = |s: &str| Value::from(s.replace('\0', ""));
    let mut map: Map<String, Value> = p.properties.iter().map(|(k, v)| (k.replace('\0', ""), clean(v))).collect();
    if let Some(whole) = &p.part_of {
        map.insert("part_of".into(), clean(whole));
    }
    if let Some(note) = &p.note {
        map.insert("geometry_note".into(), clean(note));
    }
    Value::Object(map)
}

fn report(source: &str, model: &ifc::IfcModel, meshed: usize, open: &[String], bounds: &Aabb) {
    let parts = model.products.iter().filter(|p| p.part_of.is_some()).count();
    say!(
        "{source}: {} products read, {meshed} meshed, {} open surfaces, {parts} parts of others, {} missing",
        model.products.len(),
        open.len(),
        model.unmeshed.len()
    );
    say!("  box {}", shown(bounds));
    let with = |k: usize| model.products.iter().filter(|p| p.flags()[k]).count();
    say!("  {} objects have transparent parts, {} movable ones", with(0), with(1));
    list("open surface (area and verdict, no volume)", open);
    let missing: Vec<String> = model.unmeshed.iter().map(|(name, why)| format!("{name}: {why}")).collect();
    list("missing", &missing);
    let left_out: Vec<String> = model.left_out.iter().map(|(class, n)| format!("{n} {class}")).collect();
    if !left_out.is_empty() {
        say!("  no building objects, left out: {}", left_out.join(", "));
    }
    if let Some(worst) = model.rounded.iter().map(|r| r.1).reduce(f64::max) {
        say!(
            "  warning: {} products lie so far from the file's zero that their geometry is rounded, to {:.0} mm at the \
             worst ({}); move the model near its origin for finer levels of accuracy",
            model.rounded.len(),
            worst * 1e3,
            model.rounded[0].0
        );
    }
    let noted: Vec<String> = model.noted.iter().map(|(name, note)| format!("{name}: {note}")).collect();
    list("note", &noted);
    if model.mended > 0 {
        say!("  {} products whose openings came out wrong at first were cut once more, and checked", model.mended);
    }
    if let Some((meshing, checks)) = model.times.filter(|(meshing, _)| !meshing.is_zero()) {
        let share = 100.0 * checks.as_secs_f64() / meshing.as_secs_f64();
        say!("  checks of the openings: {share:.0} % of the meshing's {:.1} s", meshing.as_secs_f64());
    }
    model.map_conversion.iter().for_each(|m| say!("  {}", m.shown()));
    model.warnings.iter().for_each(|w| say!("  warning: {w}"));
}

/// Prints a list of names, of a long one only the beginning.
fn list(what: &str, names: &[String]) {
    const SHOWN: usize = 40;
    names.iter().take(SHOWN).for_each(|n| say!("  {what}: {n}"));
    if names.len() > SHOWN {
        say!("  … and {} more", names.len() - SHOWN);
    }
}
