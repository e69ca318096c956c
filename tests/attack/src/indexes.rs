//! Every operator class: an index over the pool, asked with every operator; it answers as the table does. ANALYZE,
//! and what the planner makes of its statistics.

use rand_chacha::ChaCha8Rng;

use crate::catalogue::{Catalogue, OpClass};
use crate::report::Kind;
use crate::session::Session;
use crate::values::Pool;

const BY_INDEX: &str = "SET enable_seqscan = off; SET enable_indexscan = on; SET enable_bitmapscan = on";
const BY_TABLE: &str =
    "SET enable_seqscan = on; SET enable_indexscan = off; SET enable_bitmapscan = off; SET enable_indexonlyscan = off";

pub fn run(s: &mut Session, catalogue: &Catalogue, pool: &Pool, rng: &mut ChaCha8Rng, queries: u32) {
    for c in &catalogue.opclasses {
        let Some(t) = catalogue.types.iter().find(|t| t.name == c.ty) else { continue };
        if !build(s, c, &t.plain) {
            continue;
        }
        for (operator, right, orders) in &c.operators {
            for _ in 0..queries {
                ask(s, pool, rng, c, operator, right, *orders);
            }
        }
        for (left, operator, right) in catalogue.operators.iter().filter(|o| o.0 == c.ty || o.2 == c.ty) {
            estimate(s, pool, rng, left, operator, right);
        }
    }
}

fn build(s: &mut Session, c: &OpClass, plain: &str) -> bool {
    let key = format!("index {}", c.name);
    // Rows before and after the index is there: build and insertion; then what deletion leaves behind.
    // A page of a B-tree holds no larger ones.
    let fits = if c.method == "btree" { "pg_column_size(v) < 2000" } else { "true" };
    let sql = [
        "DROP TABLE IF EXISTS attack.indexed".to_string(),
        format!(
            "CREATE TABLE attack.indexed AS SELECT id, v FROM attack.v_{plain}, generate_series(1, 25) WHERE {fits}"
        ),
        format!("CREATE INDEX ON attack.indexed USING {} (v {})", c.method, c.name),
        format!("INSERT INTO attack.indexed SELECT id, v FROM attack.v_{plain}, generate_series(1, 10) WHERE {fits}"),
        "DELETE FROM attack.indexed WHERE id % 3 = 0".into(),
        "VACUUM attack.indexed".into(),
        "ANALYZE attack.indexed".into(),
        format!("ANALYZE attack.v_{plain}"),
    ];
    sql.iter().all(|statement| {
        let done = s.execute(&key, statement);
        if let Err(fault) = &done {
            println!("attack: {key}: {statement}: {fault:?}");
        }
        done.is_ok()
    })
}

fn ask(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, c: &OpClass, operator: &str, right: &str, orders: bool) {
    let key = format!("{} by {} {operator} {right}", c.ty, c.method);
    let value = pool.literal(rng, right, &[]);
    if orders {
        let _ = s.execute(&key, BY_INDEX);
        let _ = s.query(&key, &format!("SELECT id FROM attack.indexed ORDER BY v {operator} {value} LIMIT 7"), &[]);
        return;
    }
    let sql = format!(
        "SELECT count(*) || ' rows, ids ' || coalesce(sum(id), 0) FROM attack.indexed WHERE v {operator} {value}"
    );
    let _ = s.execute(&key, BY_INDEX);
    let by_index = s.text(&key, &sql);
    let _ = s.execute(&key, BY_TABLE);
    let by_table = s.text(&key, &sql);
    let _ = s.execute(&key, "RESET ALL");
    if let (Ok(i), Ok(t)) = (&by_index, &by_table)
        && i != t
    {
        s.report.finding(Kind::Wrong, &key, &sql, &format!("the index finds {i:?}, the table {t:?}"));
    }
}

/// Selectivity of the operator with a constant and between columns.
fn estimate(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, left: &str, operator: &str, right: &str) {
    let key = format!("estimate {left} {operator} {right}");
    let value = pool.literal(rng, right, &[]);
    for sql in [
        format!("EXPLAIN SELECT FROM attack.v_{left} WHERE v {operator} {value}"),
        format!("EXPLAIN SELECT FROM attack.v_{left} a JOIN attack.v_{right} b ON a.v {operator} b.v"),
        format!("SELECT count(*) FROM attack.v_{left} a JOIN attack.v_{right} b ON a.v {operator} b.v"),
    ] {
        let _ = s.text(&key, &sql);
    }
}
