//! Products and meshes, through the `ifc-lite` crates: the only place that knows them.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use ifc_lite_core::{DecodedEntity, EntityDecoder, IfcType, build_entity_index, set_report_sink};
use ifc_lite_geometry::representation::{pds_representation_ids, product_shape_id};
use ifc_lite_geometry::{TessellationQuality, meshed_representations};
use ifc_lite_processing::data_model::rows::{EntityRow, ModelOptions, stream_export_model_with_options};
use ifc_lite_processing::{
    Batching, Features, ProcessingRequest, ProcessingResult, ProcessingSink, ProductGeometryAudit, process,
    run_on_geometry_pool,
};

use super::relations::Relations;
use super::{Model, Product};
use crate::read::silence_panics;

/// Reads a whole file. The library never fails by itself: what it silently leaves out is checked here.
pub fn read(bytes: &[u8]) -> Result<Model, String> {
    if !bytes.trim_ascii_start().starts_with(b"ISO-10303-21") {
        return Err("not an IFC file in STEP form (it does not start with ISO-10303-21)".into());
    }
    let tail = &bytes[bytes.len().saturating_sub(4096)..];
    if !tail.windows(16).any(|w| w == b"END-ISO-10303-21") {
        return Err("the file is cut short (no END-ISO-10303-21 at its end)".into());
    }
    let _ = set_report_sink(|_| {});
    match silence_panics(|| run_on_geometry_pool(|| read_whole(bytes))) {
        Ok(Ok(model)) => model,
        Ok(Err(e)) => Err(format!("cannot start the geometry threads: {e}")),
        Err(_) => Err("the geometry library gave up on it".into()),
    }
}

/// A product while it is put together.
struct Draft {
    product: Product,
    has_body: bool,
    is_element: bool,
}

type Drafts = BTreeMap<u32, Draft>;

/// What is read of every product before its mesh.
#[derive(Default)]
struct Attributes {
    drafts: Drafts,
    storeys: HashMap<u32, String>,
    left_out: BTreeMap<String, u64>,
}

struct Sink(ProductGeometryAudit);

impl ProcessingSink for Sink {
    fn product_geometry_audit(&self) -> Option<ProductGeometryAudit> {
        Some(self.0.clone())
    }
}

fn read_whole(bytes: &[u8]) -> Result<Model, String> {
    let index = Arc::new(build_entity_index(bytes));
    let mut decoder = EntityDecoder::with_arc_index(bytes, index.clone());
    let relations = Relations::scan(bytes, &mut decoder);
    let Attributes { mut drafts, storeys, left_out } = attributes(bytes, &index, &mut decoder);
    let wanted: HashSet<u32> = drafts.iter().filter(|(_, d)| d.has_body).map(|(&id, _)| id).collect();
    if wanted.is_empty() {
        return Err("it holds no product with a body".into());
    }
    let audit = ProductGeometryAudit::default();
    let request = ProcessingRequest::full_pass()
        .batching(Batching::new(256, 256))
        .quality(TessellationQuality::Medium)
        .features(Features::default().properties(false).presentation_layers(false))
        .ids(Some(Arc::new(wanted)))
        .index(index);
    let result = process(bytes, &request, &mut Sink(audit.clone()));
    if let Some(unit) = result.metadata.length_unit_refused {
        return Err(format!("its unit of length (#{unit}) is unknown"));
    }
    let mut model = Model { left_out, warnings: warnings(&result), ..Model::default() };
    add_meshes(&mut drafts, result);
    gather_parts(&mut drafts, &relations);
    for (id, draft) in &mut drafts {
        draft.product.storey = relations.climb(*id, |at| storeys.get(&at).cloned());
        if draft.has_body {
            let receipt = audit.require_complete(*id).err();
            if draft.product.triangles.is_empty() {
                let reason = receipt.unwrap_or_else(|| "no triangles".into());
                model.unmeshed.push((format!("{} {}", draft.product.ifc_class, draft.product.name), reason));
            } else {
                draft.product.note = receipt;
            }
            if let Some(grid) = rounded_to(&draft.product.vertices) {
                model.rounded.push((format!("{} {}", draft.product.ifc_class, draft.product.name), grid));
            }
        }
    }
    let keep = |d: &Draft| d.has_body || !d.product.triangles.is_empty();
    model.products = drafts.into_values().filter(keep).map(|d| d.product).collect();
    if model.products.iter().all(|p| p.triangles.is_empty()) {
        let why = model.unmeshed.first().map_or(String::new(), |(name, reason)| format!("; first: {name}: {reason}"));
        return Err(format!("none of its {} products could be meshed{why}", model.products.len()));
    }
    Ok(model)
}

/// Attributes and properties of every product, and the names of the storeys.
fn attributes(bytes: &[u8], index: &Arc<ifc_lite_core::EntityIndex>, decoder: &mut EntityDecoder) -> Attributes {
    let mut out = Attributes::default();
    let options = ModelOptions::default().with_inherit_type_properties(true);
    stream_export_model_with_options(bytes, index, &options, |row, entity| {
        let Some(entity) = entity else { return };
        if entity.ifc_type == IfcType::IfcBuildingStorey {
            let name = row.name.clone().unwrap_or_else(|| format!("#{}", row.express_id));
            out.storeys.insert(row.express_id, name);
        }
        if !is_left_out(&entity.ifc_type) {
            let has_body = row.has_geometry && has_body(entity, decoder);
            let is_element = entity.ifc_type.is_subtype_of(IfcType::IfcElement);
            out.drafts.insert(row.express_id, Draft { product: product(row), has_body, is_element });
        } else if row.has_geometry {
            *out.left_out.entry(row.ifc_type).or_default() += 1;
        }
        if decoder.cache_size() > 1 << 18 {
            decoder.clear_entity_cache();
        }
    });
    out
}

