//! What products are made of, as far as it tells glass.

use std::collections::HashMap;

use super::records::{open, reference, references, relation, text};
use super::styles::Styles;
use super::words::is_glass;
use crate::ifc::step::Document;

/// How deeply materials may be nested: usage, set, layer, material.
const MAX_DEPTH: usize = 8;

/// Materials by product and by type.
#[derive(Debug, Default)]
pub struct Materials {
    of: HashMap<u64, u64>,
}

/// One of the materials of a product.
#[derive(Debug, Clone, PartialEq)]
pub struct Ingredient {
    /// What a constituent is called: Lining, Framing, Glazing.
    pub label: Option<String>,
    pub name: Option<String>,
    pub is_glass: bool,
}

impl Materials {
    pub fn read(document: &Document) -> Self {
        Self { of: relation(document, "IFCRELASSOCIATESMATERIAL", 4, 5) }
    }

    /// The materials of a product or a type; air is none.
    pub fn of(&self, document: &Document, styles: &Styles, id: u64) -> Vec<Ingredient> {
        let mut out = Vec::new();
        if let Some(&material) = self.of.get(&id) {
            add(document, styles, material, None, &mut out, 0);
        }
        out.retain(|i| !i.name.as_deref().is_some_and(is_air));
        out
    }
}

/// Whether all of it is glass.
pub fn are_glass(ingredients: &[Ingredient]) -> bool {
    !ingredients.is_empty() && ingredients.iter().all(|i| i.is_glass)
}

fn is_air(name: &str) -> bool {
    let name = name.to_lowercase();
    let mut words = name.split(|c: char| !c.is_alphabetic());
    words.any(|w| ["air", "luft", "lucht", "argon", "krypton", "aire", "aria", "gas", "cavity"].contains(&w))
}

fn add(document: &Document, styles: &Styles, id: u64, label: Option<String>, out: &mut Vec<Ingredient>, depth: usize) {
    let Some((keyword, values)) = open(document, id).filter(|_| depth < MAX_DEPTH) else { return };
    let (label, inner) = match keyword.as_str() {
        "IFCMATERIAL" => {
            let name = text(&values, 0);
            let is_clear = styles.of_material(id).is_some_and(|s| s.is_transparent);
            let is_glass = is_clear || name.as_deref().is_some_and(is_glass);
            return out.push(Ingredient { label, name, is_glass });
        }
        "IFCMATERIALLAYERSETUSAGE"
        | "IFCMATERIALPROFILESETUSAGE"
        | "IFCMATERIALLIST"
        | "IFCMATERIALLAYERSET"
        | "IFCMATERIALLAYER"
        | "IFCMATERIALLAYERWITHOFFSETS" => (label, references(&values, 0)),
        "IFCMATERIALPROFILESET" | "IFCMATERIALCONSTITUENTSET" => (label, references(&values, 2)),
        "IFCMATERIALPROFILE" | "IFCMATERIALPROFILEWITHOFFSETS" | "IFCMATERIALCONSTITUENT" => {
            (text(&values, 0), reference(&values, 2).into_iter().collect())
        }
        _ => return,
    };
    inner.into_iter().for_each(|id| add(document, styles, id, label.clone(), out, depth + 1));
}
