//! asbuilt: is the building what the model says?
//!
//! A thin SQL surface over `asbuilt-core`:
//!
//! * [`types`]: one SQL type per file, its input and output, constructors and accessors;
//! * [`aggregates`]: transition, combine, serialise, final;
//! * [`planner`]: statistics and selectivity;
//! * [`gist`]: index support; the algorithms on boxes are core's;
//! * [`settings`]: what `SET` and `SHOW` know;
//! * [`compat`]: what the SQL of 0.1.0 calls and today's does not;
//! * [`declared`]: what they all expect SQL to declare;
//! * [`error`]: the one map from core's errors to SQLSTATE and hint;
//! * [`pg`]: the only place that touches PostgreSQL's memory.
//!
//! The SQL objects themselves are declared by hand in `sql/install`, a file a topic, in the order below. Names that
//! begin with `_ab_` are for PostgreSQL, not for people.

mod aggregates;
mod compat;
mod declared;
mod error;
mod gist;
mod pg;
mod planner;
mod settings;
mod types;

pgrx::pg_module_magic!(name, version);

/// Called by PostgreSQL when the library is loaded.
#[pgrx::pg_guard]
pub extern "C-unwind" fn _PG_init() {
    pg::capture_no_backtraces();
    settings::declare();
}

pgrx::extension_sql_file!("../sql/install/00-types.sql", name = "types", bootstrap);
pgrx::extension_sql_file!("../sql/install/01-solid.sql", name = "solid", requires = ["types"]);
pgrx::extension_sql_file!("../sql/install/02-scan.sql", name = "scan", requires = ["solid"]);
pgrx::extension_sql_file!("../sql/install/03-uncertain.sql", name = "uncertain", requires = ["scan"]);
pgrx::extension_sql_file!("../sql/install/04-belief.sql", name = "belief", requires = ["uncertain"]);
pgrx::extension_sql_file!("../sql/install/05-evidence.sql", name = "evidence", requires = ["belief"]);
pgrx::extension_sql_file!("../sql/install/06-voxel.sql", name = "voxel", requires = ["evidence"]);
pgrx::extension_sql_file!("../sql/install/10-operators.sql", name = "operators", requires = ["voxel"]);
pgrx::extension_sql_file!("../sql/install/11-opclass_gist.sql", name = "opclass_gist", requires = ["operators"]);
pgrx::extension_sql_file!("../sql/install/12-opclass_btree.sql", name = "opclass_btree", requires = ["opclass_gist"]);
pgrx::extension_sql_file!("../sql/install/13-opclass_hash.sql", name = "opclass_hash", requires = ["opclass_btree"]);
pgrx::extension_sql_file!("../sql/install/20-casts.sql", name = "casts", requires = ["opclass_hash"]);
pgrx::extension_sql_file!("../sql/install/30-planner.sql", name = "planner", requires = ["casts"]);
pgrx::extension_sql_file!("../sql/install/40-exchange.sql", name = "exchange", requires = ["planner"]);
pgrx::extension_sql_file!("../sql/install/50-session.sql", name = "session", requires = ["exchange"]);
pgrx::extension_sql_file!("../sql/install/99-compat.sql", name = "compat", requires = ["session"], finalize);
