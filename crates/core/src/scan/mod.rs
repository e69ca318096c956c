//! Beams of one scanner position, cut into angular tiles and packed.
//!
//! All beams of a terrestrial scan start at one point, so a tile of neighbouring directions is a narrow [`Cone`]. A
//! [`Patch`] stores one tile: a [`Header`] that answers where it looks and how far, and a bit-packed payload. A
//! [`View`] is the decoded tile as a small range image, in which "which beams pass near this point" is a question of
//! two angles. Two other kinds are the same type on slower paths: beams of a moving platform, each with an origin of
//! its own, and points whose origin is unknown ([`Origins`]).

mod angular_grid;
mod bitpack;
mod cluster;
mod cone;
mod content;
mod edit;
mod encode;
mod gather;
mod header;
mod patch;
mod planes;
mod platform;
mod tile;
mod view;

pub(crate) use angular_grid::AngularGrid;
pub use cone::Cone;
pub use content::{Beam, Content};
pub use encode::{Setting, check_count};
pub use gather::{Gathered, Return};
pub use header::{Header, JOIN_MARGIN_M, NO_RETURN_REACH_M, Origins};
pub use patch::Patch;
pub use platform::by_origin;
pub use tile::MAX_BEAMS;
pub use view::View;
