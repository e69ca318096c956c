//! What the user calls, one file each.

pub mod change;
pub mod forecast;
pub mod inspect;
pub mod load;
pub mod mesh_ifc;
pub mod read_scan;
pub mod reading;
pub mod simulate;
pub mod verify;
