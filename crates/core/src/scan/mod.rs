//! Beams of one scanner position, cut into angular tiles and packed.
//!
//! All beams of a terrestrial scan start at one point, so a tile of neighbouring directions is a narrow [`Cone`]. A
//! [`Patch`] stores one tile: a [`PatchHeader`] that answers where it looks and how far, and a bit-packed payload. A
//! [`RangeImage`] is the decoded tile as a small range image, in which "which beams pass near this point" is a question of
//! two angles. Two other kinds are the same type on slower paths: beams of a moving platform, each with an origin of
//! its own, and points whose origin is unknown ([`Origins`]).
//!
//! Read in this order:
//!
//! * [`beam`]: one laser beam;
//! * [`beams`]: many of them, with what else was measured of each;
//! * [`cone`]: the directions of a tile;
//! * [`origins`]: where the beams of a patch start;
//! * [`spacing`]: how far neighbouring ones are apart;
//! * [`patch_spec`]: what they have in common;
//! * [`header`]: what a patch tells without its payload;
//! * [`bitpack`]: columns of whole numbers, packed;
//! * [`planes`]: intensity and colour, packed;
//! * [`encode`]: from beams to header and payload;
//! * [`patch`]: the packed tile;
//! * [`halve`]: lists halved until their parts are patches;
//! * [`tile`]: cutting by direction;
//! * [`cluster`]: cutting by place;
//! * [`cut`]: either, and the patches that come of it;
//! * [`platform`]: patches of a moving platform as patches of one origin;
//! * [`angular_grid`]: directions sorted into cells;
//! * [`range_pyramid`]: how far the beams in a rectangle got;
//! * [`window`]: what of a triangle lies within an image;
//! * [`range_image`]: the decoded tile as a range image;
//! * [`patch_builder`]: patches from rows;
//! * [`edit`]: patches from patches.

mod angular_grid;
mod beam;
mod beams;
mod bitpack;
mod cluster;
mod cone;
mod cut;
mod edit;
mod encode;
mod halve;
mod header;
mod origins;
mod patch;
mod patch_builder;
mod patch_spec;
mod planes;
mod platform;
mod range_image;
mod range_pyramid;
mod spacing;
mod tile;
mod window;

pub(crate) use angular_grid::AngularGrid;
pub use beam::{Beam, MAX_BEAMS};
pub use beams::Beams;
pub use cone::Cone;
pub use encode::check_count;
pub use header::{JOIN_MARGIN_M, NO_RETURN_REACH_M, PatchHeader, Vicinity};
pub use origins::Origins;
pub use patch::Patch;
pub use patch_builder::{PatchBuilder, Return};
pub use patch_spec::PatchSpec;
pub use platform::by_origin;
pub use range_image::RangeImage;
pub use spacing::Spacing;
pub(crate) use window::Window;
