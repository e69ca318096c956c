//! `ab_memory()`: what asbuilt takes in this session's process.

use crate::pg::{RowField, SqlValue, memory_in_use, sql_functions};

sql_functions! {
    fn ab_memory(from_now: Option<bool>) {
        Ok(SqlValue::Row(memory_in_use(from_now.unwrap_or(false)).map(RowField::I64).to_vec()))
    }
}
