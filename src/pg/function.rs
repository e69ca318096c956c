//! Raw version-1 functions: panics and core errors become PostgreSQL errors.

use asbuilt_core::Result;
use pgrx::pg_sys;
use pgrx::pg_sys::submodules::panic::pgrx_extern_c_guard;

use super::{Args, Ret};

/// Runs the body of an SQL function.
///
/// # Safety
/// `fcinfo` must be the pointer PostgreSQL called the function with.
pub unsafe fn run(
    fcinfo: pg_sys::FunctionCallInfo,
    name: &'static str,
    body: impl FnOnce(&Args) -> Result<Ret>,
) -> pg_sys::Datum {
    unsafe {
        pgrx_extern_c_guard(move || {
            let args = Args::new(fcinfo);
            match body(&args) {
                Ok(ret) => ret.into_datum(fcinfo),
                Err(error) => {
                    crate::error::report(&error, name).report(pgrx::PgLogLevel::ERROR);
                    unreachable!("an ERROR report does not return")
                }
            }
        })
    }
}

/// Declares SQL-callable functions: `fn name(args) { body }`, the body an expression of `Result<Ret, Error>`.
macro_rules! sql_functions {
    ($($(#[$meta:meta])* fn $name:ident($args:ident) $body:block)*) => {
        $(
            const _: () = {
                #[unsafe(export_name = concat!("pg_finfo_", stringify!($name)))]
                extern "C-unwind" fn finfo() -> *const pgrx::pg_sys::Pg_finfo_record {
                    const V1: pgrx::pg_sys::Pg_finfo_record = pgrx::pg_sys::Pg_finfo_record { api_version: 1 };
                    &V1
                }

                $(#[$meta])*
                #[unsafe(export_name = stringify!($name))]
                unsafe extern "C-unwind" fn entry(fcinfo: pgrx::pg_sys::FunctionCallInfo) -> pgrx::pg_sys::Datum {
                    #[allow(unused_variables)]
                    unsafe {
                        $crate::pg::run(fcinfo, stringify!($name), |$args: &$crate::pg::Args| $body)
                    }
                }
            };
        )*
    };
}
pub(crate) use sql_functions;
