//! Text as the field writes it: [`lines`] in any encoding, [`dialect`]s of numbers, [`columns`] and what they hold.

pub mod columns;
pub mod dialect;
pub mod lines;
mod number;

pub use columns::{Column, Columns};
pub use dialect::{Dialect, numbers};
pub use lines::Lines;
