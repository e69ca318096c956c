//! Arguments of variable length: fetched, decompressed and read only as far as they are asked.

use std::marker::PhantomData;

use asbuilt_core::Result;
use asbuilt_core::geometry::Solid;
use asbuilt_core::scan::Patch;
use asbuilt_core::verify::{Evidence, EvidenceModel};
use asbuilt_core::voxel::{Grid, Occupancy, VoxelChange};

use super::{Args, FromArg, SqlValue};

/// What is stored at variable length, and its SQL type. Implemented here alone: an argument's bytes are read on its
/// word.
pub trait VarlenaType {
    /// The type's name.
    const SQL_TYPE: &'static str;
}

macro_rules! varlena_types {
    ($($type:ty, $sql_type:literal;)*) => {
        $(impl VarlenaType for $type { const SQL_TYPE: &'static str = $sql_type; })*
    };
}

/// `bytea`.
#[derive(Debug)]
pub enum Bytea {}

/// A tile of voxels, whichever: both begin with the same header.
#[derive(Debug)]
pub enum AnyTile {}

/// Any type that is compared by its bytes.
#[derive(Debug)]
pub enum Compared {}

varlena_types! {
    Solid, "ab_solid";
    Patch, "ab_scan";
    Evidence, "ab_evidence";
    EvidenceModel, "ab_evidence_model";
    Grid, "ab_grid";
    Occupancy, "ab_occupancy";
    VoxelChange, "ab_change";
    Bytea, "bytea";
    AnyTile, "ab_occupancy|ab_change";
    Compared, "ab_solid|ab_scan|ab_evidence|ab_occupancy|ab_change|ab_evidence_model|ab_grid";
}

/// A stored value of `T`, unread.
#[derive(Debug)]
pub struct Varlena<'a, T> {
    args: &'a Args,
    i: usize,
    of: PhantomData<T>,
}

impl<'a, T: VarlenaType> FromArg<'a> for Varlena<'a, T> {
    const SQL_TYPE: &'static str = T::SQL_TYPE;

    fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
        Ok(Self { args, i, of: PhantomData })
    }
}

impl<'a, T> Varlena<'a, T> {
    /// All bytes, fetched and decompressed if need be.
    pub fn bytes(&self) -> &'a [u8] {
        self.args.bytes(self.i)
    }

    /// At least the first `len` bytes (or all there are), without fetching the rest where that can be avoided.
    pub fn prefix(&self, len: usize) -> &'a [u8] {
        self.args.prefix(self.i, len)
    }

    /// The value as it is stored in the row, unfetched: equal bytes mean the same value.
    pub fn raw(&self) -> &'a [u8] {
        self.args.raw(self.i)
    }

    /// A copy to hand on: to send, or to return an argument as it came.
    pub fn copied(&self) -> SqlValue {
        self.args.copied(self.i)
    }
}
