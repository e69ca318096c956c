//! Aggregates: transition, combine, serialise, final.

use crate::pg::Declared;

pub mod evidence;
mod occupancy;
mod points;
mod pool;
mod scan;

/// What SQL is to declare, file by file.
pub const DECLARED: &[&[Declared]] =
    &[evidence::DECLARED, occupancy::DECLARED, points::DECLARED, pool::DECLARED, scan::DECLARED];
