//! Reading a function's arguments by position. A Datum tells nothing of its type: only [`super::FromArg`] and what else
//! is in `pg` may do this.

use std::ffi::CStr;

use asbuilt_core::error::Limited;
use asbuilt_core::evidence::Loa;
use asbuilt_core::{Error, Result};
use pgrx::pg_sys;

use super::{SqlValue, array, toast};

/// The arguments of one call. Borrowed values live as long as the call.
#[derive(Debug)]
pub struct Args {
    fcinfo: pg_sys::FunctionCallInfo,
}

impl Args {
    /// # Safety
    /// `fcinfo` must be valid for the duration of the call.
    pub(super) unsafe fn new(fcinfo: pg_sys::FunctionCallInfo) -> Self {
        Self { fcinfo }
    }

    /// A value that came with no call, as argument 0; in the current memory context.
    pub(super) unsafe fn of_value(value: pg_sys::Datum) -> Self {
        unsafe {
            let size = size_of::<pg_sys::FunctionCallInfoBaseData>() + size_of::<pg_sys::NullableDatum>();
            let fcinfo: pg_sys::FunctionCallInfo = pg_sys::palloc0(size).cast();
            (*fcinfo).nargs = 1;
            (*fcinfo).args.as_mut_ptr().write(pg_sys::NullableDatum { value, isnull: false });
            Self { fcinfo }
        }
    }

    pub(super) fn fcinfo(&self) -> pg_sys::FunctionCallInfo {
        self.fcinfo
    }

    /// Number of arguments.
    pub fn len(&self) -> usize {
        unsafe { (*self.fcinfo).nargs as usize }
    }

    fn slot(&self, i: usize) -> pg_sys::NullableDatum {
        assert!(i < self.len(), "argument {i} of {}", self.len());
        unsafe { *(*self.fcinfo).args.as_ptr().add(i) }
    }

    /// Whether argument `i` is NULL.
    pub fn is_null(&self, i: usize) -> bool {
        self.slot(i).isnull
    }

    /// Whether argument `i` is there and not NULL.
    pub fn has(&self, i: usize) -> bool {
        i < self.len() && !self.is_null(i)
    }

    /// The value; a NULL that reaches this far is a bug, and a panic is better than its address.
    pub(super) fn datum(&self, i: usize) -> pg_sys::Datum {
        let slot = self.slot(i);
        assert!(!slot.isnull, "argument {i} is NULL");
        slot.value
    }

    /// A `float8`.
    pub(super) fn f64(&self, i: usize) -> f64 {
        f64::from_bits(self.datum(i).value() as u64)
    }

    /// A `bigint`.
    pub(super) fn i64(&self, i: usize) -> i64 {
        self.datum(i).value() as i64
    }

    /// A `boolean`.
    pub(super) fn bool(&self, i: usize) -> bool {
        self.datum(i).value() & 0xff != 0
    }

    /// An `integer`.
    pub(super) fn i32(&self, i: usize) -> i32 {
        self.datum(i).value() as i32
    }

    /// A `smallint`.
    pub(super) fn i16(&self, i: usize) -> i16 {
        self.datum(i).value() as i16
    }

    /// A `cstring`, as an input function gets it; unchecked.
    pub(super) fn cstring_bytes(&self, i: usize) -> &[u8] {
        unsafe { CStr::from_ptr(self.datum(i).cast_mut_ptr()) }.to_bytes()
    }

    /// A `text`: a word, a query.
    pub(super) fn text(&self, i: usize) -> String {
        const LONGEST: usize = 16 << 20;
        let bytes = self.bytes(i);
        if bytes.len() > LONGEST {
            let (value, limit) = (format!("{} bytes long", bytes.len()), format!("{LONGEST}"));
            super::function::raise(&Error::Limit { what: Limited::TextArgument, value, limit }, "asbuilt");
        }
        String::from_utf8_lossy(bytes).into_owned()
    }

    /// The value of the enum `ab_loa`.
    pub(super) fn loa(&self, i: usize) -> Result<Loa> {
        let oid = pg_sys::Oid::from(self.datum(i).value() as u32);
        Loa::parse(&pgrx::enum_helper::lookup_enum_by_oid(oid).0)
    }

    fn varlena(&self, i: usize) -> *mut pg_sys::varlena {
        self.datum(i).cast_mut_ptr()
    }

    /// All bytes of a variable-length value, fetched and decompressed if need be.
    pub(super) fn bytes(&self, i: usize) -> &[u8] {
        unsafe { pgrx::varlena::varlena_to_byte_slice(toast::fetch(self.varlena(i))) }
    }

    /// A variable-length value handed on: to send, or to return an argument as it came. Always a copy: PostgreSQL's
    /// `array_send` frees what a send function returns, even if it is an element of the array.
    pub(super) fn copied(&self, i: usize) -> SqlValue {
        SqlValue::Raw(unsafe { toast::copy_of(self.varlena(i)) }.into())
    }

    /// At least the first `len` bytes (or all there are), without fetching the rest where that can be avoided.
    pub(super) fn prefix(&self, i: usize, len: usize) -> &[u8] {
        unsafe { toast::prefix(self.varlena(i), len) }
    }

