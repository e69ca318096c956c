//! Text form of the variable-length types: a prefix with the type's name and layout, then the bytes in hexadecimal.

use asbuilt_core::error::Limited;
use asbuilt_core::num::text::{from_hex, to_hex};
use asbuilt_core::{Error, Result};

use crate::pg::{Args, Backend, SqlValue};

/// Longest text PostgreSQL can hold, with its terminator.
const MAX_TEXT: usize = (1 << 30) - 2;

/// The bytes that the text in argument 0 of an input function represents.
pub fn hex_in(args: &Args, ty: &'static str, prefix: &str) -> Result<Vec<u8>> {
    from_hex(ty, prefix, args.cstring_bytes(0), &Backend)
}

/// The text of the value in argument 0.
pub fn hex_out(args: &Args, prefix: &str) -> Result<SqlValue> {
    let bytes = args.bytes(0);
    let length = prefix.len() + 2 * bytes.len();
    if length > MAX_TEXT {
        let (value, limit) =
            (format!("{length} characters"), format!("{MAX_TEXT}; COPY ... (FORMAT binary) takes more"));
        return Err(Error::Limit { what: Limited::TextForm, value, limit });
    }
    Ok(SqlValue::CString(to_hex(prefix, bytes, &Backend)?))
}
