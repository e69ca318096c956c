//! Cancel and statement_timeout.

use pgrx::pg_sys;

/// Serves pending interrupts; for [`asbuilt_core::Interrupt`]. A cancel raises its error from here.
///
/// pgrx's `check_for_interrupts!` compiles to a read that the optimiser hoists out of loops; this one is volatile.
pub fn interrupt() -> bool {
    unsafe {
        if std::ptr::read_volatile(&raw const pg_sys::InterruptPending) != 0 {
            pg_sys::ProcessInterrupts();
        }
    }
    false
}
