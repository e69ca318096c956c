//! What the user calls, one file each.

pub mod change;
pub mod explain;
pub mod forecast;
pub mod inspect;
pub mod list;
pub mod load;
pub mod mesh_ifc;
pub mod read_scan;
pub mod reading;
pub mod remove;
pub mod simulate;
pub mod verify;
