//! Names of types.

use std::ffi::CStr;

use pgrx::pg_sys;

/// The unqualified name of a type; empty for one that does not exist.
pub fn type_name(oid: pg_sys::Oid) -> String {
    unsafe {
        let row = pg_sys::SearchSysCache1(pg_sys::SysCacheIdentifier::TYPEOID as i32, oid.into());
        if row.is_null() {
            return String::new();
        }
        let form = pg_sys::GETSTRUCT(row).cast::<pg_sys::FormData_pg_type>();
        let name = CStr::from_ptr((*form).typname.data.as_ptr()).to_string_lossy().into_owned();
        pg_sys::ReleaseSysCache(row);
        name
    }
}
