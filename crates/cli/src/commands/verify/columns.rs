//! What is printed of a verdict.

use serde_json::Value;

use super::query::VerifiedObject;
use super::shift::{shift, shift_columns};
use crate::output::{Format, LengthUnit, rounded};

/// How it is printed.
#[derive(Debug, Clone, Copy)]
pub struct Layout {
    pub format: Format,
    pub unit: LengthUnit,
}

/// Whether what identifies an object is printed, too.
fn is_wide(format: Format) -> bool {
    format != Format::Table
}

/// The names of the columns.
pub fn columns(Layout { format, unit }: Layout) -> Vec<String> {
    let mut columns = vec!["id", "name"];
    if is_wide(format) {
        columns.extend(["global_id", "ifc_class", "storey"]);
    }
    columns.extend(["loa", "verdict", "best_loa", "samples", "coverage", "confirmed", "refuted", "open", "conflict"]);
    let mut columns: Vec<String> = columns.into_iter().map(String::from).collect();
    columns.extend(["deviation", "deviation_sd"].map(|name| unit.column(name)));
    columns.extend(shift_columns(format, unit));
    let mut more = face_columns(format).to_vec();
    more.push("reason");
    more.extend(reason_columns(format));
    more.push("hidden_by");
    if is_wide(format) {
        more.push("drawn_twice");
    }
    columns.extend(more.into_iter().map(String::from));
    columns
}

/// A verified object under [`columns`].
pub fn cells(o: &VerifiedObject, Layout { format, unit }: Layout) -> Vec<Value> {
    let text = |i: usize| o.row.get::<_, Option<String>>(i).map_or(Value::Null, Value::from);
    let number = |i: usize| o.row.get::<_, Option<f64>>(i);
    let mut out = vec![o.id.into(), text(1)];
    if is_wide(format) {
        out.extend([text(2), text(3), text(4)]);
    }
    let samples = o.row.get::<_, Option<i64>>(8).map_or(Value::Null, Value::from);
    out.extend([text(5), o.verdict.clone().into(), text(7), samples]);
    out.extend((9..14).map(|i| rounded(number(i), 3)));
    out.extend([number(14), number(15)].map(|metres| unit.value(metres)));
    out.extend(shift(format, unit, o.row.get(16), o.row.get(17)));
    if is_wide(format) {
        out.extend(numbers(format, o.row.get(18), 3, 6));
        out.push(o.row.get::<_, Option<i32>>(19).map_or(Value::Null, Value::from));
    }
    out.push(text(20));
    if is_wide(format) {
        out.extend(numbers(format, o.row.get(21), 7, 3));
    }
    out.push(text(22));
    if is_wide(format) {
        out.push(text(23));
    }
    out
}

/// The face that the deviation is of.
fn face_columns(format: Format) -> &'static [&'static str] {
    match format {
        Format::Table => &[],
        Format::Csv | Format::CsvExact => &["normal_x", "normal_y", "normal_z", "deviation_face"],
        Format::Json => &["deviation_normal", "deviation_face"],
    }
}

/// The shares of the reasons for which an object was not seen.
fn reason_columns(format: Format) -> &'static [&'static str] {
    match format {
        Format::Table => &[],
        Format::Csv | Format::CsvExact => &[
            "hidden_by_object",
            "hidden_by_other",
            "too_few",
            "too_steep",
            "not_looked_at",
            "no_return",
            "shared_face",
        ],
        Format::Json => &["reason_shares"],
    }
}

/// `count` numbers: a column each for spreadsheets, an array for programs.
fn numbers(format: Format, values: Option<Vec<f64>>, count: usize, digits: i32) -> Vec<Value> {
    let values = values.map(|v| v.into_iter().map(|x| rounded(Some(x), digits)).collect::<Vec<_>>());
    match format {
        Format::Json => vec![values.map_or(Value::Null, Value::from)],
        _ => values.unwrap_or(vec![Value::Null; count]),
    }
}
