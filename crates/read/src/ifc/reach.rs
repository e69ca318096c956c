//! Notes about single records, carried to the products that are made of them.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use ifc_lite_core::EntityIndex;

use super::step::{Step, references};
use super::told::Drafts;

/// The notes for every product; most files have none.
pub fn notes(step: &Step, index: &Arc<EntityIndex>, drafts: &Drafts) -> HashMap<u32, String> {
    let mut out = HashMap::new();
    if step.notes.is_empty() {
        return out;
    }
    let said: HashMap<u64, &str> = step.notes.iter().map(|(id, note)| (*id, note.as_str())).collect();
    for &id in drafts.keys() {
        let (mut seen, mut open, mut found) = (HashSet::new(), vec![id], Vec::new());
        while let Some(at) = open.pop() {
            if !seen.insert(at) {
                continue;
            }
            found.extend(said.get(&u64::from(at)).copied());
            if let Some(&(start, end)) = index.get(&at) {
                let from = start + 1;
                references(&step.text[from.min(end)..end], 0, |_, to| open.extend(u32::try_from(to)));
            }
        }
        if !found.is_empty() {
            out.insert(id, found.join("; "));
        }
    }
    out
}
