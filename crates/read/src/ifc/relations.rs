//! Which product belongs to which: storeys, wholes and parts.

use std::collections::HashMap;

use ifc_lite_core::{EntityDecoder, EntityScanner, keyword_eq};

/// Entity numbers of parents, by child. Where a file names several, the first counts.
#[derive(Debug, Default)]
pub struct Relations {
    /// Whole of a part (IfcRelAggregates, IfcRelNests).
    pub whole_of: HashMap<u32, u32>,
    /// Spatial structure that contains an element.
    inside: HashMap<u32, u32>,
    /// Host of an opening, opening of a filling.
    via: HashMap<u32, u32>,
}

/// Deepest hierarchy followed: a file may hold a cycle, and no real hierarchy is deeper.
const MAX_DEPTH: usize = 64;

impl Relations {
    pub fn scan(bytes: &[u8], decoder: &mut EntityDecoder) -> Self {
        let mut r = Self::default();
        let mut scanner = EntityScanner::new(bytes);
        while let Some((_, keyword, start, end)) = scanner.next_entity() {
            let (parent, child, map) = if ["IFCRELAGGREGATES", "IFCRELNESTS"].iter().any(|k| keyword_eq(keyword, k)) {
                (4, 5, &mut r.whole_of)
            } else if keyword_eq(keyword, "IFCRELCONTAINEDINSPATIALSTRUCTURE") {
                (5, 4, &mut r.inside)
            } else if ["IFCRELVOIDSELEMENT", "IFCRELFILLSELEMENT"].iter().any(|k| keyword_eq(keyword, k)) {
                (4, 5, &mut r.via)
            } else {
                continue;
            };
            let Ok(relation) = decoder.decode_at_uncached(start, end) else { continue };
            let Some(parent) = relation.get_ref(parent) else { continue };
            let children = relation.get_refs(child).or_else(|| relation.get_ref(child).map(|c| vec![c]));
            for child in children.unwrap_or_default() {
                map.entry(child).or_insert(parent);
            }
        }
        r
    }

    /// The nearest ancestor for which `find` has an answer, the entity itself included.
    pub fn climb<T>(&self, entity: u32, find: impl Fn(u32) -> Option<T>) -> Option<T> {
        let mut at = entity;
        for _ in 0..MAX_DEPTH {
            if let Some(found) = find(at) {
                return Some(found);
            }
            at = *self.inside.get(&at).or(self.whole_of.get(&at)).or(self.via.get(&at))?;
        }
        None
    }
}
