//! Text files from the field: [`lines`] in any encoding, [`dialect`]s of numbers, [`columns`] and what they contain.

pub mod columns;
pub mod dialect;
pub mod doubt;
pub mod head;
pub mod lines;
mod number;
pub mod title;

pub use columns::{ColumnRole, Columns};
pub use dialect::{Dialect, numbers};
pub use head::Head;
pub use lines::Lines;