    /// The value as it is stored in the row, unfetched: equal bytes mean the same value.
    pub(super) fn raw(&self, i: usize) -> &[u8] {
        unsafe {
            let v = self.varlena(i);
            std::slice::from_raw_parts(v.cast::<u8>(), pgrx::varlena::varsize_any(v))
        }
    }

    /// A fixed-length value passed by reference.
    pub(super) fn fixed<const N: usize>(&self, i: usize) -> [u8; N] {
        unsafe { *self.datum(i).cast_mut_ptr::<[u8; N]>() }
    }

    /// A fixed-length value of `N` float8.
    pub(super) fn numbers<const N: usize>(&self, i: usize) -> [f64; N] {
        unsafe { self.datum(i).cast_mut_ptr::<[f64; N]>().read_unaligned() }
    }

    /// What is left of the message that a receive function gets; marks it as read.
    pub(super) fn message(&self, i: usize) -> &[u8] {
        unsafe {
            let buffer: pg_sys::StringInfo = self.datum(i).cast_mut_ptr();
            let left = (*buffer).len - (*buffer).cursor;
            let start = pg_sys::pq_getmsgbytes(buffer, left);
            std::slice::from_raw_parts(start.cast::<u8>(), left as usize)
        }
    }

    /// A `float8[]` of one dimension with `N` elements.
    pub(super) fn vector<const N: usize>(&self, i: usize, what: &'static str) -> Result<[f64; N]> {
        let (dims, values) = self.f64_array(i, what)?;
        match (dims.len(), <[f64; N]>::try_from(&values[..])) {
            (1, Ok(v)) => Ok(v),
            _ => {
                let expected = if N == 3 { "an array of three numbers" } else { "an array of four numbers" };
                Err(Error::argument(what, expected, array::shape(&dims)))
            }
        }
    }

    /// A `float8[]` of one dimension.
    pub(super) fn f64_list(&self, i: usize, what: &'static str) -> Result<Vec<f64>> {
        self.list(i, what)
    }

    /// A square matrix: `float8[]` of `N` x `N`, or of its numbers row by row.
    pub(super) fn square<const N: usize>(&self, i: usize, what: &'static str) -> Result<nalgebra::SMatrix<f64, N, N>> {
        let (dims, values) = self.f64_array(i, what)?;
        if values.len() != N * N || dims.iter().any(|&d| d as usize != N && dims.len() != 1) {
            let expected = ["", "", "", "3 x 3", "4 x 4", "", "6 x 6", "7 x 7"].get(N).copied().unwrap_or("square");
            return Err(Error::argument(what, expected, array::shape(&dims)));
        }
        Ok(nalgebra::SMatrix::from_row_slice(&values))
    }

    /// A `float8[][]` of n x 3.
    pub(super) fn f64_triples(&self, i: usize, what: &'static str) -> Result<Vec<[f64; 3]>> {
        let (dims, values) = self.f64_array(i, what)?;
        array::triples(&dims, &values, what)
    }

    /// An `int4[][]` of n x 3.
    pub(super) fn i32_triples(&self, i: usize, what: &'static str) -> Result<Vec<[i32; 3]>> {
        let (dims, values) = unsafe { array::read(self.datum(i), what) }?;
        array::triples(&dims, &values, what)
    }

    /// An `int4[]` of one dimension with `N` elements.
    pub(super) fn i32_vector<const N: usize>(&self, i: usize, what: &'static str) -> Result<[i32; N]> {
        let values = self.i32_list(i, what)?;
        let n = values.len();
        values.try_into().map_err(|_| Error::argument(what, "an array of three numbers", format!("one of {n}")))
    }

    /// An `int4[]` of one dimension.
    pub(super) fn i32_list(&self, i: usize, what: &'static str) -> Result<Vec<i32>> {
        self.list(i, what)
    }

    pub(super) fn bool_list(&self, i: usize, what: &'static str) -> Result<Vec<bool>> {
        // A bool is stored as a byte, 0 or 1.
        Ok(self.list::<u8>(i, what)?.into_iter().map(|b| b != 0).collect())
    }

    fn list<T: Copy>(&self, i: usize, what: &'static str) -> Result<Vec<T>> {
        let (dims, values) = unsafe { array::read(self.datum(i), what) }?;
        match dims.len() {
            0 | 1 => Ok(values),
            _ => Err(Error::argument(what, "an array of one dimension", array::shape(&dims))),
        }
    }

    /// An array of a variable-length type aligned to four bytes; `None` for NULL elements.
    pub(super) fn bytes_array(&self, i: usize, what: &'static str) -> Result<Vec<Option<&[u8]>>> {
        unsafe { array::read_varlenas(self.datum(i), what) }
    }

    /// Dimensions of an array.
    pub(super) fn dims(&self, i: usize) -> Vec<i32> {
        unsafe { array::dims(self.datum(i)) }
    }

    /// Dimensions and elements of a `float8[]`.
    pub(super) fn f64_array(&self, i: usize, what: &'static str) -> Result<(Vec<i32>, Vec<f64>)> {
        unsafe { array::read(self.datum(i), what) }
    }
}
