//! `ab_point`, `ab_line`, `ab_plane`, `ab_pose`: plain float8 numbers, native byte order on disk, network order on the wire.

pub(super) mod compare;
pub(super) mod construct;
pub(super) mod io;
pub(super) mod line;
pub(super) mod plane;
pub(super) mod point;
pub(super) mod pose;
pub(super) mod relations;

pub use io::ret;
