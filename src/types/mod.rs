//! One SQL type per file: input, output, receive, send, constructors, accessors.

mod aabb;
mod accuracy;
mod belief;
mod change;
pub mod evidence;
mod evidence_model;
mod grid;
mod hex;
mod loa;
mod mass;
mod memory;
mod occupancy;
mod order;
pub mod overlap;
mod patch;
pub mod planes;
mod relation;
mod rollup;
mod samples;
mod scan;
mod sensor;
mod solid;
mod summary;
pub mod uncertain;
mod verify_table;
mod voxelize;

pub use aabb::{BOX_LEN, box_bytes, box_from};
pub use evidence_model::{Given, model_arg};
pub use grid::grid_arg;
pub use mass::{mass_arg, mass_bytes, mass_ret};
pub use patch::beams;
pub use summary::{shift_arg, summary_arg, summary_fields};
