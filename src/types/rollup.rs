//! How `ab_rollup` of two values treats NULL.

use asbuilt_core::Result;

use crate::pg::{Args, SqlValue};

/// Arguments 0 and 1 added up by `sum`; NULL counts as nothing.
pub fn rolled_up(args: &Args, sum: impl FnOnce() -> Result<SqlValue>) -> Result<SqlValue> {
    match (args.is_null(0), args.is_null(1)) {
        (true, true) => Ok(SqlValue::Null),
        (false, true) => Ok(args.copied(0)),
        (true, false) => Ok(args.copied(1)),
        (false, false) => sum(),
    }
}
