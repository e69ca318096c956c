//! One SQL type per file: input, output, receive, send, constructors, accessors.

use crate::pg::Declared;

mod aabb;
mod accuracy;
mod belief;
mod change;
mod change_table;
mod evidence;
mod evidence_model;
mod grid;
mod hex;
mod loa;
mod mass;
mod memory;
mod occupancy;
mod order;
pub mod overlap;
mod parts;
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
pub use evidence::EvidenceArg;
pub use evidence_model::{GivenParameters, ModelArg, model_or_default};
pub use grid::GridArg;
pub use mass::{mass_bytes, mass_ret};
pub use occupancy::OccupancyArg;
pub use patch::beams;
pub use scan::ScanArg;
pub use solid::SolidArg;
pub use summary::{summary, summary_fields};

/// What SQL is to declare, file by file.
pub const DECLARED: &[&[Declared]] = &[
    aabb::DECLARED,
    accuracy::DECLARED,
    belief::DECLARED,
    change::DECLARED,
    change_table::DECLARED,
    evidence::DECLARED,
    evidence_model::DECLARED,
    grid::DECLARED,
    loa::DECLARED,
    mass::DECLARED,
    memory::DECLARED,
    occupancy::DECLARED,
    order::DECLARED,
    overlap::DECLARED,
    parts::DECLARED,
    patch::DECLARED,
    relation::DECLARED,
    samples::DECLARED,
    scan::DECLARED,
    sensor::DECLARED,
    solid::DECLARED,
    summary::DECLARED,
    verify_table::DECLARED,
    voxelize::DECLARED,
    uncertain::compare::DECLARED,
    uncertain::construct::DECLARED,
    uncertain::io::DECLARED,
    uncertain::line::DECLARED,
    uncertain::plane::DECLARED,
    uncertain::point::DECLARED,
    uncertain::pose::DECLARED,
    uncertain::relations::DECLARED,
];
