//! Where the beams of a patch would meet a solid.
//!
//! A solid is made ready once ([`Target`]). A patch is unpacked once ([`Unpacked`]); of every beam [`crossings`] tells
//! where it would cross the solid first, and [`foot`] to which place of the drawn surface a return belongs. Where many
//! objects are drawn, [`Claims`] remembers near which of them each beam met something. No parameter has a say here.

mod aimed_at;
mod claims;
mod crossing;
mod foot;
mod near_face;
mod nearest_part;
mod target;
mod triangle;
mod triangle_index;
mod unpacked;

pub(super) use aimed_at::AimedAt;
pub(super) use claims::{Claims, OtherObjects};
pub(super) use crossing::{BeamCrossing, Depth, crossings};
pub(super) use foot::{Foot, foot};
pub(super) use near_face::NearFace;
pub(super) use target::Target;
pub(super) use unpacked::{Aim, Unpacked, UnpackedBeams};
