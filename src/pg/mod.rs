//! The only place with `unsafe`: PostgreSQL's calling convention, memory, arrays, rows, queries, interrupts, threads,
//! the allocator, the planner's questions.
//!
//! Everything outside sees safe types: [`Args`] to read arguments, [`SqlValue`] to return, [`Rows`] to return many.

mod aggregate;
mod allocator;
mod analyze;
mod args;
mod array;
mod context;
mod function;
mod gist;
mod interrupt;
mod load;
mod memory;
mod query;
mod rows;
mod scratch;
mod selectivity;
mod sort;
mod sql_value;
mod toast;
mod type_name;
mod worker_pool;

pub use aggregate::{AggState, aggregate_state, deserialised_state};
pub use analyze::{Statistics, analysed_by};
pub use args::Args;
pub use function::run;
pub(crate) use function::sql_functions;
pub use gist::{KeyVector, PickSplit};
pub use load::{capture_no_backtraces, reserve_settings};
pub use memory::{Account, Backend, memory_in_use};
pub use query::{Cell, Column, Query, for_each_batch};
pub use rows::{Field, Rows};
pub use selectivity::{Known, Other, Restriction, join, restriction};
pub use sort::{Place, sorted_by};
pub use sql_value::SqlValue;
pub use type_name::own_type_name;
pub use worker_pool::WorkerPool;
