//! A model as lines of JSON, for comparisons with other readers.

use std::path::Path;

use anyhow::Result;
use asbuilt_core::geometry::{Closedness, Part as StoredPart, Parts};
use serde_json::json;

use super::{Limits, read};

/// Prints one line per product, and one for the whole model.
pub fn print_table(path: &Path, limits: Limits) -> Result<()> {
    let model = read(path, limits)?;
    for p in &model.products {
        let solid = p.solid()?;
        let measures = solid.as_ref().map(|s| s.part_measures()).unwrap_or_default();
        let stored = solid.as_ref().and_then(|s| s.parts()).map_or(&[][..], Parts::list);
        let area = |is_asked: fn(&StoredPart) -> bool| -> f64 {
            stored.iter().zip(&measures).filter(|(part, _)| is_asked(part)).map(|(_, (_, area))| area).sum()
        };
        let bounds = solid.as_ref().map(asbuilt_core::geometry::Solid::bounds);
        let line = json!({
            "id": p.id, "global_id": p.global_id, "class": p.ifc_class, "name": p.name, "note": p.note,
            "storey": p.storey, "triangles": p.triangles.len(), "area": solid.as_ref().map(|s| s.area()),
            "volume": solid.as_ref().and_then(|s| s.volume().ok()),
            "closed": solid.as_ref().map(|s| s.closedness() != Closedness::Open),
            "parts": measures.len(), "transparent": area(|p| p.is_transparent), "movable": area(|p| p.is_movable),
            "box": bounds.map(|b| [b.min, b.max].concat()),
        });
        println!("{line}");
    }
    let times = model.times.map(|(meshing, checks)| [meshing.as_secs_f64(), checks.as_secs_f64()]);
    println!(
        "{}",
        json!({
            "unmeshed": model.unmeshed, "warnings": model.warnings, "noted": model.noted, "mended": model.mended,
            "map_conversion": model.map_conversion, "times": times,
        })
    );
    Ok(())
}
