//! Every type through text and binary, alone and inside arrays, composites, ranges of rows and domains; COPY both ways;
//! damaged binary and text forms.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::catalogue::{Catalogue, Type};
use crate::mutate;
use crate::report::Kind;
use crate::session::{Raw, Session};
use crate::values::{Pool, Value, quoted};

/// What a value `v` can stand in: name, expression, type of the column if a table can hold it.
fn shapes(t: &Type) -> Vec<(&'static str, String, Option<String>)> {
    let p = &t.plain;
    let row = format!("ROW(1, v, ARRAY[v, v])::attack.c_{p}");
    let mut all = vec![
        ("alone", "v".into(), Some(t.name.clone())),
        ("array", "ARRAY[v]".into(), Some(format!("{}[]", t.name))),
        ("array with NULL", "ARRAY[v, NULL, v]".into(), Some(format!("{}[]", t.name))),
        ("array of two dimensions", "ARRAY[[v], [v]]".into(), Some(format!("{}[]", t.name))),
        ("array from elsewhere", "array_fill(v, ARRAY[2], ARRAY[-7])".into(), Some(format!("{}[]", t.name))),
        ("array appended", "array_append(ARRAY[v], v)".into(), Some(format!("{}[]", t.name))),
        ("record", "ROW(v, ARRAY[v])".into(), None),
        ("composite", row.clone(), Some(format!("attack.c_{p}"))),
        ("array of composites", format!("ARRAY[{row}, NULL]"), Some(format!("attack.c_{p}[]"))),
        ("domain", format!("v::attack.d_{p}"), Some(format!("attack.d_{p}"))),
        ("array of domain", format!("ARRAY[v::attack.d_{p}]"), Some(format!("attack.d_{p}[]"))),
        ("range of rows", format!("attack.rc_{p}({row}, NULL)"), Some(format!("attack.rc_{p}"))),
        (
            "multirange of rows",
            format!("multirange(attack.rc_{p}({row}, NULL))"),
            Some(format!("attack.rc_{p}_multirange")),
        ),
    ];
    if t.ordered {
        all.push(("range", format!("attack.r_{p}(v, NULL)"), Some(format!("attack.r_{p}"))));
        all.push(("closed range", format!("attack.r_{p}(v, v, '[]')"), Some(format!("attack.r_{p}"))));
    }
    all
}

/// Domain, composite, ranges of every type; once.
pub fn declare(s: &mut Session, catalogue: &Catalogue) {
    catalogue.types.iter().for_each(|t| declare_of(s, t));
}

fn declare_of(s: &mut Session, t: &Type) {
    let (p, name) = (&t.plain, &t.name);
    let mut sql = vec![
        format!("CREATE DOMAIN attack.d_{p} AS {name}"),
        format!("CREATE TYPE attack.c_{p} AS (n integer, v {name}, a {name}[])"),
        format!("CREATE TYPE attack.rc_{p} AS RANGE (subtype = attack.c_{p})"),
    ];
    if t.ordered {
        sql.push(format!("CREATE TYPE attack.r_{p} AS RANGE (subtype = {name})"));
    }
    for statement in sql {
        if let Err(e) = s.execute(&format!("declare {p}"), &statement) {
            println!("attack: STALE: {statement}: {e:?}");
        }
    }
}

pub fn run(s: &mut Session, catalogue: &Catalogue, pool: &mut Pool, rng: &mut ChaCha8Rng, rounds: u32) {
    for t in &catalogue.types {
        // Damaged values that were taken stay, but not without bound.
        let _ = s.execute("pool", &format!("DELETE FROM attack.v_{} WHERE id > 300", t.plain));
        for (shape, expression, column) in shapes(t) {
            outputs(s, t, shape, &expression);
            if let Some(column) = column {
                round_trip(s, t, shape, &expression, &column);
            }
        }
        gathered(s, t);
        compared(s, t);
    }
    for _ in 0..rounds {
        for t in &catalogue.types {
            damaged_parameter(s, t, pool, rng);
            damaged_copy(s, t, pool, rng);
            damaged_text(s, t, pool, rng);
        }
    }
}

/// Output in four ways: binary and text protocol, COPY in both formats; of stored values and constants.
fn outputs(s: &mut Session, t: &Type, shape: &str, expression: &str) {
    // `offset 0` and a table: values as stored, with short headers, compressed, out of line. The constant: as made.
    let stored = format!("SELECT {expression} FROM attack.v_{} WHERE v IS NOT NULL", t.plain);
    let made = stored.replace(" v FROM", " FROM").replace(
        &format!("FROM attack.v_{}", t.plain),
        &format!("FROM (SELECT v::text::{} AS v FROM attack.v_{} OFFSET 0) made", t.name, t.plain),
    );
    for (from, sql) in [("stored", &stored), ("made", &made)] {
        let what = format!("{shape} of {}, {from}", t.name);
        let _ = s.query(&format!("binary result: {what}"), sql, &[]);
        let _ = s.text(&format!("text result: {what}"), sql);
        let _ = s.copy_out(&format!("COPY TO binary: {what}"), &format!("COPY ({sql}) TO STDOUT (FORMAT binary)"));
        let _ = s.copy_out(&format!("COPY TO text: {what}"), &format!("COPY ({sql}) TO STDOUT"));
    }
}

