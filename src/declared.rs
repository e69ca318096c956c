//! `_ab_declared()`: what every C function expects its SQL declaration to say; a test compares it with the catalogue.

use crate::pg::{Declared, RowField, SqlValue, sql_functions};
use crate::{aggregates, compat, gist, planner, types};

/// All of them.
fn all() -> impl Iterator<Item = Declared> {
    let rooms = [types::DECLARED, aggregates::DECLARED, compat::ALL_DECLARED];
    let files = rooms.into_iter().flatten().copied().chain([gist::DECLARED, planner::DECLARED, DECLARED]);
    files.flatten().copied()
}

sql_functions! {
    fn ab_declared(rows: Rows;) {
        for function in all() {
            rows.push(&[RowField::Text(function.to_text())]);
        }
        Ok(SqlValue::Null)
    }
}
