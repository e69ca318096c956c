//! The structures that GiST hands to its support functions. Keys are boxes.

use asbuilt_core::Result;
use asbuilt_core::geometry::Aabb;
use pgrx::pg_sys;

use super::plain::PlainType;
use super::{Args, FromArg, SqlValue};

/// The keys that `union` and `picksplit` get.
#[derive(Debug)]
pub struct KeyVector(*mut pg_sys::GistEntryVector);

impl KeyVector {
    /// Key `i`, from 0; `picksplit` leaves the first place empty.
    pub fn key(&self, i: usize) -> Aabb {
        assert!(i < self.len());
        unsafe { key_at((*(*self.0).vector.as_ptr().add(i)).key) }
    }

    /// Number of places.
    pub fn len(&self) -> usize {
        unsafe { (*self.0).n as usize }
    }
}

unsafe fn key_at(key: pg_sys::Datum) -> Aabb {
    PlainType::of(&unsafe { key.cast_mut_ptr::<[f64; 6]>().read_unaligned() })
}

/// A `GISTENTRY`.
#[derive(Debug)]
pub struct Entry(*mut pg_sys::GISTENTRY);

impl Entry {
    /// Its key.
    pub fn key(&self) -> Aabb {
        unsafe { key_at((*self.0).key) }
    }

    /// `compress`: the entry, its value replaced by `key(prefix of the value)` if it is a leaf's; inner entries stay as
    /// they are.
    pub fn compressed(&self, prefix: usize, key: impl FnOnce(&[u8]) -> Result<Vec<u8>>) -> Result<SqlValue> {
        unsafe { self.compressed_by(|value| key(super::toast::prefix(value.cast_mut_ptr(), prefix))) }
    }

    /// The same for a value of `N` float8.
    pub fn compressed_fixed<const N: usize>(&self, key: impl FnOnce(&[f64; N]) -> Vec<u8>) -> Result<SqlValue> {
        unsafe { self.compressed_by(|value| Ok(key(&value.cast_mut_ptr::<[f64; N]>().read_unaligned()))) }
    }

    unsafe fn compressed_by(&self, key: impl FnOnce(pg_sys::Datum) -> Result<Vec<u8>>) -> Result<SqlValue> {
        unsafe {
            let entry = self.0;
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

/// Where a function writes its answer, or part of it: `recheck`, the result of `same`, the penalty, the size of a key.
#[derive(Debug)]
pub struct Answer<T>(*mut T);

impl<T> Answer<T> {
    /// Writes it.
    pub fn set(&self, value: T) {
        unsafe { self.0.write(value) }
    }

    /// The place itself, which some functions return.
    pub fn ret(&self) -> SqlValue {
        SqlValue::Raw(self.0.into())
    }
}

/// The right-hand side of an operator, of a type that the strategy number tells.
#[derive(Debug)]
pub struct GistQuery<'a>(&'a Args, usize);

impl<'a> FromArg<'a> for GistQuery<'a> {
    const SQL_TYPE: &'static str = "ab_box|ab_solid|ab_scan|ab_point|ab_line|ab_occupancy|ab_change";

    fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
        Ok(Self(args, i))
    }
}

impl<'a> GistQuery<'a> {
    /// The value, as the type that the operator of the strategy has.
    pub fn of<T: FromArg<'a>>(&self) -> Result<T> {
        T::from_arg(self.0, self.1)
    }
}

/// The `GIST_SPLITVEC` that `picksplit` fills.
#[derive(Debug)]
pub struct PickSplit(*mut pg_sys::GIST_SPLITVEC);

impl PickSplit {
    /// The structure itself, which `picksplit` returns.
    pub fn ret(&self) -> SqlValue {
        SqlValue::Raw(self.0.into())
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

/// Arguments that are addresses of structures.
macro_rules! structures {
    ($($type:ty),*) => {$(
        impl FromArg<'_> for $type {
            const SQL_TYPE: &'static str = "internal";

            fn from_arg(args: &Args, i: usize) -> Result<Self> {
                Ok(Self(args.datum(i).cast_mut_ptr()))
            }
        }
    )*};
}

structures!(KeyVector, Entry, PickSplit, Answer<bool>, Answer<f32>, Answer<i32>);
