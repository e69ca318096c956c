//! What `--origins` can be.

use std::convert::Infallible;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Where the origins of a file's points come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OriginsChoice {
    /// Points without origin, whatever the file says.
    None,
    /// From the points themselves, where they prove it.
    Recover,
    /// From a listing of scanner positions.
    Listed(PathBuf),
}

impl FromStr for OriginsChoice {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(match text {
            "none" => Self::None,
            "recover" => Self::Recover,
            file => Self::Listed(file.into()),
        })
    }
}

impl fmt::Display for OriginsChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Recover => f.write_str("recover"),
            Self::Listed(file) => write!(f, "{}", file.display()),
        }
    }
}
