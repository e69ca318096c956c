//! Doors and windows of which the file says that nothing opens: IfcWindowPanelProperties and IfcDoorPanelProperties.

use std::collections::{HashMap, HashSet};

use super::records::{open, references};
use crate::ifc::step::{Document, Value};

/// Products and types by whether a panel of theirs is fixed, and whether one opens.
#[derive(Debug, Default)]
pub struct Fixed {
    fixed: HashSet<u64>,
    opening: HashSet<u64>,
    type_of: HashMap<u64, u64>,
}

impl Fixed {
    pub fn read(document: &Document, type_of: &HashMap<u64, u64>) -> Self {
        let mut out = Self { type_of: type_of.clone(), ..Self::default() };
        for record in document.all("IFCRELDEFINESBYPROPERTIES") {
            let values = document.values(record);
            let owners = references(&values, 4);
            references(&values, 5).into_iter().for_each(|set| out.add(document, set, &owners));
        }
        for keyword in ["IFCWINDOWSTYLE", "IFCWINDOWTYPE", "IFCDOORSTYLE", "IFCDOORTYPE"] {
            for record in document.all(keyword) {
                let sets = references(&document.values(record), 5);
                sets.into_iter().for_each(|set| out.add(document, set, &[record.id]));
            }
        }
        out
    }

    fn add(&mut self, document: &Document, set: u64, owners: &[u64]) {
        let Some((keyword, values)) = open(document, set) else { return };
        let operation = match keyword.as_str() {
            "IFCWINDOWPANELPROPERTIES" => values.get(4),
            "IFCDOORPANELPROPERTIES" => values.get(5),
            _ => return,
        };
        let Some(Value::Enumerated(operation)) = operation else { return };
        if operation.to_ascii_uppercase().starts_with(b"FIXED") {
            self.fixed.extend(owners);
        } else {
            self.opening.extend(owners);
        }
    }

    /// Whether it has panels, none of which opens.
    pub fn is_fixed(&self, product: u64) -> bool {
        let all = [Some(product), self.type_of.get(&product).copied()];
        let any = |of: &HashSet<u64>| all.iter().flatten().any(|id| of.contains(id));
        any(&self.fixed) && !any(&self.opening)
    }
}
