//! `ab_point`, `ab_line`, `ab_plane`, `ab_pose`: plain float8 numbers, native byte order on disk, network order on the wire.

mod compare;
mod construct;
mod io;
mod line;
mod plane;
mod point;
mod pose;
mod relations;

pub use io::{ret, value};
