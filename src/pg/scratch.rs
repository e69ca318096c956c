//! A memory context for what is needed for only one row.

use std::ffi::CStr;

use pgrx::pg_sys;

/// A new one under the current context; to be reset after every row.
pub unsafe fn scratch_context(name: &'static CStr) -> pg_sys::MemoryContext {
    unsafe {
        pg_sys::AllocSetContextCreateInternal(
            pg_sys::CurrentMemoryContext,
            name.as_ptr(),
            0,
            pg_sys::ALLOCSET_DEFAULT_INITSIZE as usize,
            pg_sys::ALLOCSET_DEFAULT_MAXSIZE as usize,
        )
    }
}
