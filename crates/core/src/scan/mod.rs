//! Beams of one scanner position, cut into angular tiles and packed.
//!
//! All beams of a terrestrial scan start at one point, so a tile of neighbouring directions is a narrow
//! [`Cone`]. A [`Patch`] stores one tile: a [`Header`] that answers where it looks and how far, and a bit-packed
//! payload. A [`View`] is the decoded tile as a small range image, in which "which beams pass near this point"
//! is a question of two angles.

mod bitpack;
mod cone;
mod edit;
mod header;
mod patch;
mod tile;
mod view;

pub use cone::Cone;
pub use header::{Header, JOIN_MARGIN_M, NO_RETURN_REACH_M};
pub use patch::{Beam, Patch};
pub use tile::{MAX_BEAMS, mean_step, tiles};
pub use view::View;
