//! Why a product has no mesh, where its records tell.

use std::sync::Arc;

use ifc_lite_core::EntityIndex;

use super::step::{Described, described};

/// Most records that are searched, and how deeply they may be nested.
const MAX_VISITED: usize = 2000;
const DEEPEST: usize = 64;

/// A file's records.
pub struct IfcFile<'a> {
    pub text: &'a [u8],
    pub index: &'a Arc<EntityIndex>,
}

/// What is wrong: a record that is missing, that refers to itself, or that has an impossible measure.
pub fn of(records: &IfcFile, product: u32) -> Option<String> {
    let mut search = Search { records, path: Vec::new(), seen: Default::default() };
    search.look(product)
}

struct Search<'a> {
    records: &'a IfcFile<'a>,
    path: Vec<u32>,
    seen: std::collections::HashSet<u32>,
}

impl Search<'_> {
    fn look(&mut self, id: u32) -> Option<String> {
        let of = self.path.last().copied();
        if self.path.contains(&id) {
            return Some(format!("{} is made of itself", self.shown(id)));
        }
        if !self.seen.insert(id) || self.seen.len() > MAX_VISITED || self.path.len() > DEEPEST {
            return None;
        }
        let Some(record) = self.described(id) else {
            return Some(format!("{} refers to #{id}, which is not in the file", self.shown(of?)));
        };
        if let Some(wrong) = wrong_measure(&record) {
            return Some(format!("{}: {wrong}", self.shown(id)));
        }
        self.path.push(id);
        let found = record.references.iter().filter_map(|&to| u32::try_from(to).ok()).find_map(|to| self.look(to));
        self.path.pop();
        found
    }

    fn described(&self, id: u32) -> Option<Described> {
        let &(start, end) = self.records.index.get(&id)?;
        described(self.records.text.get(start..end)?)
    }

    fn shown(&self, id: u32) -> String {
        self.described(id).map_or(format!("#{id}"), |r| format!("{} (#{id})", r.keyword))
    }
}

/// A measure that must be positive and is not.
fn wrong_measure(record: &Described) -> Option<String> {
    let Some(numbers) = &record.numbers else {
        // A record of several types at once has no list of its own.
        let is_plain = !record.keyword.is_empty();
        return is_plain.then(|| "its arguments cannot be read: write its numbers as in 1.5 or 1.5E3".into());
    };
    let (names, first): (&[&str], usize) = match record.keyword.as_str() {
        "IFCEXTRUDEDAREASOLID" | "IFCEXTRUDEDAREASOLIDTAPERED" => (&["depth"], 3),
        "IFCRECTANGLEPROFILEDEF" | "IFCROUNDEDRECTANGLEPROFILEDEF" | "IFCRECTANGLEHOLLOWPROFILEDEF" => {
            (&["width", "height"], 3)
        }
        "IFCCIRCLEPROFILEDEF" | "IFCCIRCLEHOLLOWPROFILEDEF" => (&["radius"], 3),
        "IFCELLIPSEPROFILEDEF" => (&["first radius", "second radius"], 3),
        "IFCISHAPEPROFILEDEF" | "IFCCSHAPEPROFILEDEF" | "IFCUSHAPEPROFILEDEF" | "IFCTSHAPEPROFILEDEF" => {
            (&["first size", "second size", "thickness"], 3)
        }
        "IFCSWEPTDISKSOLID" | "IFCCIRCLE" => (&["radius"], 1),
        "IFCBLOCK" => (&["x length", "y length", "z length"], 1),
        _ => return None,
    };
    let measure = |k: usize| numbers.get(first + k).copied().flatten();
    let wrong = names.iter().enumerate().find_map(|(k, name)| Some((name, measure(k).filter(|x| *x <= 0.0)?)));
    wrong.map(|(name, x)| format!("its {name} is {x}"))
}
