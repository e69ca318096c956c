//! How representation items look: the surface styles that are assigned to them, or to a material.

use std::collections::HashMap;

use super::records::{open, reference, references, text};
use super::words::is_glass;
use crate::ifc::step::{Document, Value};

/// What is more transparent than this lets most beams pass.
const MIN_TRANSPARENCY: f64 = 0.3;
/// How far cuts may be nested within each other.
const MAX_DEPTH: usize = 16;

/// What a surface style tells.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Style {
    pub name: Option<String>,
    /// By its transparency, or by its name.
    pub is_transparent: bool,
}

/// Styles by what they are assigned to.
#[derive(Debug, Default)]
pub struct Styles {
    of_item: HashMap<u64, Style>,
    of_material: HashMap<u64, Style>,
}

impl Styles {
    pub fn read(document: &Document) -> Self {
        let mut styles = Self::default();
        for record in document.all("IFCSTYLEDITEM") {
            let values = document.values(record);
            if let (Some(item), Some(style)) = (reference(&values, 0), style_of(document, &values)) {
                styles.of_item.entry(item).or_insert(style);
            }
        }
        for record in document.all("IFCINDEXEDCOLOURMAP") {
            let values = document.values(record);
            let opacity = values.get(1).and_then(Value::number).unwrap_or(1.0);
            if let Some(item) = reference(&values, 0).filter(|_| 1.0 - opacity > MIN_TRANSPARENCY) {
                styles.of_item.entry(item).or_default().is_transparent = true;
            }
        }
        for record in document.all("IFCMATERIALDEFINITIONREPRESENTATION") {
            let values = document.values(record);
            let of_material = references(&values, 2).into_iter().find_map(|r| styled(document, r));
            if let (Some(material), Some(style)) = (reference(&values, 3), of_material) {
                styles.of_material.entry(material).or_insert(style);
            }
        }
        styles
    }

    /// The style of an item, or of what it was cut from.
    pub fn of_item(&self, document: &Document, item: u64) -> Option<&Style> {
        let mut at = item;
        for _ in 0..MAX_DEPTH {
            if let Some(style) = self.of_item.get(&at) {
                return Some(style);
            }
            let first = |keyword: &str, k: usize| reference(&document.values_of(at, keyword)?, k);
            let cut = first("IFCBOOLEANRESULT", 1).or_else(|| first("IFCBOOLEANCLIPPINGRESULT", 1));
            at = cut.or_else(|| first("IFCCSGSOLID", 0))?;
        }
        None
    }

    pub fn of_material(&self, material: u64) -> Option<&Style> {
        self.of_material.get(&material)
    }
}

/// The style of a styled representation's items.
fn styled(document: &Document, representation: u64) -> Option<Style> {
    let (_, values) = open(document, representation)?;
    references(&values, 3).into_iter().find_map(|item| {
        let item = document.values_of(item, "IFCSTYLEDITEM")?;
        style_of(document, &item)
    })
}

/// The surface styles of a styled item as one; IFC2x3 assigns them by a record of its own.
fn style_of(document: &Document, styled_item: &[Value]) -> Option<Style> {
    let mut open_ids = references(styled_item, 1);
    let mut found: Option<Style> = None;
    let mut left = 64;
    while let (Some(id), true) = (open_ids.pop(), left > 0) {
        left -= 1;
        let Some((keyword, values)) = open(document, id) else { continue };
        match keyword.as_str() {
            "IFCPRESENTATIONSTYLEASSIGNMENT" => open_ids.extend(references(&values, 0)),
            "IFCSURFACESTYLE" => {
                let style = surface_style(document, &values);
                let known = found.get_or_insert_with(Style::default);
                known.is_transparent |= style.is_transparent;
                known.name = known.name.take().or(style.name);
            }
            _ => {}
        }
    }
    found
}

fn surface_style(document: &Document, values: &[Value]) -> Style {
    let name = text(values, 0);
    let transparency = |id: u64| {
        let (keyword, values) = open(document, id)?;
        let is_shading = matches!(keyword.as_str(), "IFCSURFACESTYLERENDERING" | "IFCSURFACESTYLESHADING");
        values.get(1).filter(|_| is_shading).and_then(Value::number)
    };
    let is_clear = references(values, 2).into_iter().filter_map(transparency).any(|t| t > MIN_TRANSPARENCY);
    Style { is_transparent: is_clear || name.as_deref().is_some_and(is_glass), name }
}
