//! Cancel and statement_timeout.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use pgrx::pg_sys;
use pgrx::pg_sys::ffi::pg_guard_ffi_boundary;

// Not among pgrx's bindings.
unsafe extern "C-unwind" {
    fn pq_check_connection() -> bool;
}

/// The client was checked for, and is gone.
static CLIENT_GONE: AtomicBool = AtomicBool::new(false);

/// Nobody has checked yet.
pub fn client_is_here() {
    CLIENT_GONE.store(false, Relaxed);
}

/// When `client_connection_check_interval` has passed, checks whether the client is there. On the main thread only;
/// PostgreSQL's own check, which ends the session, happens when interrupts are served.
pub fn look_for_client() {
    unsafe {
        let due = std::ptr::read_volatile(&raw const pg_sys::CheckClientConnectionPending) != 0;
        if due && !pg_guard_ffi_boundary(|| pq_check_connection()) {
            CLIENT_GONE.store(true, Relaxed);
        }
    }
}

/// Serves pending interrupts: a cancel raises its error from here. On the main thread only.
///
/// pgrx's `check_for_interrupts!` compiles to a read that the optimiser hoists out of loops; this one is volatile.
pub fn serve() {
    unsafe {
        if std::ptr::read_volatile(&raw const pg_sys::InterruptPending) != 0 {
            pg_sys::ProcessInterrupts();
        }
    }
}

/// Whether this query should end: read by other threads, which must not serve interrupts themselves.
pub fn is_due() -> bool {
    unsafe {
        std::ptr::read_volatile(&raw const pg_sys::QueryCancelPending) != 0
            || std::ptr::read_volatile(&raw const pg_sys::ProcDiePending) != 0
            || CLIENT_GONE.load(Relaxed)
    }
}
