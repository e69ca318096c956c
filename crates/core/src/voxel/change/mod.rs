//! What changed between two epochs, or between model and epoch. Read in this order:
//!
//! * [`class`]: what became of a voxel;
//! * [`classes`]: the classes of a block's voxels;
//! * [`settings`]: how two epochs are compared;
//! * [`judge`]: the class of every voxel of a block;
//! * [`value`]: the change of a tile as a value ([`VoxelChange`]);
//! * [`bytes`]: its stored form;
//! * [`tally`]: voxels of each class, counted ([`ChangeTally`]);
//! * [`component`]: what is new or gone, as connected things ([`ChangeComponent`]).

mod bytes;
mod class;
mod classes;
mod component;
mod judge;
mod settings;
mod tally;
mod value;

pub use class::ChangeClass;
pub use component::ChangeComponent;
pub use settings::ChangeSettings;
pub use tally::ChangeTally;
pub use value::VoxelChange;
