//! What a caller can get wrong: one variant for each cause, with the value at fault. The way out depends on where the
//! core is used, and is told there.

/// Result with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every error of the crate. `Display` names the value at fault.
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
    /// A triangle names a part that does not exist.
    #[error("triangle {triangle} belongs to part {part}, but the solid has {parts} parts")]
    PartNumber {
        /// Position of the triangle, from 0.
        triangle: usize,
        /// The number at fault.
        part: i64,
        /// Number of parts.
        parts: usize,
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
        what: Limited,
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
    #[error("the evidence values do not belong together: {0}")]
    Mismatch(Mismatch),
    /// Voxels of different lattices, or gathered by different rules.
    #[error("the grids do not belong together: {0}")]
    Lattice(LatticeMismatch),
    /// More memory than a setting allows.
    #[error("{what} would take {} MB; the most is {} MB", needed.div_ceil(1 << 20), limit >> 20)]
    Memory {
        /// Whose memory.
        what: MemoryOf,
        /// Bytes that there would be.
        needed: usize,
        /// Bytes that there may be.
        limit: usize,
        /// Whether the limit is the one on everything together.
        at_ceiling: bool,
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

/// What is too large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Limited {
    /// The bytes of one value.
    #[error("the stored form of a value")]
    StoredForm,
    /// The characters of one value.
    #[error("the text form")]
    TextForm,
    /// The bytes of a text that a caller gave.
    #[error("an argument of type text")]
    TextArgument,
    /// Vertices or triangles of a solid.
    #[error("the number of vertices or triangles")]
    Triangles,
    /// Parts of a solid.
    #[error("the number of parts")]
    Parts,
    /// What a part is called.
    #[error("the length of a part's name")]
    PartName,
    /// Beams of one patch.
    #[error("the number of beams of a patch")]
    PatchBeams,
    /// The angle that the beams of one patch fill.
    #[error("the half-angle of the patch's cone")]
    ConeAngle,
    /// Distance of a return from its patch's origin.
    #[error("the offset of a point from its origin")]
    Offset,
    /// Beams of patches that are joined.
    #[error("the number of beams of a union")]
    UnionBeams,
    /// Returns that are packed together.
    #[error("the number of returns of one group")]
    GroupReturns,
    /// Points that one plane or line is fitted to.
    #[error("the number of points of one fit")]
    FitPoints,
    /// Samples times stations.
    #[error("the evidence about one solid")]
    Evidence,
    /// Distance from the lattice's origin.
    #[error("a coordinate in voxels")]
    VoxelIndex,
    /// Voxels of a slice.
    #[error("the slice")]
    Slice,
    /// Tiles that an area is cut into.
    #[error("the number of tiles")]
    Tiles,
}

/// Why evidence values cannot be added up.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Mismatch {
    /// Their samples lie on different solids.
    #[error("they are about different solids")]
    Solids,
    /// Their parameters differ: names and values of both.
    #[error("they were made with {0}")]
    Models(String),
    /// Their samples lie in different places of the same solid.
    #[error("their samples differ")]
    Samples,
    /// Rows that are aggregated together name several solids.
    #[error("the group holds more than one solid")]
    GroupOfSolids,
    /// Rows that are aggregated together name several models.
    #[error("the group holds more than one evidence model")]
    GroupOfModels,
    /// Evidence that is merged takes no more patches.
    #[error("patches after a merge")]
    PatchesAfterMerge,
}

/// Why grids of voxels do not belong together.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LatticeMismatch {
    /// Their voxels differ in size, metres.
    #[error("voxels of {0} m and of {1} m")]
    VoxelSize(f64, f64),
    /// They were gathered by different rules; both in words.
    #[error("{0} and {1}")]
    Rules(String, String),
    /// Rows that are aggregated together name several grids; both as text.
    #[error("the group has {0} and {1}")]
    GroupOfGrids(String, String),
    /// Changes that were compared differently.
    #[error("they were compared with different settings")]
    ChangeSettings,
    /// Changes of tiles that overlap.
    #[error("their tiles share voxels")]
    SharedVoxels,
    /// The tile's border lies within voxels of this size, metres.
    #[error("the tile {tile} cuts voxels of {voxel} m")]
    CutVoxels {
        /// The tile's box as text.
        tile: String,
        /// The voxels' size, metres.
        voxel: f64,
    },
    /// One was drawn, the other seen.
    #[error("one is a drawn model, the other what beams saw")]
    DrawnAndSeen,
    /// Tiles of a drawn model that do not touch; both boxes as text.
    #[error("the tiles of a drawn model, {0} and {1}, leave a gap")]
    TilesApart(String, String),
}

/// Whose memory is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MemoryOf {
    /// Voxels.
    #[error("the memory of voxel grids")]
    Grids,
    /// Samples and their sums.
    #[error("the memory of evidence")]
    Evidence,
    /// All together.
    #[error("the memory of asbuilt in this session")]
    Session,
}
