//! A second look at what stayed unobserved, or was not found where it is drawn.
//!
//! Evidence holds what beams told, not what kept others away. A `SightMap` a station remembers coarsely where its beams
//! ended, and on whose drawn surface. [`Sights`] are those of a survey; with them a second look finds for each sample
//! [`Why`](super::Why) it was not seen, and a face that stands farther off than beams are added up
//! ([`FoundFace`](super::FoundFace)).

mod far_face;
mod horizon;
mod second_look;
mod sight_map;
mod sphere_grid;
mod survey;

pub(super) use second_look::{Looked, Owner};
pub use survey::Sights;
