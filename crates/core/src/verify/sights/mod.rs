//! A second look at what stayed unobserved.
//!
//! Evidence holds what beams told, not what kept others away. A `SightMap` a station remembers coarsely where its beams
//! ended, and on whose drawn surface. [`Sights`] are those of a survey; with them a second look finds for each sample
//! [`Why`](super::Why) it was not seen.

mod second_look;
mod sight_map;
mod survey;

pub(super) use second_look::{Looked, Owner};
pub use survey::Sights;
