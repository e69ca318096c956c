//! Text form of the variable-length types: a prefix with the type's name and layout, then the bytes in hexadecimal.

use asbuilt_core::error::Limited;
use asbuilt_core::num::text::{from_hex, to_hex};
use asbuilt_core::{Error, Result};

use crate::pg::{Backend, SqlValue, TextInput, Varlena};

/// Longest text PostgreSQL can hold, with its terminator.
const MAX_TEXT: usize = (1 << 30) - 2;

/// The bytes that the text represents.
pub fn hex_in(text: &TextInput, ty: &'static str, prefix: &str) -> Result<Vec<u8>> {
    from_hex(ty, prefix, text.bytes(), &Backend)
}

/// The text of a value.
pub fn hex_out<T>(value: &Varlena<T>, prefix: &str) -> Result<SqlValue> {
    let bytes = value.bytes();
    let length = prefix.len() + 2 * bytes.len();
    if length > MAX_TEXT {
        let (value, limit) =
            (format!("{length} characters"), format!("{MAX_TEXT}; COPY ... (FORMAT binary) takes more"));
        return Err(Error::Limit { what: Limited::TextForm, value, limit });
    }
    Ok(SqlValue::CString(to_hex(prefix, bytes, &Backend)?))
}
