//! What is done once, when the library is loaded.

use std::backtrace::Backtrace;
use std::ffi::CStr;

use pgrx::pg_sys;

/// Makes `SET prefix.name` an error where there is no such setting.
pub fn reserve_settings(prefix: &CStr) {
    unsafe { pg_sys::MarkGUCPrefixReserved(prefix.as_ptr()) };
}

/// Where the server's environment asks Rust for a backtrace, pgrx puts it into the DETAIL that the client reads. The
/// standard library reads the environment once; this makes it do so while the variable is off.
pub fn capture_no_backtraces() {
    const NAME: &str = "RUST_LIB_BACKTRACE";
    let before = std::env::var_os(NAME);
    // A backend has one thread when it loads a library.
    unsafe { std::env::set_var(NAME, "0") };
    drop(Backtrace::capture());
    match before {
        Some(value) => unsafe { std::env::set_var(NAME, value) },
        None => unsafe { std::env::remove_var(NAME) },
    }
}