/// What is written in either format reads back the same.
fn round_trip(s: &mut Session, t: &Type, shape: &str, expression: &str, column: &str) {
    let key = format!("round trip: {shape} of {}", t.name);
    let (from, to) = ("attack.trip_from", "attack.trip_to");
    let make = format!(
        "DROP TABLE IF EXISTS {from}, {to}; \
         CREATE TABLE {from} (id int GENERATED ALWAYS AS IDENTITY, x {column}); CREATE TABLE {to} (LIKE {from} INCLUDING ALL); \
         INSERT INTO {from} (x) SELECT {expression} FROM attack.v_{} WHERE v IS NOT NULL",
        t.plain
    );
    if s.execute(&key, &make).is_err() {
        return;
    }
    for format in ["binary", "text"] {
        let out = |s: &mut Session, table: &str, format: &str| {
            // In the order of loading: where wide rows leave room on a page, narrower ones that come later fill it.
            let sql = format!("COPY (SELECT x FROM {table} ORDER BY id) TO STDOUT (FORMAT {format})");
            s.copy_out(&format!("{key}, {format}"), &sql)
        };
        let Ok(bytes) = out(s, from, format) else { continue };
        let _ = s.execute(&key, &format!("TRUNCATE {to}"));
        let copied =
            s.copy_in(&format!("{key}, {format} in"), &format!("COPY {to} (x) FROM STDIN (FORMAT {format})"), &bytes);
        if let Err(fault) = copied {
            s.report.finding(Kind::Wrong, &format!("{key} {format}"), &make, &format!("does not come back: {fault:?}"));
            continue;
        }
        // The text of the damaged twin may differ where the binary does not, and the other way round: ask both.
        for other in ["binary", "text"] {
            if let (Ok(a), Ok(b)) = (out(s, from, other), out(s, to, other))
                && a != b
            {
                let detail = format!("through {format} its {other} form changed");
                s.report.finding(Kind::Wrong, &format!("{key} {format}"), &make, &detail);
            }
        }
    }
}

/// Aggregates of PostgreSQL itself that hold our values.
fn gathered(s: &mut Session, t: &Type) {
    let table = format!("attack.v_{}", t.plain);
    for (name, sql) in [
        ("array_agg", format!("SELECT array_agg(v) FROM {table}")),
        ("array_agg of arrays", format!("SELECT array_agg(ARRAY[v]) FROM {table}")),
        ("array_agg window", format!("SELECT array_agg(v) OVER (ORDER BY id ROWS 2 PRECEDING) FROM {table}")),
        (
            "array_agg of composites",
            format!("SELECT array_agg(ROW(1, v, ARRAY[v])::attack.c_{}) FROM {table}", t.plain),
        ),
        ("subquery array", format!("SELECT ARRAY(SELECT v FROM {table} ORDER BY id)")),
        ("whole row", format!("SELECT x FROM {table} x")),
        ("array of whole rows", format!("SELECT array_agg(x) FROM {table} x")),
        ("lag", format!("SELECT lag(v) OVER (ORDER BY id) FROM {table}")),
        ("json", format!("SELECT to_jsonb(x) FROM {table} x")),
        ("union all", format!("SELECT v FROM {table} UNION ALL SELECT v FROM {table}")),
        ("case", format!("SELECT CASE WHEN id % 2 = 0 THEN v END FROM {table}")),
        ("scalar subquery", format!("SELECT (SELECT y.v FROM {table} y WHERE y.id = x.id) FROM {table} x")),
    ] {
        let key = format!("{name} of {}", t.name);
        let _ = s.query(&format!("binary result: {key}"), &sql, &[]);
        let _ = s.text(&format!("text result: {key}"), &sql);
        let _ = s.copy_out(&format!("COPY TO binary: {key}"), &format!("COPY ({sql}) TO STDOUT (FORMAT binary)"));
    }
}

/// DISTINCT, GROUP BY, joins and order, where the type has them; a value equals itself.
fn compared(s: &mut Session, t: &Type) {
    let table = format!("attack.v_{}", t.plain);
    let mut sql = vec![];
    if t.equal {
        sql.push(format!("SELECT DISTINCT v FROM {table}"));
        sql.push(format!("SELECT count(*) FROM {table} GROUP BY v"));
        sql.push(format!("SELECT count(*) FROM {table} a JOIN {table} b ON a.v = b.v"));
        sql.push(format!("SELECT DISTINCT ARRAY[v] FROM {table}"));
        sql.push(format!("SELECT DISTINCT ROW(1, v, ARRAY[v])::attack.c_{} FROM {table}", t.plain));
        sql.push(format!("SELECT v FROM {table} INTERSECT SELECT v FROM {table}"));
    }
    if t.ordered {
        sql.push(format!("SELECT v FROM {table} ORDER BY v DESC"));
        sql.push(format!("SELECT max(ARRAY[v]) FROM {table}"));
        sql.push(format!("SELECT array_agg(DISTINCT v) FROM {table}"));
    }
    for statement in sql {
        let _ = s.query(&format!("comparison: {statement}"), &statement, &[]);
    }
    if t.equal {
        let key = format!("itself of {}", t.name);
        let statement = format!("SELECT count(*) FROM {table} WHERE v IS NOT NULL AND NOT v = v::text::{}", t.name);
        if let Ok(rows) = s.text(&key, &statement)
            && rows != [Some("0".to_string())]
        {
            s.report.finding(Kind::Wrong, &key, &statement, "a value differs from what its own text gives");
        }
    }
}

