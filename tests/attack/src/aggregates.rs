//! Every aggregate: plain, FILTER, DISTINCT, ordered, as a window, in groups, on parallel workers.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::catalogue::{Catalogue, Function};
use crate::session::Session;
use crate::values::Pool;

/// Every plan that can be parallel is.
pub const PARALLEL: &str = "SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0; SET min_parallel_table_scan_size = 0; \
    SET max_parallel_workers_per_gather = 2; SET parallel_leader_participation = off; DO $$ BEGIN \
    EXECUTE 'SET ' || (SELECT name FROM pg_settings WHERE name IN ('force_parallel_mode', 'debug_parallel_query')) || ' = on'; END $$";

pub fn run(s: &mut Session, catalogue: &Catalogue, pool: &Pool, rng: &mut ChaCha8Rng, rounds: u32) {
    for _ in 0..rounds {
        for f in catalogue.functions.iter().filter(|f| f.aggregate) {
            plain(s, pool, rng, f);
        }
    }
}

/// Parallel workers: partial states go through serialisation to the leader.
pub fn run_parallel(s: &mut Session, catalogue: &Catalogue, pool: &Pool, rng: &mut ChaCha8Rng, rounds: u32) {
    for t in &catalogue.types {
        let sql = format!(
            "DROP TABLE IF EXISTS attack.b_{0}; CREATE TABLE attack.b_{0} AS SELECT id, v FROM attack.v_{0}, generate_series(1, 20); \
             ALTER TABLE attack.b_{0} SET (parallel_workers = 2)",
            t.plain
        );
        let _ = s.execute("parallel tables", &sql);
    }
    s.set_up(PARALLEL);
    for _ in 0..rounds {
        for f in &catalogue.functions {
            parallel(s, pool, rng, f);
        }
    }
    s.set_up("");
}

fn plain(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) {
    let rows = rows(pool, rng, f);
    let columns: Vec<String> = (0..f.arguments.len()).map(|i| format!("c{i}")).collect();
    let c = columns.join(", ");
    let name = &f.name;
    let from = format!("FROM ({rows}) t(g, {c})");
    let (how, sql) = match rng.random_range(0..9) {
        0 => ("plain", format!("SELECT {name}({c}) {from}")),
        1 => ("filtered", format!("SELECT {name}({c}) FILTER (WHERE g % 2 = 0) {from}")),
        2 => ("distinct", format!("SELECT {name}(DISTINCT {c}) {from}")),
        3 => ("ordered", format!("SELECT {name}({c} ORDER BY g DESC) {from}")),
        4 => (
            "as a window",
            format!("SELECT {name}({c}) OVER (ORDER BY g ROWS BETWEEN 1 PRECEDING AND CURRENT ROW) {from}"),
        ),
        5 => ("as a growing window", format!("SELECT {name}({c}) OVER (ORDER BY g) {from}")),
        6 => ("in groups", format!("SELECT {name}({c}) {from} GROUP BY g % 2")),
        7 => ("in grouping sets", format!("SELECT {name}({c}) {from} GROUP BY GROUPING SETS ((g), ())")),
        _ => ("in an array", format!("SELECT ARRAY[{name}({c})], ROW({name}({c})) {from}")),
    };
    let _ = s.query(&format!("{} {how}", f.signature), &sql, &[]);
}

/// A VALUES list; most columns are one value throughout, for many aggregates refuse a mixture at once.
fn rows(pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) -> String {
    let constant: Vec<bool> = f.arguments.iter().map(|_| rng.random_bool(0.6)).collect();
    let first: Vec<String> = f.arguments.iter().map(|a| pool.literal(rng, a, &f.words)).collect();
    let n = rng.random_range(1..8);
    let mut lines = vec![];
    for g in 0..n {
        let line: Vec<String> = (0..first.len())
            .map(|i| if constant[i] { first[i].clone() } else { pool.literal(rng, &f.arguments[i], &f.words) })
            .collect();
        lines.push(format!("({g}, {})", line.join(", ")));
    }
    let none = if rng.random_bool(0.05) { " LIMIT 0" } else { "" };
    format!("VALUES {}{none}", lines.join(", "))
}

fn parallel(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) {
    let Some(at) = f.arguments.iter().position(|a| a.starts_with("ab_") && !a.ends_with("[]")) else { return };
    if f.arguments.iter().any(|a| a == "internal" || a == "cstring") {
        return;
    }
    let arguments: Vec<String> = f
        .arguments
        .iter()
        .enumerate()
        .map(|(i, a)| if i == at { "v".into() } else { pool.literal(rng, a, &f.words) })
        .collect();
    let call = format!("{}({})", f.name, arguments.join(", "));
    // One stored value throughout, or all of them.
    let only = if rng.random_bool(0.7) { format!("WHERE id = {}", rng.random_range(1..5)) } else { String::new() };
    let table = format!("attack.b_{}", f.arguments[at]);
    let sql = if f.aggregate {
        format!("SELECT {call} FROM {table} {only}")
    } else {
        format!("SELECT count(x) FROM (SELECT {call} AS x FROM {table} {only} LIMIT 300) y")
    };
    let _ = s.query(&format!("{} in parallel", f.signature), &sql, &[]);
}
