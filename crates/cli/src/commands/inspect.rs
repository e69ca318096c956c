//! `asbuilt inspect`: what files hold and how they would be read.

use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use asbuilt_core::geometry::{Aabb, Closedness};
use indicatif::ProgressBar;
use serde_json::{Value, json};

use super::reading::ReadingArgs;
use crate::output::{safe, say, to_stdout};
use asbuilt_read::child::{Event, ReadingProcess, ScanHead};
use asbuilt_read::packing::Packed;
use asbuilt_read::{self as read, FileFormat, OriginSource, ifc};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Reads files as `asbuilt load` would, with the same options, and tells format, points or products, box, units, scanner
positions and what would be dropped or doubted, and why. Needs no database and writes nothing.

Examples:
  asbuilt inspect survey.laz
  asbuilt inspect *.txt --columns n,x,y,z --format json")]
pub struct InspectArgs {
    /// IFC models and scan files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    reading: ReadingArgs,
    /// How to print; the keys of JSON are listed in docs/inspect.md
    #[arg(long, value_enum, default_value_t)]
    format: InspectFormat,
}

#[derive(clap::ValueEnum, Debug, Clone, Copy, Default, PartialEq, Eq)]
enum InspectFormat {
    /// Lines to read
    #[default]
    Table,
    /// An array with an object a file
    Json,
}

pub fn run(args: &InspectArgs) -> Result<()> {
    args.reading.check()?;
    let found: Vec<Value> = args.files.iter().map(|file| inspected(file, &args.reading)).collect();
    to_stdout(|out| match args.format {
        InspectFormat::Json => Ok(writeln!(out, "{}", serde_json::to_string_pretty(&found)?)?),
        InspectFormat::Table => found.iter().try_for_each(|found| print(out, found)),
    })?;
    let failed = found.iter().filter(|f| !f["error"].is_null()).count();
    if failed > 0 {
        bail!("{failed} of {} files cannot be read", found.len());
    }
    Ok(())
}

/// Everything to say about a file.
fn inspected(file: &Path, reading: &ReadingArgs) -> Value {
    let form = read::form(file);
    let name = form.as_ref().map(|f| f.name()).ok();
    let content = form.and_then(|form| match form {
        FileFormat::Ifc => model(file, reading).map(|model| json!({ "model": model })),
        _ => scans(file, reading).map(|scans| json!({ "scans": scans })),
    });
    let mut out = json!({ "file": file.display().to_string(), "format": name, "error": null });
    match content {
        Ok(Value::Object(content)) => content.into_iter().for_each(|(key, value)| out[key] = value),
        Ok(_) => {}
        Err(error) => out["error"] = format!("{error:#}").into(),
    }
    out
}

fn scans(file: &Path, reading: &ReadingArgs) -> Result<Vec<Value>> {
    let bar = ProgressBar::hidden();
    let mut reader = ReadingProcess::start(reading.job(file))?;
    let (mut out, mut open) = (Vec::new(), None);
    while let Some(event) = reader.next(&bar)? {
        match event {
            Event::Scan(head) if head.is_empty => out.push(scan(&head, None)),
            Event::Scan(head) => {
                reader.answer(out.len() as i64 + 1)?;
                open = Some(head);
            }
            Event::Patch(_) => {}
            Event::Packed(packed) => out.extend(open.take().map(|head| scan(&head, Some(&packed)))),
        }
    }
    Ok(out)
}

fn scan(head: &ScanHead, packed: Option<&Packed>) -> Value {
    let origin = head.world_from_scan.map(|_| head.anchor);
    json!({
        "name": head.name,
        "sensor": head.sensor,
        "origin": origin,
        "origin_source": head.origin_source.map(OriginSource::name),
        "origin_sd": head.origin_sd,
        "rotation": head.world_from_scan,
        "returns": packed.map_or(0, |p| p.beams - p.no_returns),
        "no_returns": packed.map_or(0, |p| p.no_returns),
        "too_near": packed.map_or(0, |p| p.too_near),
        "unusable": head.unusable,
        "box": packed.and_then(|p| corners(&p.points)),
        "facts": head.facts,
        "notes": head.notes,
    })
}