/// What is no building object: holes, spaces of air, drawing aids, analysis models.
fn is_left_out(t: &IfcType) -> bool {
    [
        IfcType::IfcFeatureElementSubtraction,
        IfcType::IfcSpace,
        IfcType::IfcAnnotation,
        IfcType::IfcGrid,
        IfcType::IfcPort,
        IfcType::IfcVirtualElement,
        IfcType::IfcStructuralItem,
        IfcType::IfcStructuralActivity,
    ]
    .into_iter()
    .any(|left_out| t.is_subtype_of(left_out))
}

/// A body in name, or a representation that the library would mesh; it passes over some bodies in silence.
fn has_body(entity: &DecodedEntity, decoder: &mut EntityDecoder) -> bool {
    let Some(shape) = product_shape_id(entity).and_then(|id| decoder.decode_by_id(id).ok()) else { return false };
    let representations: Vec<_> =
        pds_representation_ids(&shape).filter_map(|id| decoder.decode_by_id(id).ok()).collect();
    let named = representations.iter().any(|r| r.get_string(1).is_some_and(|s| s.eq_ignore_ascii_case("Body")));
    let meshed = meshed_representations(entity, &representations).next().is_some();
    named || meshed
}

fn product(row: EntityRow) -> Product {
    let name = row.name.filter(|n| !n.is_empty()).unwrap_or_else(|| format!("#{}", row.express_id));
    let mut p = Product {
        global_id: row.global_id.filter(|g| !g.is_empty()).unwrap_or_else(|| format!("#{}", row.express_id)),
        ifc_class: row.ifc_type,
        name,
        ..Product::default()
    };
    for set in row.property_sets {
        for property in set.properties {
            if property.name.eq_ignore_ascii_case("LevelOfAccuracy") && p.level_of_accuracy.is_none() {
                p.level_of_accuracy = Some(property.value.clone());
            }
            p.properties.entry(format!("{}.{}", set.name, property.name)).or_insert(property.value);
        }
    }
    p
}

/// Joins the library's submeshes of each product, vertices at the same place as one.
fn add_meshes(drafts: &mut Drafts, result: ProcessingResult) {
    let to_world = result.frame.world_mapper();
    let mut welded: HashMap<(u32, [u64; 3]), u32> = HashMap::new();
    for mesh in result.meshes.into_iter().filter(|m| m.geometry_class == 0) {
        let Some(draft) = drafts.get_mut(&mesh.express_id) else { continue };
        let (vertices, origin) = (&mut draft.product.vertices, mesh.origin);
        let places: Vec<Option<u32>> = mesh
            .positions
            .chunks_exact(3)
            .map(|p| {
                let world = to_world([0, 1, 2].map(|i| origin[i] + f64::from(p[i])));
                let finite = world.iter().all(|c| c.is_finite());
                finite.then(|| {
                    *welded.entry((mesh.express_id, world.map(|c| (c + 0.0).to_bits()))).or_insert_with(|| {
                        vertices.push(world);
                        vertices.len() as u32 - 1
                    })
                })
            })
            .collect();
        for t in mesh.indices.chunks_exact(3) {
            let place = |i: usize| places.get(t[i] as usize).copied().flatten();
            if let (Some(a), Some(b), Some(c)) = (place(0), place(1), place(2))
                && a != b
                && b != c
                && c != a
            {
                draft.product.triangles.push([a, b, c]);
            }
        }
    }
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
fn gather_parts(drafts: &mut Drafts, relations: &Relations) {
    let ids: Vec<u32> = drafts.keys().copied().collect();
    for part in ids {
        let mut seen = HashSet::from([part]);
        let mut at = part;
        while let Some(&whole) = relations.whole_of.get(&at) {
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
        let (vertices, triangles) = (p.product.vertices.clone(), p.product.triangles.clone());
        if let Some(w) = drafts.get_mut(&whole) {
            let first = w.product.vertices.len() as u32;
            w.product.vertices.extend(vertices);
            w.product.triangles.extend(triangles.iter().map(|t| t.map(|i| i + first)));
        }
    }
    if let Some(p) = drafts.get_mut(&part) {
        p.product.level_of_accuracy = p.product.level_of_accuracy.take().or(level);
        if direct {
            p.product.part_of = Some(global_id);
        }
    }
}

/// What the library could not do, in its own words.
fn warnings(result: &ProcessingResult) -> Vec<String> {
    let mut out = Vec::new();
    if let Some(d) = &result.stats.geometry_diagnostics {
        out.extend(d.unsupported_items_by_type.iter().map(|r| format!("{} × {}: not supported", r.count, r.reason)));
        out.extend(d.failures_by_reason.iter().map(|r| format!("{} × opening cut: {}", r.count, r.reason)));
    }
    if result.stats.refused_input_elements > 0 {
        out.push(format!("{} elements with impossible numbers", result.stats.refused_input_elements));
    }
    out
}