/// A damaged binary parameter, alone or in an array, composite or range; what is taken joins the pool.
fn damaged_parameter(s: &mut Session, t: &Type, pool: &mut Pool, rng: &mut ChaCha8Rng) {
    let Some(raw) = pool.raw(rng, &t.name, 0.9) else { return };
    let (value, ty) = match rng.random_range(0..5) {
        0 => (in_array(rng, s, t, &raw.0), format!("{}[]", t.name)),
        1 => (raw, format!("attack.d_{}", t.plain)),
        _ => (raw, t.name.clone()),
    };
    let key = format!("damaged binary parameter of {ty}");
    let sql = format!("SELECT $1::{ty}, ($1::{ty})::text");
    let Ok(rows) = s.query(&key, &sql, &[Some(value.clone())]) else { return };
    if ty != t.name || pool.of(&ty).len() > 200 {
        return;
    }
    let text = s.query(&key, &format!("SELECT ($1::{ty})::text"), &[Some(value)]);
    if let (Some(Some(binary)), Ok(Some(Some(text)))) = (rows.first(), text.as_ref().map(|t| t.first())) {
        accept(s, t, pool, binary, text);
    }
}

/// A value that was accepted must come back through both of its forms.
fn accept(s: &mut Session, t: &Type, pool: &mut Pool, binary: &[u8], text: &[u8]) {
    let key = format!("accepted value of {}", t.name);
    let text = String::from_utf8_lossy(text).into_owned();
    let sql = format!("SELECT {}::{}", quoted(&text), t.name);
    match s.query(&key, &sql, &[]).as_deref() {
        Ok([Some(again)]) if again == binary => {}
        Ok([Some(_)]) => s.report.finding(Kind::Wrong, &key, &sql, "its text gives another binary form"),
        other => {
            let detail = format!("taken in binary, its text is refused: {other:?}");
            s.report.finding(Kind::Wrong, &key, &sql, &detail);
        }
    }
    let _ = s.execute(&key, &format!("INSERT INTO attack.v_{} (v) VALUES ({})", t.plain, quoted(&text)));
    pool.push(&t.name, Value { text, binary: binary.to_vec() });
}

/// The binary form of an array of one element, its head damaged now and then: dimensions, flags, lower bounds.
fn in_array(rng: &mut ChaCha8Rng, s: &mut Session, t: &Type, element: &[u8]) -> Raw {
    let oid = s.text("oid", &format!("SELECT '{}'::regtype::oid", t.name)).ok();
    let oid: u32 = oid.and_then(|r| r.first().cloned().flatten()).and_then(|o| o.parse().ok()).unwrap_or(0);
    let mut b = vec![];
    for word in [1u32, 0, oid, 1, 1] {
        b.extend(word.to_be_bytes());
    }
    if rng.random_bool(0.3) {
        b = mutate::bytes(rng, &b, element);
    }
    b.extend((element.len() as u32).to_be_bytes());
    b.extend(element);
    Raw(b)
}

/// COPY FROM in binary, of a damaged field or a damaged stream.
fn damaged_copy(s: &mut Session, t: &Type, pool: &mut Pool, rng: &mut ChaCha8Rng) {
    let Some(raw) = pool.raw(rng, &t.name, 0.8) else { return };
    let mut stream = b"PGCOPY\n\xff\r\n\0\0\0\0\0\0\0\0\0\0\x01".to_vec();
    stream.extend((raw.0.len() as u32).to_be_bytes());
    stream.extend(&raw.0);
    stream.extend((-1i16).to_be_bytes());
    if rng.random_bool(0.2) {
        stream = mutate::bytes(rng, &stream, &raw.0);
    }
    let key = format!("damaged COPY FROM binary of {}", t.name);
    let _ = s.copy_in(&key, &format!("COPY attack.v_{} (v) FROM STDIN (FORMAT binary)", t.plain), &stream);
}

fn damaged_text(s: &mut Session, t: &Type, pool: &mut Pool, rng: &mut ChaCha8Rng) {
    let other = pool.pick(rng, &t.name).map_or(String::new(), |v| v.text.clone());
    let Some(value) = pool.pick(rng, &t.name) else { return };
    let text = mutate::text(rng, &value.text, &other);
    let sql = format!("SELECT {}::{}", quoted(&text), t.name);
    let _ = s.query(&format!("damaged text of {}", t.name), &sql, &[]);
}
