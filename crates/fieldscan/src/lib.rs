//! A terrestrial laser scanner from the physics of its measurement. It shares no code with `asbuilt-simulate`, whose
//! scanner the verifier was developed with, so that what both have wrong in common is seen.
//!
//! * [`triangle`], [`tree`]: surfaces, and what a ray meets first of them;
//! * [`material`]: how a surface answers light;
//! * [`world`]: what stands there for good, and what only stood there while one station measured;
//! * [`optics`]: the way of one ray through panes and over mirrors, and the echoes of it;
//! * [`receiver`]: from the echoes of a footprint to one range, or none;
//! * [`station`]: where a scanner stands and where registration believes it;
//! * [`scanner`]: all beams of a station;
//! * [`delivery`]: what of it reaches the office.
//!
//! Lengths are metres, angles radians; positions are in the world's frame unless a name says otherwise.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod delivery;
pub mod material;
pub mod optics;
pub mod receiver;
pub mod scanner;
pub mod station;
pub mod tree;
pub mod triangle;
pub mod world;

pub use material::{Material, Optics};
pub use receiver::Receiver;
pub use scanner::{Scan, Scanner, Shot};
pub use station::Station;
pub use tree::{Hit, Tree};
pub use triangle::Triangle;
pub use world::{Puddle, Surface, View, World};
