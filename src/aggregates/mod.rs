//! Aggregates: transition, combine, serialise, final.

pub mod evidence;
mod occupancy;
mod points;
mod pool;
mod scan;
