//! Bodies with cavities (IfcFacetedBrepWithVoids): the geometry library draws them without. They are written as the
//! outer body less each cavity, whichever way its faces point.

use super::document::{Document, Edits};
use super::value::Value;

pub fn write_out(document: &Document, free: &mut dyn Iterator<Item = u64>, edits: &mut Edits) {
    let kinds = [("IFCFACETEDBREPWITHVOIDS", "IFCFACETEDBREP"), ("IFCADVANCEDBREPWITHVOIDS", "IFCADVANCEDBREP")];
    for (keyword, simple) in kinds {
        for record in document.all(keyword) {
            let values = document.values(record);
            let Some(outer) = values.first().and_then(Value::reference) else { continue };
            let cavities = values.get(1).map_or(&[][..], Value::list).iter().filter_map(Value::reference);
            let Some(text) = text(record.id, outer, cavities.collect(), simple, free) else { return };
            edits.replace(record.span.clone(), text);
        }
    }
}

fn text(
    id: u64,
    outer: u64,
    mut cavities: Vec<u64>,
    simple: &str,
    free: &mut dyn Iterator<Item = u64>,
) -> Option<String> {
    let (mut at, mut out) = (id, String::new());
    while let Some(cavity) = cavities.pop() {
        let [rest, body] = [free.next()?, free.next()?];
        out += &format!("#{at}=IFCBOOLEANRESULT(.DIFFERENCE.,#{rest},#{body});\n#{body}={simple}(#{cavity});\n");
        at = rest;
    }
    Some(out + &format!("#{at}={simple}(#{outer});"))
}
