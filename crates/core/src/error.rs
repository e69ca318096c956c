//! What a caller can get wrong, with the value at fault and the way out.

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every error of the crate. `Display` names the value; [`Error::hint`] names the way out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// An argument outside its range.
    #[error("{what} must be {expected}, not {value}")]
    Argument {
        /// The argument's name.
        what: &'static str,
        /// What it may be.
        expected: &'static str,
        /// What it was.
        value: String,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} refers to vertex {index}, but the solid has {vertices} vertices")]
    TriangleIndex {
        /// Position of the triangle, from 0.
        triangle: usize,
        /// The index at fault.
        index: i64,
        /// Number of vertices.
        vertices: usize,
    },
    /// Something that needs at least one element got none.
    #[error("{what} is empty")]
    Empty {
        /// What is empty.
        what: &'static str,
    },
    /// Volume and the like are undefined on a surface that bounds nothing.
    #[error("the surface is open: it bounds no volume")]
    OpenSurface,
    /// Text that is not a value of the type.
    #[error("invalid input syntax for type {ty}: \"{text}\"")]
    Syntax {
        /// SQL name of the type.
        ty: &'static str,
        /// The text, shortened.
        text: String,
    },
    /// Bytes from outside that are not a value of the type.
    #[error("invalid binary value for type {ty}: {reason}")]
    Binary {
        /// SQL name of the type.
        ty: &'static str,
        /// What is wrong with them.
        reason: String,
    },
    /// Stored bytes that were valid once and are not now.
    #[error("{ty} is damaged: {reason}")]
    Corrupted {
        /// SQL name of the type.
        ty: &'static str,
        /// What is wrong with them.
        reason: String,
    },
    /// A value written by a newer release.
    #[error("{ty} has layout version {found}; this release reads up to version {known}")]
    Version {
        /// SQL name of the type.
        ty: &'static str,
        /// The version found.
        found: u8,
        /// The newest version known.
        known: u8,
    },
    /// A value with a part that a newer release wrote.
    #[error("{ty} holds section {tag:#x}, which this release does not know")]
    Section {
        /// SQL name of the type.
        ty: &'static str,
        /// The section's tag.
        tag: u32,
    },
    /// More than the layouts and algorithms allow.
    #[error("{what} is {value}; the most is {limit}")]
    Limit {
        /// What is too large.
        what: &'static str,
        /// How large it is.
        value: String,
        /// How large it may be.
        limit: String,
    },
    /// Two sources that exclude each other completely.
    #[error("the masses are in total conflict: one says occupied with certainty, the other empty")]
    TotalConflict,
    /// A matrix that is no covariance.
    #[error("{what} is {reason}")]
    Covariance {
        /// Whose covariance.
        what: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// Objects that do not determine what was asked of them.
    #[error("{what} is undetermined: {reason}")]
    Degenerate {
        /// What was asked.
        what: &'static str,
        /// Why the objects do not determine it.
        reason: String,
    },
    /// Evidence values that cannot be added up.
    #[error("the evidence values do not belong together: {reason}")]
    Mismatch {
        /// What differs.
        reason: String,
    },
    /// Voxels of different lattices, or gathered by different rules.
    #[error("the grids do not belong together: {reason}")]
    Lattice {
        /// What differs.
        reason: String,
    },
    /// More memory than a setting allows.
    #[error("{what} would take {} MB; the most is {} MB", needed.div_ceil(1 << 20), limit >> 20)]
    Memory {
        /// Whose memory.
        what: &'static str,
        /// Bytes that there would be.
        needed: usize,
        /// Bytes that there may be.
        limit: usize,
        /// What to change.
        hint: &'static str,
    },
    /// More memory than the system has to give.
    #[error("out of memory: the system has no {} MB more", bytes.div_ceil(1 << 20))]
    OutOfMemory {
        /// Bytes that were asked for.
        bytes: usize,
    },
    /// The caller asked to stop.
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    /// The way out, where there is one to name.
    pub fn hint(&self) -> Option<String> {
        Some(match self {
            Self::TriangleIndex { vertices, .. } => {
                format!("Vertex indices count from 0; the last one here is {}.", vertices.saturating_sub(1))
            }
            Self::OpenSurface => {
                "Ask ab_closedness(solid) first; area, box and verdicts work on open surfaces too.".into()
            }
            Self::Version { .. } | Self::Section { .. } => {
                "Install the newer release: ALTER EXTENSION asbuilt UPDATE.".into()
            }
            Self::Covariance { .. } => {
                "A covariance is symmetric and has no negative eigenvalue; repair it, or give sd for a diagonal one."
                    .into()
            }
            Self::TotalConflict => {
                "Discount the sources by their reliability (a mass below 1) before they are combined.".into()
            }
            Self::Mismatch { reason } if reason.contains("group") => {
                "GROUP BY the object, so that every group holds one solid and one model.".into()
            }
            Self::Mismatch { .. } => {
                "Roll up only evidence of the same solid, made with the same ab_evidence_model().".into()
            }
            Self::Lattice { reason } if reason.contains("share voxels") => {
                "Cut them first: ab_clip(change, tile).".into()
            }
            Self::Lattice { reason } if reason.contains("settings") => {
                "Compare all tiles with the same threshold and tolerance.".into()
            }
            Self::Lattice { reason } if reason.contains("cuts voxels") => {
                "Give the tile borders that are multiples of the larger voxel.".into()
            }
            Self::Lattice { reason } if reason.contains("drawn model") => {
                "Models add up to models and epochs to epochs; ab_change(model, epoch) compares them.".into()
            }
            Self::Lattice { .. } => {
                "Aggregate both with the same ab_grid(); ab_downsample(occupancy) doubles the voxels of the finer one."
                    .into()
            }
            Self::Limit { what, .. } if what.contains("offset") => {
                "Use a coarser quantum, or give coordinates nearer the scanner.".into()
            }
            Self::Memory { hint, .. } => (*hint).into(),
            Self::OutOfMemory { .. } => "Give it fewer rows at a time, or the server more memory.".into(),
            Self::Limit { what, .. } if what.contains("union") => {
                "Join fewer patches; ab_retile(patches) cuts many into tiles of neighbours.".into()
            }
            Self::Limit { what, .. } if what.contains("cone") || what.contains("beams") => {
                "Cut the beams into angular tiles first, as `asbuilt load` does.".into()
            }
            Self::Corrupted { .. } => "Restore the value from a backup or load the scan again.".into(),
            _ => return None,
        })
    }

    /// An [`Error::Argument`].
    pub fn argument(what: &'static str, expected: &'static str, value: impl ToString) -> Self {
        let value = value.to_string();
        // A number of three hundred digits is better told by its size.
        let value = match value.parse::<f64>() {
            Ok(x) if value.len() > 24 => format!("{x:e}"),
            _ => value,
        };
        Self::Argument { what, expected, value }
    }

    /// An [`Error::Syntax`] that quotes at most 80 characters.
    pub fn syntax(ty: &'static str, text: &str) -> Self {
        let mut short: String = text.chars().take(80).collect();
        if short.len() < text.len() {
            short.push_str("...");
        }
        Self::Syntax { ty, text: short }
    }

    /// An [`Error::Binary`].
    pub fn binary(ty: &'static str, reason: impl Into<String>) -> Self {
        Self::Binary { ty, reason: reason.into() }
    }

    /// An [`Error::Corrupted`].
    pub fn corrupted(ty: &'static str, reason: impl Into<String>) -> Self {
        Self::Corrupted { ty, reason: reason.into() }
    }
}
