//! Texts between the database's encoding and UTF-8.

use pgrx::pg_sys;

const UTF8: i32 = pg_sys::pg_enc::PG_UTF8 as i32;

/// A text of the database as UTF-8; what cannot be told is replaced.
pub fn from_server(bytes: &[u8]) -> String {
    let converted = convert(bytes, pg_sys::pg_server_to_any);
    String::from_utf8_lossy(converted.as_deref().unwrap_or(bytes)).into_owned()
}

/// A text in the encoding of the database; an error of PostgreSQL's where that lacks a letter.
pub fn to_server(text: &str) -> Vec<u8> {
    convert(text.as_bytes(), pg_sys::pg_any_to_server).unwrap_or_else(|| text.as_bytes().to_vec())
}

/// `None` where the bytes are the same in both.
fn convert(bytes: &[u8], by: unsafe fn(*const std::ffi::c_char, i32, i32) -> *mut std::ffi::c_char) -> Option<Vec<u8>> {
    // What is plain ASCII is the same in all of them, and needs no copy that ends with zero.
    if bytes.is_ascii() {
        return None;
    }
    let given = std::ffi::CString::new(bytes).ok()?;
    unsafe {
        let got = by(given.as_ptr(), bytes.len() as i32, UTF8);
        // Where nothing was to be done it gives the same place back.
        (!std::ptr::eq(got, given.as_ptr())).then(|| std::ffi::CStr::from_ptr(got).to_bytes().to_vec())
    }
}
