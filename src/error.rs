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
        Error::Version { .. } | Error::Section { .. } => Code::ERRCODE_FEATURE_NOT_SUPPORTED,
        Error::Limit { .. } => Code::ERRCODE_PROGRAM_LIMIT_EXCEEDED,
        Error::Memory { .. } | Error::OutOfMemory { .. } => Code::ERRCODE_OUT_OF_MEMORY,
        Error::Interrupted => Code::ERRCODE_QUERY_CANCELED,
    }
}

/// Whose fault unreadable bytes are: those given to an input function are the client's, others were stored by this
/// database.
fn seen_by(error: &Error, function: &str) -> (Error, Code) {
    let (ty, reason) = match error {
        Error::Binary { ty, reason } | Error::Corrupted { ty, reason } => (*ty, reason.clone()),
        other => return (other.clone(), code(other)),
    };
    if function.ends_with("_in") {
        return (Error::Binary { ty, reason }, Code::ERRCODE_INVALID_TEXT_REPRESENTATION);
    }
    // A geometry's bytes come from PostGIS, or from whoever gave them.
    let foreign = function.ends_with("_recv") || ty == "geometry";
    let error = if foreign { Error::Binary { ty, reason } } else { Error::Corrupted { ty, reason } };
    let code = code(&error);
    (error, code)
}

/// The PostgreSQL report of an error that occurred in SQL function `function`.
pub fn report(error: &Error, function: &'static str) -> ErrorReport {
    let (error, code) = seen_by(error, function);
    let report = ErrorReport::new(code, error.to_string(), function);
    match error.hint() {
        Some(hint) => report.set_hint(hint),
        None => report,
    }
}
