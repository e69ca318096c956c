//! What is done once, when the library is loaded.

use std::backtrace::Backtrace;
use std::ffi::CStr;

use pgrx::pg_sys;

/// From now on `SET prefix.name` is an error where we know no such setting.
pub fn reserve_settings(prefix: &CStr) {
    unsafe { pg_sys::MarkGUCPrefixReserved(prefix.as_ptr()) };
}

/// pgrx puts a backtrace, where the server's environment asks Rust for one, into the DETAIL that the client reads. The
/// standard library asks the environment once; it is asked here, and told no.
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
