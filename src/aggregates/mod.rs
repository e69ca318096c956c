//! Aggregates: transition, combine, serialise, final.

mod evidence;
mod occupancy;
mod points;
mod pool;
mod scan;
