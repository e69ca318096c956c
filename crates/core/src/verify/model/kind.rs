//! Which models there are.

use crate::error::{Error, Result};

/// From one list: the kinds, their names, and [`with_model`], which is the only place that branches on the kind.
macro_rules! models {
    (($d:tt) $($(#[doc = $doc:literal])+ $kind:ident = $number:literal, $name:literal;)+) => {
        /// How beams become belief.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[repr(u32)]
        pub enum ModelKind {
            $($(#[doc = $doc])+ $kind = $number,)+
        }

        impl ModelKind {
            const ALL: &'static [Self] = &[$(Self::$kind),+];

            /// SQL name.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)+
                }
            }
        }

        /// Evaluates an expression with the type of a kind's [`BeamModel`](super::BeamModel) under a name, so that
        /// whatever it calls is made for that model: nothing is dispatched beam by beam.
        macro_rules! with_model {
            ($d kind:expr, $d model:ident => $d body:expr) => {
                match $d kind {
                    $($crate::verify::ModelKind::$kind => {
                        type $d model = $crate::verify::model::$kind;
                        $d body
                    })+
                }
            };
        }
    };
}

// Each with the number that is stored, and its SQL name; its type in this folder has the kind's name.
models! { ($)
    /// Distance of the built surface from the drawn face, one body of evidence a station (docs/method.md). The default.
    Surface = 0, "surface";
    /// The published ray model: every beam a source of its own. Wrong on grazed surfaces; for comparison.
    Meyer2022 = 1, "meyer2022";
}

pub(in crate::verify) use with_model;

/// All names of the list above, for messages.
const NAMES: &str = "'surface' or 'meyer2022'";

impl ModelKind {
    /// Reads a SQL name.
    pub fn parse(text: &str) -> Result<Self> {
        let found = Self::ALL.iter().find(|k| k.name() == text).copied();
        found.ok_or_else(|| Error::argument("the evidence model", NAMES, format!("'{text}'")))
    }

    /// The kind of a stored number.
    pub(super) fn of_number(number: u32) -> Option<Self> {
        Self::ALL.iter().find(|k| **k as u32 == number).copied()
    }
}
