//! Scenes with known truth and a scanner in them: what tests, benches, forecasts and the demo are made from.
//!
//! [`Changes`] says what was built differently from the drawing, [`Scene`] holds what then stands there, [`Scanner`]
//! scans it with its errors, and [`write_e57`] writes the scans as a scanner would.

mod bow;
mod changes;
mod scanner;
mod scene;
mod write;

pub use changes::{Added, Change, Changes, Drawn};
pub use scanner::{Scanner, Shot, SimulatedScan};
pub use scene::Scene;
pub use write::write_e57;
