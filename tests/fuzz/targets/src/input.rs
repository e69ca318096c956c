//! Numbers out of the fuzzer's bytes.

/// Takes numbers from the front; zero where nothing is left.
pub struct Input<'a>(pub &'a [u8]);

impl Input<'_> {
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// A length in metres: mostly tame multiples of a millimetre, now and then any number at all.
    pub fn metres(&mut self) -> f64 {
        match self.byte() {
            0xff => f64::from_le_bytes(std::array::from_fn(|_| self.byte())),
            0xfe => f64::from(i32::from_le_bytes(std::array::from_fn(|_| self.byte()))),
            high => f64::from(i16::from_be_bytes([high, self.byte()])) * 1e-3,
        }
    }

    pub fn vector(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.metres())
    }
}
