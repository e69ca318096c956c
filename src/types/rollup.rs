//! How `ab_rollup` of two values treats NULL.

use asbuilt_core::Result;

use crate::pg::{SqlValue, Varlena};

/// `a` and `b` added up by `sum`; NULL counts as nothing.
pub fn rolled_up<T>(
    a: Option<Varlena<T>>,
    b: Option<Varlena<T>>,
    sum: impl FnOnce(Varlena<T>, Varlena<T>) -> Result<SqlValue>,
) -> Result<SqlValue> {
    match (a, b) {
        (None, None) => Ok(SqlValue::Null),
        (Some(one), None) | (None, Some(one)) => Ok(one.copied()),
        (Some(a), Some(b)) => sum(a, b),
    }
}
