//! In which unit lengths are printed; it stands in the name of every column of them.

use serde_json::Value;

use super::{Format, rounded};

/// A unit of length.
#[derive(clap::ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres
    Mm,
    /// Metres
    M,
}

impl LengthUnit {
    /// The one that was asked for; else millimetres for people, metres for programs.
    pub fn or_default(given: Option<Self>, format: Format) -> Self {
        given.unwrap_or(if format == Format::Table { Self::Mm } else { Self::M })
    }

    /// The name of a column of lengths.
    pub fn column(self, name: &str) -> String {
        let unit = match self {
            Self::Mm => "mm",
            Self::M => "m",
        };
        format!("{name}_{unit}")
    }

    fn of_metres(self, metres: f64) -> f64 {
        match self {
            Self::Mm => metres * 1e3,
            Self::M => metres,
        }
    }

    /// Decimals of a tenth of a millimetre.
    fn digits(self) -> usize {
        match self {
            Self::Mm => 1,
            Self::M => 4,
        }
    }

    /// A length to a tenth of a millimetre.
    pub fn value(self, metres: Option<f64>) -> Value {
        rounded(metres.map(|m| self.of_metres(m)), self.digits() as i32)
    }

    /// The same as text; with its sign.
    pub fn signed(self, metres: f64) -> String {
        format!("{:+.*}", self.digits(), self.of_metres(metres))
    }

    /// The same as text.
    pub fn text(self, metres: f64) -> String {
        format!("{:.*}", self.digits(), self.of_metres(metres))
    }
}
