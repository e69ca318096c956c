//! Telling our own types from others of the same name.

use std::ffi::CStr;

use pgrx::pg_sys;

use super::Args;

/// The name of one of our types, or of a domain over it; `None` for any other type, whatever its name. Ours are those in
/// the schema of the function that is called, wherever the extension was moved to.
pub fn own_type_name(args: &Args, oid: pg_sys::Oid) -> Option<String> {
    unsafe {
        let row = pg_sys::SearchSysCache1(pg_sys::SysCacheIdentifier::TYPEOID as i32, pg_sys::getBaseType(oid).into());
        if row.is_null() {
            return None;
        }
        let form = pg_sys::GETSTRUCT(row).cast::<pg_sys::FormData_pg_type>();
        let name = CStr::from_ptr((*form).typname.data.as_ptr()).to_string_lossy().into_owned();
        let schema = (*form).typnamespace;
        pg_sys::ReleaseSysCache(row);
        let own = pg_sys::get_func_namespace((*(*args.fcinfo()).flinfo).fn_oid);
        (schema == own).then_some(name)
    }
}
