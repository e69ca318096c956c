//! How the items of products look: which are glass, which are frames or leaves by their names. Told by surface styles,
//! by materials, and by shape aspects; read from the text of the file, in the process that meshes it.
//!
//! * [`words`]: what names tell;
//! * [`records`]: questions to the file;
//! * [`styles`], [`materials`]: what is assigned to items and to products;
//! * [`items`]: which items a product has;
//! * [`fixed`]: doors and windows that do not open.

mod fixed;
mod items;
mod materials;
mod records;
mod styles;
#[cfg(test)]
mod tests;
mod words;

use std::collections::HashMap;

use serde::{Deserialize, Serialize};

use super::step::Document;
use materials::{Ingredient, Materials, are_glass};
use records::{references, relation, text};
use styles::Styles;
pub use words::{Role, is_fixed};
use words::{is_glass, role};

/// What is told of a part of a product.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Look {
    pub name: Option<String>,
    pub is_transparent: bool,
    pub role: Role,
}

/// How the items of all products look.
pub struct Looks<'a> {
    document: Document<'a>,
    styles: Styles,
    materials: Materials,
    /// Names of shape aspects by item.
    aspects: HashMap<u64, String>,
    type_of: HashMap<u64, u64>,
    fixed: fixed::Fixed,
}

/// A product's items, and what is known of the whole.
struct Whole {
    ingredients: Vec<Ingredient>,
    outer: HashMap<u64, Vec<u64>>,
}

impl<'a> Looks<'a> {
    pub fn read(text: &'a [u8]) -> Self {
        let document = Document::new(text);
        let type_of = relation(&document, "IFCRELDEFINESBYTYPE", 4, 5);
        Self {
            styles: Styles::read(&document),
            materials: Materials::read(&document),
            aspects: aspects(&document),
            fixed: fixed::Fixed::read(&document, &type_of),
            type_of,
            document,
        }
    }

    /// Whether a door or window has panels, none of which opens.
    pub fn is_fixed(&self, product: u32) -> bool {
        self.fixed.is_fixed(u64::from(product))
    }

    /// The looks of a product's items; of what nobody knows which item it is, what is told of all of them.
    pub fn of(&self, product: u32, items: &[Option<u32>]) -> Vec<Look> {
        let id = u64::from(product);
        let own = self.materials.of(&self.document, &self.styles, id);
        let of_type = || self.type_of.get(&id).map(|&t| self.materials.of(&self.document, &self.styles, t));
        let ingredients = if own.is_empty() { of_type().unwrap_or_default() } else { own };
        let whole = Whole { ingredients, outer: items::outer(&self.document, id) };
        items.iter().map(|item| item.map_or_else(|| self.common(&whole), |i| self.look(u64::from(i), &whole))).collect()
    }

    /// How one item looks, by its own style or that of what it is mapped into.
    fn look(&self, item: u64, whole: &Whole) -> Look {
        let chain = std::iter::once(item).chain(whole.outer.get(&item).into_iter().flatten().copied());
        let chain: Vec<u64> = chain.collect();
        let style = chain.iter().find_map(|&id| self.styles.of_item(&self.document, id));
        let aspect = chain.iter().find_map(|id| self.aspects.get(id));
        let is_of = |i: &&Ingredient| i.label.as_ref().zip(aspect).is_some_and(|(a, b)| a.eq_ignore_ascii_case(b));
        let constituent = whole.ingredients.iter().find(is_of);
        // What the whole is made of says nothing of an item that has a look of its own.
        let of_whole = style.is_none() && constituent.is_none() && are_glass(&whole.ingredients);
        let is_transparent = style.is_some_and(|s| s.is_transparent)
            || constituent.is_some_and(|c| c.is_glass)
            || aspect.is_some_and(|a| is_glass(a))
            || of_whole;
        let only = || whole.ingredients.first().filter(|_| whole.ingredients.len() == 1);
        let material = || constituent.or_else(only).and_then(|i| i.name.clone());
        let name = aspect.cloned().or_else(|| style.and_then(|s| s.name.clone())).or_else(material);
        Look { is_transparent, role: name.as_deref().map_or(Role::Unknown, role), name }
    }

    fn common(&self, whole: &Whole) -> Look {
        let mut looks = whole.outer.keys().map(|&item| self.look(item, whole));
        let first = looks.next().unwrap_or_default();
        if looks.all(|look| look == first) { first } else { Look::default() }
    }
}

/// The names of shape aspects by the items of their representations.
fn aspects(document: &Document) -> HashMap<u64, String> {
    let mut out = HashMap::new();
    for record in document.all("IFCSHAPEASPECT") {
        let values = document.values(record);
        let Some(name) = text(&values, 1) else { continue };
        for representation in references(&values, 0) {
            let Some(values) = document.find(representation).map(|r| document.values(r)) else { continue };
            for item in references(&values, 3) {
                out.entry(item).or_insert_with(|| name.clone());
            }
        }
    }
    out
}
