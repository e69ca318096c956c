//! `ab_memory()`: what asbuilt takes in this session's process.

use crate::pg::{Field, SqlValue, memory_in_use, sql_functions};

sql_functions! {
    /// ab_memory(from_now)
    fn ab_memory(args) {
        let from_now = args.has(0) && args.bool(0);
        Ok(SqlValue::Row(memory_in_use(from_now).map(Field::I64).to_vec()))
    }
}
