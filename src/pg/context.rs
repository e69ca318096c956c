//! What PostgreSQL's messages add under CONTEXT.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr::null;

use pgrx::pg_sys;

unsafe extern "C-unwind" {
    // Not among the bindings, for its arguments vary.
    fn errcontext_msg(format: *const c_char, ...) -> c_int;
}

/// Runs `work`; what PostgreSQL reports meanwhile is said to come from there.
pub fn within<T>(context: &CStr, work: impl FnOnce() -> T) -> T {
    /// Also where PostgreSQL's error unwinds the work.
    struct Restore(*mut pg_sys::ErrorContextCallback);

    impl Drop for Restore {
        fn drop(&mut self) {
            unsafe { pg_sys::error_context_stack = self.0 };
        }
    }

    unsafe {
        let restore = Restore(pg_sys::error_context_stack);
        let arg = context.as_ptr().cast_mut().cast();
        let mut callback = pg_sys::ErrorContextCallback { previous: restore.0, callback: Some(tell), arg };
        pg_sys::error_context_stack = &raw mut callback;
        work()
    }
}

unsafe extern "C-unwind" fn tell(context: *mut c_void) {
    unsafe {
        pg_sys::set_errcontext_domain(null());
        errcontext_msg(c"%s".as_ptr(), context);
    }
}
