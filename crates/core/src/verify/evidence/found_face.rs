//! A face that was found where the ordinary search does not reach.

use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};

/// A face of the object that stands farther from its drawn place than its surface is looked for there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundFace {
    /// Its number.
    pub face: u32,
    /// Along its outward normal, metres.
    pub deviation: f64,
    /// Standard deviation of that, metres.
    pub sd: f64,
    /// How many of the face's samples show it there.
    pub samples: u32,
}

impl FoundFace {
    /// Appends the stored form: face and samples u32, deviation and its σ as f64, little-endian.
    pub(in crate::verify) fn write(&self, out: &mut Vec<u8>) {
        out.put_u32(self.face);
        out.put_u32(self.samples);
        out.put_f64(self.deviation);
        out.put_f64(self.sd);
    }

    /// Reads the stored form, of an object with so many faces.
    pub(in crate::verify) fn read(r: &mut ByteReader, faces: usize) -> Result<Self> {
        let (face, samples) = (r.u32()?, r.u32()?);
        let (deviation, sd) = (r.f64()?, r.f64()?);
        let is_number = deviation.is_finite() && sd.is_finite() && sd >= 0.0;
        if face as usize >= faces || !is_number {
            return Err(r.bad(format!("a face {face} of {faces} found at {deviation}")));
        }
        Ok(Self { face, deviation, sd, samples })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_and_comes_back_and_others_are_refused() {
        let found = FoundFace { face: 3, deviation: -0.204, sd: 0.0021, samples: 812 };
        let mut bytes = Vec::new();
        found.write(&mut bytes);
        assert_eq!(FoundFace::read(&mut ByteReader::new(&bytes, "x"), 4).unwrap(), found);
        assert!(FoundFace::read(&mut ByteReader::new(&bytes, "x"), 3).is_err());
        for bad in [FoundFace { sd: -1.0, ..found }, FoundFace { deviation: f64::NAN, ..found }] {
            let mut bytes = Vec::new();
            bad.write(&mut bytes);
            assert!(FoundFace::read(&mut ByteReader::new(&bytes, "x"), 4).is_err());
        }
    }
}
