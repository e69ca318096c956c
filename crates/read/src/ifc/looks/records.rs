//! Small questions to the records of a file.

use std::collections::HashMap;

use ifc_lite_core::decode_ifc_string;

use crate::ifc::step::{Document, Value};

/// The text of an argument; `None` for none or an empty one.
pub fn text(values: &[Value], k: usize) -> Option<String> {
    let raw = String::from_utf8_lossy(values.get(k)?.text()?).into_owned();
    let text = decode_ifc_string(&raw).trim().to_owned();
    (!text.is_empty()).then_some(text)
}

/// The record that an argument refers to.
pub fn reference(values: &[Value], k: usize) -> Option<u64> {
    values.get(k).and_then(Value::reference)
}

/// The records that an argument refers to, one or a list.
pub fn references(values: &[Value], k: usize) -> Vec<u64> {
    let Some(value) = values.get(k) else { return Vec::new() };
    value.reference().into_iter().chain(value.list().iter().filter_map(Value::reference)).collect()
}

/// A record's keyword in capitals, and its arguments.
pub fn open<'a>(document: &Document<'a>, id: u64) -> Option<(String, Vec<Value<'a>>)> {
    let record = document.find(id)?;
    let keyword = String::from_utf8_lossy(&document.text()[record.keyword.clone()]).to_ascii_uppercase();
    Some((keyword, document.values(record)))
}

/// Of a relation: the one at argument `one`, by each of the many at argument `many`; the first counts.
pub fn relation(document: &Document, keyword: &str, many: usize, one: usize) -> HashMap<u64, u64> {
    let mut out = HashMap::new();
    for record in document.all(keyword) {
        let values = document.values(record);
        let Some(to) = reference(&values, one) else { continue };
        for from in references(&values, many) {
            out.entry(from).or_insert(to);
        }
    }
    out
}
