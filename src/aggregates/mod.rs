//! Aggregates: transition, combine, serialise, final.

mod evidence;
mod points;
mod pool;
mod scan;
