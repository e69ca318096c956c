//! The one map from core's errors to SQLSTATE, message and hint.

use asbuilt_core::Error;
use pgrx::pg_sys::errcodes::PgSqlErrorCode as Code;
use pgrx::pg_sys::panic::ErrorReport;

/// SQLSTATE of each of core's errors.
fn code(error: &Error) -> Code {
    match error {
        Error::Argument { .. }
        | Error::Empty { .. }
        | Error::Mismatch { .. }
        | Error::Lattice { .. }
        | Error::Covariance { .. } => Code::ERRCODE_INVALID_PARAMETER_VALUE,
        Error::TriangleIndex { .. } => Code::ERRCODE_ARRAY_ELEMENT_ERROR,
        Error::OpenSurface | Error::TotalConflict | Error::Degenerate { .. } => Code::ERRCODE_DATA_EXCEPTION,
        Error::Syntax { .. } => Code::ERRCODE_INVALID_TEXT_REPRESENTATION,
        Error::Binary { .. } => Code::ERRCODE_INVALID_BINARY_REPRESENTATION,
        Error::Corrupted { .. } => Code::ERRCODE_DATA_CORRUPTED,
        Error::Version { .. } => Code::ERRCODE_FEATURE_NOT_SUPPORTED,
        Error::Limit { .. } => Code::ERRCODE_PROGRAM_LIMIT_EXCEEDED,
        Error::Interrupted => Code::ERRCODE_QUERY_CANCELED,
    }
}

/// The PostgreSQL report of an error met in SQL function `function`.
pub fn report(error: &Error, function: &'static str) -> ErrorReport {
    let report = ErrorReport::new(code(error), error.to_string(), function);
    match error.hint() {
        Some(hint) => report.set_hint(hint),
        None => report,
    }
}
