//! The structures that GiST hands to its support functions.

use asbuilt_core::Result;
use pgrx::pg_sys;

use super::{Args, SqlValue};

/// Keys of 48 bytes (a box) that `union` and `picksplit` get.
#[derive(Debug)]
pub struct KeyVector(*mut pg_sys::GistEntryVector);

impl KeyVector {
    /// The vector in argument `i`.
    pub fn arg(args: &Args, i: usize) -> Self {
        Self(args.datum(i).cast_mut_ptr())
    }

    /// Key `i`, from 0; `picksplit` leaves the first place empty.
    pub fn key<const N: usize>(&self, i: usize) -> [u8; N] {
        assert!(i < self.len());
        unsafe { *(*(*self.0).vector.as_ptr().add(i)).key.cast_mut_ptr::<[u8; N]>() }
    }

    /// Number of places.
    pub fn len(&self) -> usize {
        unsafe { (*self.0).n as usize }
    }
}

impl Args {
    /// The key of the `GISTENTRY` in argument `i`, a fixed-length value.
    pub fn entry_key<const N: usize>(&self, i: usize) -> [u8; N] {
        unsafe {
            let entry: *mut pg_sys::GISTENTRY = self.datum(i).cast_mut_ptr();
            *(*entry).key.cast_mut_ptr::<[u8; N]>()
        }
    }

    /// An `internal` argument, to be handed back.
    pub fn pointer(&self, i: usize) -> pg_sys::Datum {
        self.datum(i)
    }

    /// Writes a flag through the pointer in argument `i`: `recheck` of consistent, the result of same.
    pub fn set_flag(&self, i: usize, value: bool) {
        unsafe { *self.datum(i).cast_mut_ptr::<bool>() = value }
    }

    /// Writes the penalty through the pointer in argument `i`.
    pub fn set_f32(&self, i: usize, value: f32) {
        unsafe { *self.datum(i).cast_mut_ptr::<f32>() = value }
    }

    /// Writes the size of a key through the pointer in argument `i`.
    pub fn set_size(&self, i: usize, value: usize) {
        unsafe { *self.datum(i).cast_mut_ptr::<i32>() = value as i32 }
    }

    /// `compress`: the entry in argument 0, its value replaced by `key(prefix of the value)` if it is a leaf's; inner
    /// entries stay as they are.
    pub fn compressed(&self, prefix: usize, key: impl FnOnce(&[u8]) -> Result<Vec<u8>>) -> Result<SqlValue> {
        unsafe { self.compressed_by(|value| key(super::toast::prefix(value.cast_mut_ptr(), prefix))) }
    }

    /// The same for a value of `N` float8.
    pub fn compressed_fixed<const N: usize>(&self, key: impl FnOnce(&[f64; N]) -> Vec<u8>) -> Result<SqlValue> {
        unsafe { self.compressed_by(|value| Ok(key(&value.cast_mut_ptr::<[f64; N]>().read_unaligned()))) }
    }

    unsafe fn compressed_by(&self, key: impl FnOnce(pg_sys::Datum) -> Result<Vec<u8>>) -> Result<SqlValue> {
        unsafe {
            let entry: *mut pg_sys::GISTENTRY = self.datum(0).cast_mut_ptr();
            if !(*entry).leafkey {
                return Ok(SqlValue::Raw(entry.into()));
            }
            let key = key((*entry).key)?;
            let copy: *mut pg_sys::GISTENTRY = pg_sys::palloc(size_of::<pg_sys::GISTENTRY>()).cast();
            *copy = *entry;
            (*copy).key = super::sql_value::fixed(&key);
            (*copy).leafkey = false;
            Ok(SqlValue::Raw(copy.into()))
        }
    }
}

/// The `GIST_SPLITVEC` that `picksplit` fills.
#[derive(Debug)]
pub struct PickSplit(*mut pg_sys::GIST_SPLITVEC);

impl PickSplit {
    /// The structure in argument `i`.
    pub fn arg(args: &Args, i: usize) -> Self {
        Self(args.datum(i).cast_mut_ptr())
    }

    /// Sets both sides: entry numbers (from 1) and union keys.
    pub fn set(&self, left: (&[u16], &[u8]), right: (&[u16], &[u8])) {
        unsafe {
            let copy = |numbers: &[u16]| {
                let p = pg_sys::palloc(size_of_val(numbers)).cast::<u16>();
                std::ptr::copy_nonoverlapping(numbers.as_ptr(), p, numbers.len());
                p
            };
            let v = &mut *self.0;
            v.spl_left = copy(left.0);
            v.spl_nleft = left.0.len() as i32;
            v.spl_ldatum = super::sql_value::fixed(left.1);
            v.spl_right = copy(right.0);
            v.spl_nright = right.0.len() as i32;
            v.spl_rdatum = super::sql_value::fixed(right.1);
        }
    }
}
