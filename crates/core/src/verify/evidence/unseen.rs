//! The reasons for which a sample is not seen.

use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};

/// Why a sample was not seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// Another drawn object stands before it.
    HiddenByObject,
    /// Something that nobody drew stands before it.
    HiddenByOther,
    /// Beams came there, but too few, or they do not tell enough.
    TooFew,
    /// Beams came there at too steep an incidence.
    TooSteep,
    /// No beam was sent there, or only from behind.
    NotLookedAt,
    /// Beams were sent there, and nothing returned.
    NoReturn,
    /// What was met there may as well be another object's, drawn at the same place.
    SharedFace,
}

impl Why {
    /// In the order of SQL's `reason_shares`.
    pub const ALL: [Self; 7] = [
        Self::HiddenByObject,
        Self::HiddenByOther,
        Self::TooFew,
        Self::TooSteep,
        Self::NotLookedAt,
        Self::NoReturn,
        Self::SharedFace,
    ];

    /// SQL text.
    pub fn name(self) -> &'static str {
        ["hidden_by_object", "hidden_by_other", "too_few", "too_steep", "not_looked_at", "no_return", "shared_face"]
            [self as usize]
    }
}

/// Why an object stayed unobserved: the share of each [`Why`] in its samples. They add up to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unseen {
    shares: [f32; 7],
}

impl Unseen {
    /// Bytes of the stored form: the shares as f32, little-endian.
    pub const LEN: usize = 28;

    /// Of samples counted by reason; `None` of none.
    pub(in crate::verify) fn of(counts: &[u32; 7]) -> Option<Self> {
        let all: u32 = counts.iter().sum();
        (all > 0).then(|| Self { shares: counts.map(|n| n as f32 / all as f32) })
    }

    /// Shares without unit, in the order of [`Why::ALL`].
    pub fn shares(&self) -> [f64; 7] {
        self.shares.map(f64::from)
    }

    /// The one with the largest share.
    pub fn main(&self) -> Why {
        let larger = |a: &Why, b: &Why| self.shares[*a as usize].total_cmp(&self.shares[*b as usize]).then(b.cmp(a));
        Why::ALL.into_iter().max_by(larger).unwrap_or(Why::NotLookedAt)
    }

    /// Appends the stored form.
    pub(in crate::verify) fn write(&self, out: &mut Vec<u8>) {
        self.shares.iter().for_each(|s| out.put_f32(*s));
    }

    /// Reads the stored form; refuses what are no shares.
    pub(in crate::verify) fn read(r: &mut ByteReader) -> Result<Self> {
        let mut shares = [0.0; 7];
        for share in &mut shares {
            *share = r.f32()?;
        }
        let sum: f32 = shares.iter().sum();
        let are_shares = shares.iter().all(|s| (0.0..=1.0).contains(s)) && (sum - 1.0).abs() < 1e-3;
        if are_shares { Ok(Self { shares }) } else { Err(r.bad("its reasons are no shares")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_go_and_come_back_and_others_are_refused() {
        assert_eq!(Unseen::of(&[0; 7]), None);
        let unseen = Unseen::of(&[3, 0, 1, 0, 3, 0, 1]).unwrap();
        assert_eq!((unseen.main(), unseen.main().name()), (Why::HiddenByObject, "hidden_by_object"));
        let mut bytes = Vec::new();
        unseen.write(&mut bytes);
        assert_eq!(bytes.len(), Unseen::LEN);
        assert_eq!(Unseen::read(&mut ByteReader::new(&bytes, "x")).unwrap(), unseen);
        for (at, byte) in [(3, 0xff), (3, 0x40), (11, 0x7f)] {
            let mut damaged = bytes.clone();
            damaged[at] = byte;
            assert!(Unseen::read(&mut ByteReader::new(&damaged, "x")).is_err(), "{at}");
        }
    }
}
