//! Little-endian cursors that cannot read past the end.

use nalgebra::Vector3;

use crate::error::{Error, Result};

/// Reads little-endian values from a slice; a slice that is too short gives an error that names the type.
#[derive(Debug, Clone)]
pub struct ByteReader<'a> {
    rest: &'a [u8],
    ty: &'static str,
}

impl<'a> ByteReader<'a> {
    /// A cursor at the start of `bytes`, for error messages about `ty`.
    pub fn new(bytes: &'a [u8], ty: &'static str) -> Self {
        Self { rest: bytes, ty }
    }

    /// How many bytes are left.
    pub fn remaining(&self) -> usize {
        self.rest.len()
    }

    /// The error "bytes are not a value of the type, because …".
    pub fn bad(&self, reason: impl Into<String>) -> Error {
        Error::binary(self.ty, reason)
    }

    /// The next `n` bytes.
    pub fn take(&mut self, n: usize) -> Result<&'a [u8]> {
        if n > self.rest.len() {
            return Err(self.bad(format!("{n} bytes expected, {} left", self.rest.len())));
        }
        let (head, tail) = self.rest.split_at(n);
        self.rest = tail;
        Ok(head)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let mut a = [0; N];
        a.copy_from_slice(self.take(N)?);
        Ok(a)
    }

    /// Next byte.
    pub fn u8(&mut self) -> Result<u8> {
        Ok(self.array::<1>()?[0])
    }

    /// Next 32-bit count.
    pub fn u32(&mut self) -> Result<u32> {
        self.array().map(u32::from_le_bytes)
    }

    /// Next 64-bit integer.
    pub fn i64(&mut self) -> Result<i64> {
        self.array().map(i64::from_le_bytes)
    }

    /// Next single-precision number.
    pub fn f32(&mut self) -> Result<f32> {
        self.array().map(f32::from_le_bytes)
    }

    /// Next double-precision number.
    pub fn f64(&mut self) -> Result<f64> {
        self.array().map(f64::from_le_bytes)
    }

    /// Next three double-precision numbers.
    pub fn vec3(&mut self) -> Result<Vector3<f64>> {
        Ok(Vector3::new(self.f64()?, self.f64()?, self.f64()?))
    }

    /// Next LEB128 integer of at most 64 bits.
    pub fn varint(&mut self) -> Result<u64> {
        let mut value = 0u64;
        for shift in (0..64).step_by(7) {
            let byte = self.u8()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(self.bad("integer longer than 64 bits"))
    }

    /// Next signed LEB128 integer (zigzag).
    pub fn varint_signed(&mut self) -> Result<i64> {
        let z = self.varint()?;
        Ok((z >> 1) as i64 ^ -((z & 1) as i64))
    }

    /// Fails unless everything was read.
    pub fn finish(self) -> Result<()> {
        match self.rest.len() {
            0 => Ok(()),
            n => Err(self.bad(format!("{n} bytes too many"))),
        }
    }
}

/// Appends little-endian values to a byte vector; the mirror of [`ByteReader`].
pub trait Put {
    /// Appends raw bytes.
    fn put(&mut self, bytes: &[u8]);

    /// Appends a 32-bit count.
    fn put_u32(&mut self, v: u32) {
        self.put(&v.to_le_bytes());
    }
    /// Appends a 64-bit integer.
    fn put_i64(&mut self, v: i64) {
        self.put(&v.to_le_bytes());
    }
    /// Appends a single-precision number.
    fn put_f32(&mut self, v: f32) {
        self.put(&v.to_le_bytes());
    }
    /// Appends a double-precision number.
    fn put_f64(&mut self, v: f64) {
        self.put(&v.to_le_bytes());
    }
    /// Appends three double-precision numbers.
    fn put_vec3(&mut self, v: &Vector3<f64>) {
        v.iter().for_each(|&c| self.put_f64(c));
    }
    /// Appends a LEB128 integer.
    fn put_varint(&mut self, mut v: u64) {
        while v >= 0x80 {
            self.put(&[v as u8 | 0x80]);
            v >>= 7;
        }
        self.put(&[v as u8]);
    }
    /// Appends a signed LEB128 integer (zigzag).
    fn put_varint_signed(&mut self, v: i64) {
        self.put_varint((v << 1 ^ v >> 63) as u64);
    }
}

impl Put for Vec<u8> {
    fn put(&mut self, bytes: &[u8]) {
        self.extend_from_slice(bytes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn varints_round_trip(a: u64, b: i64) {
            let mut v = Vec::new();
            v.put_varint(a);
            v.put_varint_signed(b);
            let mut r = ByteReader::new(&v, "test");
            prop_assert_eq!(r.varint().unwrap(), a);
            prop_assert_eq!(r.varint_signed().unwrap(), b);
            r.finish().unwrap();
        }

        #[test]
        fn damaged_varints_do_not_panic(bytes: Vec<u8>) {
            let mut r = ByteReader::new(&bytes, "test");
            while r.varint().is_ok() {}
        }
    }

    #[test]
    fn short_input_is_an_error() {
        assert!(ByteReader::new(&[1, 2, 3], "test").u32().is_err());
        assert!(ByteReader::new(&[0xff; 11], "test").varint().is_err());
        assert!(ByteReader::new(&[0], "test").finish().is_err());
    }
}
