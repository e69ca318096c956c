//! Cancel and statement_timeout.

use pgrx::pg_sys;

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

/// Whether this query is to end: read by other threads, which must not serve interrupts themselves.
pub fn is_due() -> bool {
    unsafe {
        std::ptr::read_volatile(&raw const pg_sys::QueryCancelPending) != 0
            || std::ptr::read_volatile(&raw const pg_sys::ProcDiePending) != 0
    }
}
