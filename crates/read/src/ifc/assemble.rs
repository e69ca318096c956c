//! A model assembled from what the meshing process reported.

use std::collections::{HashMap, HashSet};

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Closedness;

use super::meshing::FARTHEST_M;
use super::reader::Progress;
use super::told::{Drafts, IfcHeader, Outcome};
use super::{IfcModel, Part, Product, movable};

pub fn model(progress: Progress) -> Result<IfcModel> {
    let IfcHeader { mut drafts, whole_of, left_out, words, map_conversion, length_unit } =
        progress.header.context("the meshing process told nothing")?;
    let (warnings, times) = (words, progress.times);
    let mut model = IfcModel { left_out, warnings, map_conversion, length_unit, times, ..IfcModel::default() };
    for (id, outcome) in progress.outcomes {
        let Some(draft) = drafts.get_mut(&id) else { continue };
        let missing = match outcome {
            Ok(outcome) => take(&mut draft.product, outcome, &mut model),
            Err(reason) => Some(reason),
        };
        model.unmeshed.extend(missing.map(|reason| (draft.product.shown(), reason)));
    }
    gather_parts(&mut drafts, &whole_of);
    drafts.values_mut().for_each(|d| movable::mark(&mut d.product));
    let keep = |p: &super::told::Draft| p.has_body || !p.product.triangles.is_empty();
    model.products = drafts.into_values().filter(keep).map(|d| d.product).collect();
    if model.products.iter().all(|p| p.triangles.is_empty()) {
        let why = model.unmeshed.first().map_or(String::new(), |(name, reason)| format!("; first: {name}: {reason}"));
        bail!("none of its {} products could be meshed{why}", model.products.len());
    }
    Ok(model)
}

/// Gives a product its mesh, or says why it has none.
fn take(product: &mut Product, outcome: Outcome, model: &mut IfcModel) -> Option<String> {
    let Outcome { soup, looks, is_fixed, note, unproven, mended } = outcome;
    model.mended += usize::from(mended);
    if soup.triangles.is_empty() {
        return Some(note.unwrap_or_else(|| {
            "no triangles came of it: look at its items, their placements and its openings".into()
        }));
    }
    let parts = looks.into_iter().map(Part::from).collect();
    (product.vertices, product.triangles, product.is_fixed) = (soup.vertices, soup.triangles, is_fixed);
    product.take_parts(soup.part_numbers, parts);
    if let Some(reason) = no_solid(product) {
        (product.vertices, product.triangles, product.part_numbers) = Default::default();
        return Some(reason);
    }
    if let Some(grid) = rounded_to(&product.vertices) {
        model.rounded.push((product.shown(), grid));
    }
    let said: Vec<String> = note.into_iter().chain(unproven.clone()).collect();
    if !said.is_empty() {
        model.noted.push((product.shown(), said.join("; ")));
        product.note = Some(said.join("; "));
    }
    None
}

/// Why a mesh cannot belong to a building: an impossible place, or nothing between its faces.
fn no_solid(product: &Product) -> Option<String> {
    let far = product.vertices.iter().flatten().copied().find(|c| c.abs() > FARTHEST_M);
    if let Some(c) = far {
        return Some(format!(
            "a vertex lies {} m from the file's zero; repair its placement or its points",
            distance(c)
        ));
    }
    let solid = match product.solid() {
        Ok(solid) => solid?,
        Err(e) => return Some(e.to_string()),
    };
    // As thin as its vertices are exact, on the average.
    let is_nothing = |volume: f64| volume.abs() < 1e-7 * solid.area();
    let is_empty = solid.closedness() != Closedness::Open && solid.volume().is_ok_and(is_nothing);
    is_empty.then(|| {
        "nothing is left of it: it has no thickness, or is cut away entirely; look at its profile and its cuts".into()
    })
}

/// The reason in words, kept short.
fn distance(c: f64) -> String {
    if c.abs() < 1e12 { format!("{c:.0}") } else { format!("{c:.1e}") }
}

/// Far from the file's zero the library's sweeps keep single precision only: the grid (metres) on which all
/// coordinates of a mesh lie, if it is a millimetre or coarser.
fn rounded_to(vertices: &[[f64; 3]]) -> Option<f64> {
    const FAR_M: f64 = 8192.0;
    let far: Vec<f64> = vertices.iter().flatten().copied().filter(|c| c.abs() >= FAR_M).collect();
    let on = |grid: f64| far.iter().all(|c| (c / grid - (c / grid).round()).abs() < 1e-3);
    (4..=10).map(|k| 0.5f64.powi(k)).find(|&grid| far.len() >= 12 && on(grid))
}

/// Marks parts, hands down the level of accuracy of their whole, and gives a whole without a body of its own the
/// meshes of its parts.
fn gather_parts(drafts: &mut Drafts, whole_of: &HashMap<u32, u32>) {
    let ids: Vec<u32> = drafts.keys().copied().collect();
    for part in ids {
        let mut seen = HashSet::from([part]);
        let mut at = part;
        while let Some(&whole) = whole_of.get(&at) {
            if !seen.insert(whole) || !drafts.get(&whole).is_some_and(|w| w.is_element) {
                break;
            }
            adopt(drafts, part, whole, at == part);
            at = whole;
        }
    }
}

fn adopt(drafts: &mut Drafts, part: u32, whole: u32, direct: bool) {
    let (Some(p), Some(w)) = (drafts.get(&part), drafts.get(&whole)) else { return };
    let level = w.product.level_of_accuracy.clone();
    let global_id = w.product.global_id.clone();
    if !w.has_body && p.has_body {
        let Product { vertices, triangles, part_numbers, parts, .. } = p.product.shape();
        if let Some(w) = drafts.get_mut(&whole) {
            let first = w.product.vertices.len() as u32;
            w.product.vertices.extend(vertices);
            w.product.triangles.extend(triangles.iter().map(|t| t.map(|i| i + first)));
            let numbers: Vec<u16> = parts.into_iter().map(|part| w.product.number_for(part)).collect();
            w.product.part_numbers.extend(part_numbers.iter().map(|&n| numbers[usize::from(n)]));
        }
    }
    if let Some(p) = drafts.get_mut(&part) {
        p.product.level_of_accuracy = p.product.level_of_accuracy.take().or(level);
        if direct {
            p.product.part_of = Some(global_id);
        }
    }
}
