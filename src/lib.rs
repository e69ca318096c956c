//! asbuilt: is the building what the model says?
//!
//! A thin SQL surface over `asbuilt-core`:
//!
//! * [`types`]: one SQL type per file, its input and output, constructors and accessors;
//! * [`aggregates`]: transition, combine, serialise, final;
//! * [`planner`]: statistics and selectivity;
//! * [`gist`]: index support; the algorithms on boxes are core's;
//! * [`settings`]: what `SET` and `SHOW` know;
//! * [`error`]: the one map from core's errors to SQLSTATE and hint;
//! * [`pg`]: the only place that touches PostgreSQL's memory.
//!
//! The SQL objects themselves are declared by hand in `sql/install`, in the order below.

mod aggregates;
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

pgrx::extension_sql_file!("../sql/install/01-types.sql", name = "types", bootstrap);
pgrx::extension_sql_file!("../sql/install/02-geometry.sql", name = "geometry", requires = ["types"]);
pgrx::extension_sql_file!("../sql/install/03-scan.sql", name = "scan", requires = ["geometry"]);
pgrx::extension_sql_file!("../sql/install/04-belief.sql", name = "belief", requires = ["scan"]);
pgrx::extension_sql_file!("../sql/install/05-evidence.sql", name = "evidence", requires = ["belief"]);
pgrx::extension_sql_file!("../sql/install/06-operators.sql", name = "operators", requires = ["evidence"]);
pgrx::extension_sql_file!("../sql/install/07-gist.sql", name = "gist", requires = ["operators"]);
pgrx::extension_sql_file!("../sql/install/08-uncertain.sql", name = "uncertain", requires = ["gist"]);
pgrx::extension_sql_file!("../sql/install/09-relations.sql", name = "relations", requires = ["uncertain"]);
pgrx::extension_sql_file!("../sql/install/10-belief-calculus.sql", name = "calculus", requires = ["relations"]);
pgrx::extension_sql_file!("../sql/install/11-uncertain-index.sql", name = "uncertain_index", requires = ["calculus"]);
pgrx::extension_sql_file!("../sql/install/12-patches.sql", name = "patches", requires = ["uncertain_index"]);
pgrx::extension_sql_file!("../sql/install/13-nearness.sql", name = "nearness", requires = ["patches"]);
pgrx::extension_sql_file!("../sql/install/14-exchange.sql", name = "exchange", requires = ["nearness"]);
pgrx::extension_sql_file!("../sql/install/15-voxels.sql", name = "voxels", requires = ["exchange"]);
pgrx::extension_sql_file!("../sql/install/16-voxel-index.sql", name = "voxel_index", requires = ["voxels"]);
pgrx::extension_sql_file!("../sql/install/17-order.sql", name = "order", requires = ["voxel_index"], finalize);
