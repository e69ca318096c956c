//! Returning a value.

use pgrx::pg_sys;

use super::array;
use super::interrupt::serve;
use super::rows::{self, RowField};

/// What an SQL function returns.
#[derive(Debug)]
pub enum SqlValue {
    /// NULL.
    Null,
    /// `boolean`.
    Bool(bool),
    /// `integer`.
    I32(i32),
    /// `bigint`.
    I64(i64),
    /// `float8`.
    F64(f64),
    /// `cstring`, from an output function.
    CString(String),
    /// `text`, `bytea` or one of our variable-length types.
    Bytes(Vec<u8>),
    /// A fixed-length type passed by reference.
    Fixed(Vec<u8>),
    /// `float8[]` with dimensions.
    F64Array(Vec<f64>, Vec<i32>),
    /// `int4[]` with dimensions.
    I32Array(Vec<i32>, Vec<i32>),
    /// An array of one of our variable-length types, as the function declares it; NULL when empty.
    VarlenaArray(Vec<Vec<u8>>),
    /// A row of the function's OUT columns.
    Row(Vec<RowField>),
    /// An address or a value handed through as it is.
    Raw(pg_sys::Datum),
}

impl SqlValue {
    /// A `text`.
    pub fn text(s: &str) -> Self {
        Self::Bytes(s.as_bytes().to_vec())
    }

    /// A `float8[]` of three numbers.
    pub fn vector(v: impl Into<[f64; 3]>) -> Self {
        Self::F64Array(v.into().to_vec(), vec![3])
    }

    /// A `float8[][]`.
    pub fn matrix<const N: usize>(m: &nalgebra::SMatrix<f64, N, N>) -> Self {
        Self::F64Array(m.transpose().iter().copied().collect(), vec![N as i32; 2])
    }

    pub(super) unsafe fn into_datum(self, fcinfo: pg_sys::FunctionCallInfo) -> pg_sys::Datum {
        match self {
            Self::Null => {
                unsafe { (*fcinfo).isnull = true };
                pg_sys::Datum::from(0usize)
            }
            Self::Bool(b) => pg_sys::Datum::from(b),
            Self::I32(v) => pg_sys::Datum::from(v),
            Self::I64(v) => pg_sys::Datum::from(v),
            Self::F64(v) => pg_sys::Datum::from(v.to_bits() as usize),
            Self::CString(s) => {
                let text = unsafe { pg_sys::palloc(s.len() + 1) }.cast::<u8>();
                unsafe {
                    copy(s.as_bytes(), text);
                    text.add(s.len()).write(0);
                }
                text.into()
            }
            Self::Bytes(b) => varlena(&b),
            Self::Fixed(b) => fixed(&b),
            Self::F64Array(v, dims) => array::of_f64(&v, &dims),
            Self::I32Array(v, dims) => array::of_i32(&v, &dims),
            Self::VarlenaArray(elements) => unsafe { array::of_varlenas(fcinfo, &elements) },
            Self::Row(fields) => unsafe { rows::composite(fcinfo, &fields) },
            Self::Raw(d) => d,
        }
    }
}

/// A new varlena in the current memory context; over 1 GB PostgreSQL itself raises the error.
pub fn varlena(bytes: &[u8]) -> pg_sys::Datum {
    unsafe {
        let (v, data) = new_varlena(bytes.len());
        copy(bytes, data);
        v.into()
    }
}

/// An unwritten varlena, and where its `len` bytes go.
pub unsafe fn new_varlena(len: usize) -> (*mut pg_sys::varlena, *mut u8) {
    unsafe {
        let total = len + pg_sys::VARHDRSZ;
        let v: *mut pg_sys::varlena = pg_sys::palloc(total).cast();
        pgrx::varlena::set_varsize_4b(v, total as i32);
        (v, v.cast::<u8>().add(pg_sys::VARHDRSZ))
    }
}

/// Copies in pieces, with interrupts between them: a gigabyte takes most of a second.
pub unsafe fn copy(from: &[u8], to: *mut u8) {
    const PIECE: usize = 1 << 24;
    for (i, piece) in from.chunks(PIECE).enumerate() {
        serve();
        unsafe { std::ptr::copy_nonoverlapping(piece.as_ptr(), to.add(i * PIECE), piece.len()) };
    }
}

/// A new fixed-length value in the current memory context.
pub fn fixed(bytes: &[u8]) -> pg_sys::Datum {
    unsafe {
        let p = pg_sys::palloc(bytes.len()).cast::<u8>();
        std::ptr::copy_nonoverlapping(bytes.as_ptr(), p, bytes.len());
        p.into()
    }
}
