//! Where PostgreSQL's errors come from, when our code runs a query of the caller's.

use std::panic::AssertUnwindSafe;

use pgrx::pg_sys::errcodes::PgSqlErrorCode as Code;
use pgrx::pg_sys::panic::{CaughtError, ErrorReport};
use pgrx::{PgLogLevel, PgTryBuilder};

/// Runs `work`; an error of PostgreSQL's in it says under DETAIL that it came from `place`. (CONTEXT is lost where pgrx
/// carries errors through Rust.) Cancelling is nobody's error.
pub fn within<T>(place: &'static str, work: impl FnOnce() -> T) -> T {
    PgTryBuilder::new(AssertUnwindSafe(work))
        .catch_others(move |cause| match cause {
            CaughtError::PostgresError(error) if error.sql_error_code() != Code::ERRCODE_QUERY_CANCELED => {
                let detail = error.detail().map_or_else(String::new, |detail| format!(" {detail}"));
                let report = ErrorReport::new(error.sql_error_code(), error.message().to_owned(), "asbuilt")
                    .set_detail(format!("In {place}.{detail}"));
                let report = match error.hint() {
                    Some(hint) => report.set_hint(hint.to_owned()),
                    None => report,
                };
                report.report(PgLogLevel::ERROR);
                unreachable!("an ERROR report does not return")
            }
            cause => cause.rethrow(),
        })
        .execute()
}