/// Lower and upper corner; null for an empty box.
fn corners(b: &Aabb) -> Option<[[f64; 3]; 2]> {
    (0..3).all(|i| b.min[i] <= b.max[i]).then_some([b.min, b.max])
}

fn model(file: &Path, reading: &ReadingArgs) -> Result<Value> {
    let model = ifc::read(file, reading.limits())?.in_unit(reading.options.file_unit)?;
    let (mut bounds, mut open, mut classes) = (Aabb::EMPTY, Vec::new(), std::collections::BTreeMap::new());
    let (mut transparent, mut movable) = (0u64, 0u64);
    for product in &model.products {
        let [is_transparent, is_movable] = product.flags();
        transparent += u64::from(is_transparent);
        movable += u64::from(is_movable);
        *classes.entry(product.ifc_class.as_str()).or_insert(0u64) += 1;
        if let Some(solid) = product.solid()? {
            bounds = bounds.union(&solid.bounds());
            if solid.closedness() == Closedness::Open {
                open.push(product.shown());
            }
        }
    }
    let named = |all: &[(String, String)]| -> Vec<Value> {
        all.iter().map(|(name, why)| json!({ "name": name, "reason": why })).collect()
    };
    let conversion = model.map_conversion.as_ref();
    Ok(json!({
        "products": model.products.len(),
        "classes": classes,
        "open": open,
        "transparent": transparent,
        "movable": movable,
        "missing": named(&model.unmeshed),
        "noted": named(&model.noted),
        "left_out": model.left_out,
        "length_unit": model.length_unit,
        "map_conversion": conversion,
        "box": corners(&bounds),
        "warnings": model.warnings,
    }))
}

/// A file as lines: simple values after their names, lists below.
fn print(out: &mut impl Write, found: &Value) -> Result<()> {
    let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), ToOwned::to_owned);
    writeln!(out, "{}: {}", safe(&text(&found["file"])), found["format"].as_str().unwrap_or("unknown"))?;
    if let Some(error) = found["error"].as_str() {
        say!("  {error}");
    }
    let scans = found["scans"].as_array().into_iter().flatten();
    for part in scans.chain(found.get("model")) {
        for (key, value) in part.as_object().into_iter().flatten() {
            lines(out, key, value, 1)?;
        }
    }
    Ok(())
}

fn lines(out: &mut impl Write, key: &str, value: &Value, depth: usize) -> Result<()> {
    let indent = "  ".repeat(depth);
    match value {
        Value::Null => writeln!(out, "{indent}{key}: not known")?,
        Value::Array(all) if all.is_empty() => {}
        Value::Array(all) if all.iter().any(|v| v.is_string() || v.is_object()) => {
            writeln!(out, "{indent}{key}:")?;
            all.iter().try_for_each(|v| lines(out, "-", v, depth + 1))?;
        }
        Value::Object(all) if key == "-" => {
            let parts: Vec<String> = all.iter().map(|(_, v)| v.as_str().map_or_else(|| v.to_string(), safe)).collect();
            writeln!(out, "{indent}- {}", parts.join(": "))?;
        }
        Value::Object(all) if all.is_empty() => {}
        Value::Object(all) => {
            writeln!(out, "{indent}{key}:")?;
            all.iter().try_for_each(|(key, value)| lines(out, key, value, depth + 1))?;
        }
        Value::String(text) if key == "-" => writeln!(out, "{indent}- {}", safe(text))?,
        Value::String(text) => writeln!(out, "{indent}{key}: {}", safe(text))?,
        other => writeln!(out, "{indent}{key}: {other}")?,
    }
    Ok(())
}
