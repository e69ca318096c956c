//! Every function of the catalogue with values of the pool: as literals (which the planner folds), as binary
//! parameters, from tables, in FROM, inside arrays, from PL/pgSQL.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::catalogue::{Catalogue, Function};
use crate::report::Kind;
use crate::session::Session;
use crate::values::{Pool, quoted};

/// Rows are bounded: a function that gives billions is asked for the first of them.
const MAX_ROWS: u32 = 200;

pub fn run(s: &mut Session, catalogue: &Catalogue, pool: &Pool, rng: &mut ChaCha8Rng, rounds: u32) {
    sweep(s, catalogue, pool);
    for _ in 0..rounds {
        for f in catalogue.functions.iter().filter(|f| !f.aggregate) {
            if f.arguments.iter().any(|a| a == "internal") {
                internal(s, pool, rng, f);
            } else {
                call(s, pool, rng, f);
                folded(s, pool, rng, f);
            }
        }
        for o in &catalogue.operators {
            operator(s, pool, rng, o);
        }
    }
}

/// Functions of one argument get every value there is.
fn sweep(s: &mut Session, catalogue: &Catalogue, pool: &Pool) {
    for f in catalogue.functions.iter().filter(|f| !f.aggregate) {
        let [argument] = &f.arguments[..] else { continue };
        for v in pool.of(argument) {
            let sql = format!("SELECT {}({}::{argument}) LIMIT {MAX_ROWS}", f.name, quoted(&v.text));
            let _ = s.query(&format!("{} of every value", f.signature), &sql, &[]);
        }
    }
}

fn call(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) {
    let name = &f.name;
    let a = pool.literals(rng, f);
    let key = |how: &str| format!("{} {how}", f.signature);
    match rng.random_range(0..10) {
        0 => drop(s.text(&key("as text"), &format!("SELECT {name}({a}) LIMIT {MAX_ROWS}"))),
        1 => drop(s.query(&key("as binary"), &format!("SELECT {name}({a}) LIMIT {MAX_ROWS}"), &[])),
        2 => parameters(s, pool, rng, f, 0.0),
        3 => parameters(s, pool, rng, f, 0.5),
        4 => drop(s.query(&key("of stored values"), &stored(pool, rng, f), &[])),
        5 => {
            let rows = rng.random_range(0..3);
            drop(s.query(&key("in FROM"), &format!("SELECT x FROM {name}({a}) x LIMIT {rows}"), &[]));
        }
        6 => {
            let sql = format!("SELECT ARRAY[{name}({a})] LIMIT {MAX_ROWS}");
            drop(s.query(&key("in an array"), &sql, &[]));
        }
        7 => drop(s.query(&key("in a row"), &format!("SELECT ROW({name}({a}), 1) LIMIT {MAX_ROWS}"), &[])),
        8 => drop(s.execute(&key("from PL/pgSQL"), &plpgsql(pool, rng, f))),
        _ => {
            let sql = format!("SELECT x.v, x.v::text FROM (SELECT {name}({a}) AS v LIMIT 20) x");
            drop(s.query(&key("twice"), &sql, &[]));
        }
    }
}

/// The planner evaluates an IMMUTABLE function of constants itself, even for EXPLAIN.
fn folded(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) {
    if f.immutable {
        let sql = format!("EXPLAIN (VERBOSE) SELECT {}({})", f.name, pool.literals(rng, f));
        let _ = s.text(&format!("{} folded", f.signature), &sql);
    }
}

fn parameters(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function, damage: f64) {
    if f.arguments.iter().any(|a| a == "cstring") {
        return;
    }
    let slots: Vec<String> = f.arguments.iter().enumerate().map(|(i, a)| format!("${}::{a}", i + 1)).collect();
    let values: Vec<_> = f.arguments.iter().map(|a| pool.raw(rng, a, damage)).collect();
    let sql = format!("SELECT {}({}) LIMIT {MAX_ROWS}", f.name, slots.join(", "));
    let _ = s.query(&format!("{} with binary parameters", f.signature), &sql, &values);
}

/// Arguments of our types out of their tables: short headers, compressed, out of line.
fn stored(pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) -> String {
    let mut tables = vec![];
    let mut arguments = vec![];
    for (i, ty) in f.arguments.iter().enumerate() {
        match ty.strip_prefix("ab_") {
            Some(_) if !ty.ends_with("[]") => {
                tables.push(format!(
                    "(SELECT v FROM attack.v_{ty} ORDER BY md5(id::text || {}) LIMIT 3) t{i}",
                    rng.random_range(0..99)
                ));
                arguments.push(format!("t{i}.v"));
            }
            _ => arguments.push(pool.literal(rng, ty, &f.words)),
        }
    }
    let from = if tables.is_empty() { String::new() } else { format!("FROM {}", tables.join(", ")) };
    format!("SELECT {}({}) {from} LIMIT 50", f.name, arguments.join(", "))
}

/// Variables of PL/pgSQL: arrays come as expanded objects, and are used again after the call.
fn plpgsql(pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) -> String {
    let mut declared = String::new();
    let mut grown = String::new();
    for (i, ty) in f.arguments.iter().enumerate() {
        let ty = if ty == "cstring" { "text" } else { ty };
        declared.push_str(&format!("a{i} {ty} := {}; ", pool.literal(rng, ty, &f.words)));
        if ty.ends_with("[]") {
            grown.push_str(&format!("a{i}[1] := a{i}[1]; "));
        }
    }
    let arguments: Vec<String> = (0..f.arguments.len()).map(|i| format!("a{i}")).collect();
    let call = format!("PERFORM * FROM {}({}) LIMIT 5; ", f.name, arguments.join(", "));
    format!(
        "DO $attack$ DECLARE {declared}BEGIN BEGIN {grown}EXCEPTION WHEN array_subscript_error THEN NULL; END; {call}{call}END $attack$"
    )
}

/// Nobody can make an `internal`: PostgreSQL must refuse the call, or the function gets a pointer of the caller's.
fn internal(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, f: &Function) {
    let sql = format!("SELECT {}({}) IS NULL", f.name, pool.literals(rng, f));
    if s.query(&format!("{} called", f.signature), &sql, &[]).is_ok() {
        s.report.finding(Kind::Wrong, &f.signature, &sql, "a function with internal arguments can be called");
    }
}

fn operator(s: &mut Session, pool: &Pool, rng: &mut ChaCha8Rng, (left, name, right): &(String, String, String)) {
    let (a, b) = (pool.literal(rng, left, &[]), pool.literal(rng, right, &[]));
    let key = format!("{left} {name} {right}");
    let verb = if rng.random_bool(0.3) { "EXPLAIN SELECT" } else { "SELECT" };
    let _ = s.text(&key, &format!("{verb} {a} {name} {b}"));
}
