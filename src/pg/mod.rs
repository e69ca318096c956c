//! The only place with `unsafe`: PostgreSQL's calling convention, memory, arrays, rows, queries, interrupts, threads,
//! the allocator, the planner's questions.
//!
//! Everything outside sees safe types: [`Args`] to read arguments, [`SqlValue`] to return, [`Rows`] to return many.

mod aggregate;
mod allocator;
mod analyze;
mod args;
mod array;
mod array_arg;
mod context;
mod declared;
mod encoding;
mod from_arg;
mod function;
mod gist;
mod interrupt;
mod load;
mod memory;
mod plain;
mod query;
mod rows;
mod scratch;
mod selectivity;
mod sort;
mod sql_value;
mod toast;
mod type_name;
mod varlena;
mod worker_pool;

pub use aggregate::{AggState, StateOrNew, deserialised_state, state_or_new};
pub use analyze::{Statistics, analysed_by};
pub use args::Args;
pub use array_arg::{BoolArray, F64Array, I32Array, ScanArray, TextArray};
pub use declared::{Declared, Parameter, lacks, next_arg};
pub use from_arg::{FromArg, Internal, Message, Oid, TextInput, own_value};
pub use function::run;
pub(crate) use function::{bound, parameters, sql_functions};
pub use gist::{Answer, Entry, GistQuery, KeyVector, PickSplit};
pub use load::{capture_no_backtraces, reserve_settings};
pub use memory::{Account, Backend, memory_in_use};
pub use plain::{FixedModel, Numbers};
pub use query::{Query, ResultCell, ResultColumn, for_each_batch};
pub use rows::{RowField, Rows};
pub use selectivity::{ColumnStatistics, Other, Restriction, join, restriction};
pub use sort::{SortKey, sorted_by};
pub use sql_value::SqlValue;
pub use type_name::own_type_name;
pub use varlena::{AnyTile, Bytea, Compared, Varlena};
pub use worker_pool::WorkerPool;
