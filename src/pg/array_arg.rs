//! Arguments that are arrays; what is wrong with one is said by the name that the caller gives it.

use asbuilt_core::Result;
use nalgebra::SMatrix;

use super::encoding::from_server;
use super::{Args, FromArg};

/// A `float8[]`.
#[derive(Debug)]
pub struct F64Array<'a>(&'a Args, usize);

/// An `int4[]`.
#[derive(Debug)]
pub struct I32Array<'a>(&'a Args, usize);

/// A `boolean[]`.
#[derive(Debug)]
pub struct BoolArray<'a>(&'a Args, usize);

/// A `text[]`.
#[derive(Debug)]
pub struct TextArray<'a>(&'a Args, usize);

macro_rules! arrays {
    ($($type:ident, $sql_type:literal;)*) => {$(
        impl<'a> FromArg<'a> for $type<'a> {
            const SQL_TYPE: &'static str = $sql_type;

            fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
                Ok(Self(args, i))
            }
        }
    )*};
}

arrays! {
    F64Array, "float8[]";
    I32Array, "int4[]";
    BoolArray, "bool[]";
    TextArray, "text[]";
    ScanArray, "ab_scan[]";
}

impl F64Array<'_> {
    /// `N` numbers in one dimension.
    pub fn vector<const N: usize>(&self, what: &'static str) -> Result<[f64; N]> {
        self.0.vector(self.1, what)
    }

    /// Any number of them in one dimension.
    pub fn list(&self, what: &'static str) -> Result<Vec<f64>> {
        self.0.f64_list(self.1, what)
    }

    /// A square matrix of `N` x `N`, or of its numbers row by row.
    pub fn square<const N: usize>(&self, what: &'static str) -> Result<SMatrix<f64, N, N>> {
        self.0.square(self.1, what)
    }

    /// An array of n x 3.
    pub fn triples(&self, what: &'static str) -> Result<Vec<[f64; 3]>> {
        self.0.f64_triples(self.1, what)
    }

    /// How many dimensions it has.
    pub fn dimensions(&self) -> usize {
        self.0.dims(self.1).len()
    }

    /// How many rows, before any of them is read.
    pub fn rows(&self) -> usize {
        self.0.dims(self.1).first().map_or(0, |&n| n as usize)
    }
}

impl I32Array<'_> {
    /// `N` numbers in one dimension.
    pub fn vector<const N: usize>(&self, what: &'static str) -> Result<[i32; N]> {
        self.0.i32_vector(self.1, what)
    }

    /// How many rows, before any of them is read.
    pub fn rows(&self) -> usize {
        self.0.dims(self.1).first().map_or(0, |&n| n as usize)
    }

    /// Any number of them in one dimension.
    pub fn list(&self, what: &'static str) -> Result<Vec<i32>> {
        self.0.i32_list(self.1, what)
    }

    /// An array of n x 3.
    pub fn triples(&self, what: &'static str) -> Result<Vec<[i32; 3]>> {
        self.0.i32_triples(self.1, what)
    }
}

impl BoolArray<'_> {
    /// Any number of them in one dimension.
    pub fn list(&self, what: &'static str) -> Result<Vec<bool>> {
        self.0.bool_list(self.1, what)
    }
}

impl TextArray<'_> {
    /// Texts in one dimension, by the database's encoding; `None` for NULL.
    pub fn texts(&self, what: &'static str) -> Result<Vec<Option<String>>> {
        Ok(self.0.bytes_array(self.1, what)?.into_iter().map(|text| text.map(from_server)).collect())
    }

    /// The words; NULL elements are skipped.
    pub fn words(&self, what: &'static str) -> Result<Vec<String>> {
        let words = self.0.bytes_array(self.1, what)?;
        Ok(words.into_iter().flatten().map(|w| String::from_utf8_lossy(w).into_owned()).collect())
    }
}

/// An `ab_scan[]`.
#[derive(Debug)]
pub struct ScanArray<'a>(&'a Args, usize);

impl<'a> ScanArray<'a> {
    /// The bytes of each patch; NULL elements are skipped.
    pub fn elements(&self, what: &'static str) -> Result<Vec<&'a [u8]>> {
        Ok(self.0.bytes_array(self.1, what)?.into_iter().flatten().collect())
    }
}
