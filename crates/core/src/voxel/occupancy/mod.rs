//! What is known of a tile of space, by beams or by a drawn model. Read in this order:
//!
//! * [`known`]: the blocks of a tile, of either kind;
//! * [`value`]: the tile as a value, gathered from patches and merged ([`Occupancy`]);
//! * [`bytes`]: its stored form;
//! * [`filter`]: cut to a box, made smoother or coarser;
//! * [`tally`]: voxels of each state, counted ([`StateTally`]);
//! * [`slice`]: a layer of voxels as a picture ([`Slice`]).

mod bytes;
mod filter;
mod known;
mod slice;
mod tally;
mod value;

pub use known::{KnownAround, KnownBlock};
pub use slice::Slice;
pub use tally::StateTally;
pub use value::Occupancy;
