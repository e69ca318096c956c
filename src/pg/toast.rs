//! Fetching values that are stored out of line.

use pgrx::pg_sys;

use super::interrupt::serve;
use super::sql_value::{copy, new_varlena};

/// Values of this size and more are fetched in pieces: PostgreSQL serves no interrupt while it fetches one.
const PIECE: usize = 1 << 24;

/// The whole value, fetched and decompressed if need be.
///
/// # Safety
/// `v` must point to a variable-length value.
pub unsafe fn fetch(v: *mut pg_sys::varlena) -> *mut pg_sys::varlena {
    unsafe {
        let size = || pg_sys::toast_raw_datum_size(v.into()) - pg_sys::VARHDRSZ;
        // A compressed value would be decompressed from its start for every piece.
        let in_pieces =
            pgrx::varlena::varatt_is_1b_e(v) && size() > PIECE && pg_sys::toast_datum_size(v.into()) >= size();
        if in_pieces { fetch_in_pieces(v, size()) } else { pg_sys::pg_detoast_datum_packed(v) }
    }
}

/// A copy of the value, with a header of four bytes.
///
/// # Safety
/// `v` must point to a variable-length value.
pub unsafe fn copy_of(v: *mut pg_sys::varlena) -> *mut pg_sys::varlena {
    unsafe {
        let fetched = fetch(v);
        if fetched != v && !pgrx::varlena::varatt_is_1b(fetched) {
            return fetched;
        }
        let bytes = pgrx::varlena::varlena_to_byte_slice(fetched);
        let (own, data) = new_varlena(bytes.len());
        copy(bytes, data);
        own
    }
}

unsafe fn fetch_in_pieces(v: *mut pg_sys::varlena, size: usize) -> *mut pg_sys::varlena {
    unsafe {
        let (whole, data) = new_varlena(size);
        for start in (0..size).step_by(PIECE) {
            serve();
            let piece = pg_sys::pg_detoast_datum_slice(v, start as i32, PIECE.min(size - start) as i32);
            let bytes = pgrx::varlena::varlena_to_byte_slice(piece);
            assert!(bytes.len() == PIECE.min(size - start), "a stored value is shorter than it says");
            copy(bytes, data.add(start));
            pg_sys::pfree(piece.cast());
        }
        whole
    }
}

/// At least the first `len` bytes of a value (or all there are); fetched or decompressed no further than that.
///
/// # Safety
/// `v` must point to a variable-length value that outlives the slice.
pub unsafe fn prefix<'a>(v: *mut pg_sys::varlena, len: usize) -> &'a [u8] {
    unsafe {
        let stored_elsewhere = pgrx::varlena::varatt_is_1b_e(v) || pgrx::varlena::varatt_is_4b_c(v);
        let v = if stored_elsewhere { pg_sys::pg_detoast_datum_slice(v, 0, len as i32) } else { v };
        pgrx::varlena::varlena_to_byte_slice(v)
    }
}
