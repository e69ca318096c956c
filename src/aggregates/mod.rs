//! Aggregates: transition, combine, serialise, final.

mod evidence;
