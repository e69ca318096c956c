//! Raw version-1 functions: panics and core errors become PostgreSQL errors.

use asbuilt_core::{Error, Result};
use pgrx::pg_sys;
use pgrx::pg_sys::submodules::panic::pgrx_extern_c_guard;

use super::memory::Account;
use super::{Args, SqlValue, allocator};

/// Runs the body of an SQL function, on an account of memory where one is named.
///
/// # Safety
/// `fcinfo` must be the pointer PostgreSQL called the function with.
pub unsafe fn run(
    fcinfo: pg_sys::FunctionCallInfo,
    name: &'static str,
    account: Option<Account>,
    body: impl FnOnce(&Args) -> Result<SqlValue>,
) -> pg_sys::Datum {
    unsafe {
        pgrx_extern_c_guard(move || {
            let args = Args::new(fcinfo);
            // What an earlier call was refused is its own matter.
            allocator::take_refusal();
            // Until the result is handed over: what it took is given back on the same account.
            let _opened = account.map(Account::open);
            let mut outcome = body(&args);
            if let (Some(bytes), Ok(_)) = (allocator::take_refusal(), &outcome) {
                outcome = Err(Error::OutOfMemory { bytes });
            }
            match outcome {
                Ok(ret) => {
                    if let (Some(account), SqlValue::Bytes(bytes)) = (account, &ret) {
                        account.hand_over(bytes.len());
                    }
                    ret.into_datum(fcinfo)
                }
                Err(error) => raise(&error, name),
            }
        })
    }
}

/// Raises an error of core's that occurred in the SQL function `name`.
pub fn raise(error: &Error, name: &'static str) -> ! {
    crate::error::report(error, name).report(pgrx::PgLogLevel::ERROR);
    unreachable!("an ERROR report does not return")
}

/// Declares SQL-callable functions: `fn name(args) { body }`, the body an expression of `Result<SqlValue, Error>`. Functions
/// after `on Account::…;` take their memory on that account.
macro_rules! sql_functions {
    (on $account:expr; $($rest:tt)*) => { $crate::pg::sql_functions! { @ Some($account); $($rest)* } };
    (fn $($rest:tt)*) => { $crate::pg::sql_functions! { @ None; fn $($rest)* } };
    (# $($rest:tt)*) => { $crate::pg::sql_functions! { @ None; # $($rest)* } };
    (@ $account:expr; $($(#[$meta:meta])* fn $name:ident($args:ident) $body:block)*) => {
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
                        $crate::pg::run(fcinfo, stringify!($name), $account, |$args: &$crate::pg::Args| $body)
                    }
                }
            };
        )*
    };
}
pub(crate) use sql_functions;
