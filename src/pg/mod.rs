//! The only place with `unsafe`: PostgreSQL's calling convention, memory, arrays, rows, interrupts.
//!
//! Everything outside sees safe types: [`Args`] to read arguments, [`Ret`] to return, [`Rows`] to return many.

mod aggregate;
mod args;
mod array;
mod function;
mod gist;
mod interrupt;
mod ret;
mod rows;
mod toast;

pub use aggregate::{AggState, aggregate_state, deserialised_state};
pub use args::Args;
pub use function::run;
pub(crate) use function::sql_functions;
pub use gist::{KeyVector, PickSplit};
pub use interrupt::interrupt;
pub use ret::Ret;
pub use rows::{Field, Rows};
