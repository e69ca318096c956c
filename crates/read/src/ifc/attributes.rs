//! What is read about every product besides its mesh.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use ifc_lite_core::{DecodedEntity, EntityDecoder, EntityIndex, IfcType};
use ifc_lite_geometry::meshed_representations;
use ifc_lite_geometry::representation::{pds_representation_ids, product_shape_id};
use ifc_lite_processing::data_model::rows::{EntityRow, ModelOptions, stream_export_model_with_options};

use super::Product;
use super::relations::Relations;
use super::told::{Draft, Drafts};

/// Products by their numbers, and other objects by class.
#[derive(Default)]
pub struct Attributes {
    pub drafts: Drafts,
    pub left_out: BTreeMap<String, u64>,
}

/// Attributes and properties of every product, with their storeys.
pub fn read(bytes: &[u8], index: &Arc<EntityIndex>) -> (Attributes, Relations) {
    let mut decoder = EntityDecoder::with_arc_index(bytes, index.clone());
    let relations = Relations::scan(bytes, &mut decoder);
    let (mut out, mut storeys) = (Attributes::default(), HashMap::new());
    let options = ModelOptions::default().with_inherit_type_properties(true);
    stream_export_model_with_options(bytes, index, &options, |row, entity| {
        let Some(entity) = entity else { return };
        if entity.ifc_type == IfcType::IfcBuildingStorey {
            let name = row.name.clone().unwrap_or_else(|| format!("#{}", row.express_id));
            storeys.insert(row.express_id, name);
        }
        if !is_left_out(&entity.ifc_type) {
            let has_body = has_body(entity, &mut decoder);
            let is_element = entity.ifc_type.is_subtype_of(IfcType::IfcElement);
            out.drafts.insert(row.express_id, Draft { product: product(row), has_body, is_element });
        } else if row.has_geometry {
            *out.left_out.entry(row.ifc_type).or_default() += 1;
        }
        if decoder.cache_size() > 1 << 18 {
            decoder.clear_entity_cache();
        }
    });
    for (id, draft) in &mut out.drafts {
        draft.product.storey = relations.climb(*id, |at| storeys.get(&at).cloned());
    }
    (out, relations)
}

/// What is no building object: holes, spaces of air, drawing aids, analysis models.
fn is_left_out(t: &IfcType) -> bool {
    [
        IfcType::IfcFeatureElementSubtraction,
        IfcType::IfcSpace,
        IfcType::IfcSpatialZone,
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

/// Whether a product has a body by name, or a representation that the library would mesh; the library silently skips
/// some bodies.
fn has_body(entity: &DecodedEntity, decoder: &mut EntityDecoder) -> bool {
    let Some(id) = product_shape_id(entity) else { return false };
    // What is drawn and missing must be reported, not skipped.
    let Ok(shape) = decoder.decode_by_id(id) else { return true };
    let ids: Vec<u32> = pds_representation_ids(&shape).collect();
    let representations: Vec<_> = ids.iter().filter_map(|&id| decoder.decode_by_id(id).ok()).collect();
    if !ids.is_empty() && representations.is_empty() {
        return true;
    }
    let named = representations.iter().any(|r| r.get_string(1).is_some_and(|s| s.eq_ignore_ascii_case("Body")));
    let meshed = meshed_representations(entity, &representations).next().is_some();
    named || meshed
}

fn product(row: EntityRow) -> Product {
    let name = row.name.filter(|n| !n.is_empty()).unwrap_or_else(|| format!("#{}", row.express_id));
    let mut p = Product {
        id: u64::from(row.express_id),
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
