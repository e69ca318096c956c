//! The items of a product's representations, mapped ones followed.

use std::collections::HashMap;

use super::records::{open, reference, references};
use crate::ifc::step::Document;

/// Deepest nesting of maps, and most items of one product.
const MAX_DEPTH: usize = 16;
const MAX_ITEMS: usize = 1 << 16;

/// Every item of a product, with the mapped items that brought it there, the nearest first.
pub fn outer(document: &Document, product: u64) -> HashMap<u64, Vec<u64>> {
    let mut out = HashMap::new();
    let shape = open(document, product).and_then(|(_, values)| reference(&values, 6));
    let Some((_, shape)) = shape.and_then(|s| open(document, s)) else { return out };
    for representation in references(&shape, 2) {
        walk(document, representation, &mut Vec::new(), &mut out);
    }
    out
}

fn walk(document: &Document, representation: u64, path: &mut Vec<u64>, out: &mut HashMap<u64, Vec<u64>>) {
    let Some((_, values)) = open(document, representation).filter(|_| path.len() < MAX_DEPTH) else { return };
    for item in references(&values, 3) {
        if out.len() >= MAX_ITEMS || path.contains(&item) {
            return;
        }
        let mapped = document.values_of(item, "IFCMAPPEDITEM").and_then(|values| reference(&values, 0));
        let inner = mapped.and_then(|map| open(document, map)).and_then(|(_, values)| reference(&values, 1));
        match inner {
            Some(inner) => {
                path.push(item);
                walk(document, inner, path, out);
                path.pop();
            }
            None => drop(out.insert(item, path.iter().rev().copied().collect())),
        }
    }
}
