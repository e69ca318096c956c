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

/// Declares SQL-callable functions, the body an expression of `Result<SqlValue, Error>`:
///
/// * `fn name(box: Aabb, margin: Option<f64>) { body }`: with typed parameters ([`super::FromArg`]);
/// * `fn name(rows: Rows; box: Aabb) { body }`: the same, returning a set of rows;
/// * `fn name(call: Call; …)` and `fn name(call: Call, rows: Rows; …)`: the same, with the call itself.
///
/// Functions after `on Account::…;` take their memory on that account. The module's `DECLARED` tells what SQL is to
/// declare.
macro_rules! sql_functions {
    (on $account:expr; $($rest:tt)*) => { $crate::pg::sql_functions! { @ Some($account); $($rest)* } };
    (fn $($rest:tt)*) => { $crate::pg::sql_functions! { @ None; fn $($rest)* } };
    (# $($rest:tt)*) => { $crate::pg::sql_functions! { @ None; # $($rest)* } };
    (@ $account:expr; $($(#[$meta:meta])* fn $name:ident $parameters:tt $body:block)*) => {
        /// What SQL is to declare for the functions here.
        pub(crate) const DECLARED: &[$crate::pg::Declared] = &[$($crate::pg::Declared {
            symbol: stringify!($name),
            parameters: $crate::pg::parameters!($parameters),
        }),*];

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
                    unsafe {
                        $crate::pg::run(fcinfo, stringify!($name), $account, |args: &$crate::pg::Args| {
                            $crate::pg::bound!(args, $parameters, $body)
                        })
                    }
                }
            };
        )*
    };
}
pub(crate) use sql_functions;

/// The declared parameters of a parameter list.
macro_rules! parameters {
    (($call:ident: Call, $rows:ident: Rows; $($rest:tt)*)) => { $crate::pg::parameters!(($($rest)*)) };
    (($call:ident: Call; $($rest:tt)*)) => { $crate::pg::parameters!(($($rest)*)) };
    (($rows:ident: Rows; $($rest:tt)*)) => { $crate::pg::parameters!(($($rest)*)) };
    (($($name:ident: $type:ty),* $(,)?)) => { &[$($crate::pg::Parameter::of::<$type>()),*] };
}
pub(crate) use parameters;

/// A body with its parameters bound; NULL where an argument is NULL that must not be.
macro_rules! bound {
    ($call:ident, ($own:ident: Call, $rows:ident: Rows; $($rest:tt)*), $body:block) => {{
        let $own = $call;
        $crate::pg::bound!($call, ($rows: Rows; $($rest)*), $body)
    }};
    ($call:ident, ($own:ident: Call; $($rest:tt)*), $body:block) => {{
        let $own = $call;
        $crate::pg::bound!($call, ($($rest)*), $body)
    }};
    ($call:ident, ($rows:ident: Rows; $($rest:tt)*), $body:block) => {{
        let mut $rows = $crate::pg::Rows::new($call)?;
        $crate::pg::bound!($call, ($($rest)*), $body)
    }};
    ($call:ident, (), $body:block) => {{
        let _ = $call;
        $body
    }};
    ($call:ident, ($($name:ident: $type:ty),* $(,)?), $body:block) => {{
        if $crate::pg::lacks($call, &[$($crate::pg::Parameter::of::<$type>()),*]) {
            return Ok($crate::pg::SqlValue::Null);
        }
        let mut next = 0;
        $(
            #[allow(unused_variables)]
            let $name: $type = $crate::pg::next_arg($call, &mut next)?;
        )*
        $body
    }};
}
pub(crate) use bound;
