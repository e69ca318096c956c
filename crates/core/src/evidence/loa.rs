//! USIBD Level of Accuracy.

use crate::error::{Error, Result};

/// USIBD Level of Accuracy (Specification Guide, version 2.0 2016): the range that 95 % of deviations stay within.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Loa {
    /// 50-150 mm.
    Loa10,
    /// 15-50 mm.
    Loa20,
    /// 5-15 mm.
    Loa30,
    /// 1-5 mm.
    Loa40,
    /// 0-1 mm.
    Loa50,
}

impl Loa {
    /// All classes, coarsest first.
    pub const ALL: [Self; 5] = [Self::Loa10, Self::Loa20, Self::Loa30, Self::Loa40, Self::Loa50];

    /// Upper bound of the class, metres, held at the 95 % (2σ) level: the tolerance ±T of a verdict.
    pub fn upper(self) -> f64 {
        [0.150, 0.050, 0.015, 0.005, 0.001][self as usize]
    }

    /// Lower bound of the class, metres.
    pub fn lower(self) -> f64 {
        [0.050, 0.015, 0.005, 0.001, 0.0][self as usize]
    }

    /// `LOA10` … `LOA50`.
    pub fn name(self) -> &'static str {
        ["LOA10", "LOA20", "LOA30", "LOA40", "LOA50"][self as usize]
    }

    /// Reads a class name in upper or lower case, with or without a blank before the number.
    pub fn parse(text: &str) -> Result<Self> {
        let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        Self::ALL
            .into_iter()
            .find(|l| l.name().eq_ignore_ascii_case(&plain))
            .ok_or_else(|| Error::argument("the level of accuracy", "one of LOA10, LOA20, LOA30, LOA40, LOA50", text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_contiguous_and_parse() {
        for pair in Loa::ALL.windows(2) {
            assert_eq!(pair[0].lower(), pair[1].upper());
        }
        assert_eq!(Loa::parse("loa 30").unwrap(), Loa::Loa30);
        assert!(Loa::parse("LOA35").is_err());
    }
}
