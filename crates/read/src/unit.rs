//! Units of length of files.

use anyhow::{Result, bail};

use super::RawScan;
use super::options::word;

/// What the numbers of a file count in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Unit {
    M,
    Cm,
    Mm,
    /// The international foot, 0.3048 m
    Ft,
    /// The foot of the US survey, 1200/3937 m
    UsFt,
    /// The inch, 25.4 mm
    In,
}

impl Unit {
    pub const ALL: [Self; 6] = [Self::M, Self::Cm, Self::Mm, Self::Ft, Self::UsFt, Self::In];

    pub fn metres(self) -> f64 {
        match self {
            Self::M => 1.0,
            Self::Cm => 0.01,
            Self::Mm => 0.001,
            Self::Ft => 0.3048,
            Self::UsFt => 1200.0 / 3937.0,
            Self::In => 0.0254,
        }
    }

    /// As `--file-unit` takes it.
    pub fn word(self) -> String {
        word(&self)
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::M => "metres",
            Self::Cm => "centimetres",
            Self::Mm => "millimetres",
            Self::Ft => "feet",
            Self::UsFt => "US survey feet",
            Self::In => "inches",
        }
    }
}

/// How a unit is printed: by its name, or by its length in metres.
pub fn called(metres: f64) -> String {
    let same = |u: &Unit| (u.metres() / metres - 1.0).abs() < 1e-9;
    Unit::ALL.into_iter().find(same).map_or_else(|| format!("units of {metres} m"), |u| u.name().into())
}

/// An error where the user's unit contradicts the file's.
pub fn check(told: f64, given: Option<Unit>) -> Result<()> {
    match given {
        // Both feet are the same but for two in a million: a difference nobody would notice by eye.
        Some(unit) if (unit.metres() / told - 1.0).abs() > 1e-9 => {
            bail!("it says that its numbers are {}, and --file-unit says {}", called(told), unit.name())
        }
        _ => Ok(()),
    }
}

/// Converts offsets and anchor to metres.
pub fn apply(unit: Option<Unit>, scan: &mut RawScan) {
    let Some(unit) = unit.filter(|u| *u != Unit::M) else { return };
    scan.content.beams.iter_mut().for_each(|b| b.offset *= unit.metres());
    scan.anchor *= unit.metres();
    scan.notes.push(format!("its numbers are taken for {} (--file-unit {})", unit.name(), unit.word()));
}
