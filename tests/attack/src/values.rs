//! Valid and nasty values of every SQL type, made in the server by the constructors of the catalogue.

use std::collections::BTreeMap;

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::catalogue::{Catalogue, Function};
use crate::session::{Raw, Session};

/// A value in both of its forms.
#[derive(Debug, Clone)]
pub struct Value {
    pub text: String,
    pub binary: Vec<u8>,
}

/// Values by type; NULL is always one of the choices.
#[derive(Default)]
pub struct Pool {
    values: BTreeMap<String, Vec<Value>>,
}

/// Texts longer than this stay in tables: a statement of megabytes is a test of the parser.
const LONGEST_LITERAL: usize = 200_000;

/// Plain types: literals.
const PLAIN: &[(&str, &[&str])] = &[
    ("boolean", &["true", "false"]),
    ("smallint", &["0", "1", "-1", "32767", "-32768"]),
    ("integer", &["0", "1", "-1", "2", "3", "7", "100", "255", "65536", "2147483647", "-2147483648"]),
    ("bigint", &["0", "1", "-1", "42", "4294967296", "9223372036854775807", "-9223372036854775808"]),
    ("oid", &["0", "16", "4294967295"]),
    (
        "double precision",
        &[
            "0",
            "-0",
            "1",
            "-1",
            "0.5",
            "0.01",
            "0.001",
            "0.05",
            "3",
            "5",
            "100",
            "0.95",
            "2.5",
            "1e9",
            "NaN",
            "Infinity",
            "-Infinity",
            "1e308",
            "-1e308",
            "5e-324",
            "1e-300",
            "1e-12",
        ],
    ),
    (
        "double precision[]",
        &[
            "{}",
            "{NULL}",
            "{0,0,0}",
            "{1,2,3}",
            "{5,0,0}",
            "{-0,0,-0}",
            "{1,0,0,0}",
            "{0,0,1}",
            "{NaN,0,0}",
            "{Infinity,0,0}",
            "{1e308,1e308,-1e308}",
            "{5e-324,0,0}",
            "{600000,5300000,500}",
            "[5:7]={1,2,3}",
            "[-2147483648:-2147483646]={1,2,3}",
            "{{1,2,3}}",
            "{{0,0,0},{1,0,0},{0,1,0}}",
            "{{5,0,0},{5,0.01,0},{5,0.02,0.01}}",
            "{{{1,2,3}},{{4,5,6}}}",
            "{{1,NULL,3},{1,2,3}}",
            "{{{{{{1}}}}}}",
            "[0:1][3:5]={{1,2,3},{4,5,6}}",
            "{{1e-6,0,0},{0,1e-6,0},{0,0,1e-6}}",
            "{{-1,0,0},{0,1,0},{0,0,1}}",
            "{1,2}",
            "{1,2,3,4,5,6,7}",
        ],
    ),
    (
        "integer[]",
        &[
            "{}",
            "{NULL}",
            "{0}",
            "{0,1,2}",
            "{{0,1,2}}",
            "{{0,1,2},{2,1,0}}",
            "{{2147483647,0,1}}",
            "{{-1,0,1}}",
            "[7:7][0:2]={{0,1,2}}",
            "{{{0,1,2}}}",
            "{{0,1,NULL}}",
            "{65535,0,70000}",
            "{{255,0,0},{1,2,3},{0,0,0}}",
            "{100,200,300}",
        ],
    ),
    (
        "text[]",
        &["{}", "{NULL}", "{occupied}", "{occupied,ambiguous,empty,unknown}", "{new,NULL}", "{{a,b},{c,d}}", "{''}"],
    ),
    ("cstring", &["", "x", "nan"]),
    ("bytea", &["", "\\x00", "\\x01", "\\xffffffffffffffffffffffffffffffff"]),
];

/// Expressions that make values of plain types that no literal holds well.
const MADE: &[(&str, &str)] = &[
    ("text", "repeat('a', 100000)"),
    ("text", "'SELECT 1::bigint, v FROM attack.v_ab_solid ORDER BY id LIMIT 3'"),
    ("text", "'SELECT v FROM attack.v_ab_scan ORDER BY id LIMIT 3'"),
    ("text", "'SELECT 1/0'"),
    ("text", "'SELECT NULL::bigint, NULL'"),
    ("double precision[]", "(SELECT array_agg(ARRAY[5, i * 1e-3, (i % 7) * 1e-3]) FROM generate_series(1, 500) i)"),
    ("double precision[]", "array_fill(0::float8, ARRAY[3, 3])"),
    ("double precision[]", "array_fill(1e-6::float8, ARRAY[6, 6])"),
    ("double precision[]", "array_fill('nan'::float8, ARRAY[2000])"),
    ("integer[]", "array_fill(0, ARRAY[500, 3])"),
    ("integer[]", "(SELECT array_agg(ARRAY[i % 500, (i + 1) % 500, (i + 2) % 500]) FROM generate_series(1, 400) i)"),
    ("bytea", "decode(repeat('41', 100000), 'hex')"),
    // EWKB: TIN of one triangle, polygons whose rings cross themselves, a collection that nests, counts without bytes
    (
        "bytea",
        "'\\x01100000800100000001110000800100000004000000000000000000000000000000000000000000000000000000000000000000f03f000000000000000000000000000000000000000000000000000000000000f03f0000000000000000000000000000000000000000000000000000000000000000'::bytea",
    ),
    ("bytea", "'\\x0110000080ffffffff'::bytea"),
    ("bytea", "'\\x010f000080010000000103000080ffffff7f'::bytea"),
];

/// Expressions of our own types, rich enough that calls with them do work. Values that functions of the catalogue
/// return are added.
const OURS: &[(&str, &str)] = &[
    ("ab_loa", "'LOA10'::ab_loa"),
    ("ab_loa", "'LOA40'::ab_loa"),
    ("ab_box", "ab_box(0, 0, 0, 1, 1, 1)"),
    ("ab_box", "ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)"),
    ("ab_box", "ab_box(-0.0, 0, 0, 0, 0, -0.0)"),
    ("ab_box", "ab_box(-1e308, -1e308, -1e308, 1e308, 1e308, 1e308)"),
    ("ab_box", "ab_box(600000, 5300000, 500, 600001, 5300001, 501)"),
    ("ab_mass", "ab_mass(0.6, 0.1)"),
    ("ab_mass", "ab_mass(1, 0)"),
    ("ab_mass", "ab_mass(0, 1)"),
    ("ab_mass", "ab_mass(-0.0, 5e-324)"),
    ("ab_solid", "ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5))"),
    ("ab_solid", "ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]]::float8[], ARRAY[[0,1,2]])"),
    ("ab_solid", "ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]::float8[], ARRAY[[0,2,1],[0,1,3],[0,3,2],[1,2,3]])"),
    // long enough to be compressed or moved out of line when stored
    (
        "ab_solid",
        "(SELECT ab_solid(array_agg(ARRAY[i % 20, i / 20, sin(i)]::float8[] ORDER BY i), (SELECT array_agg(ARRAY[j, j + 1, j + 20] ORDER BY j) FROM generate_series(0, 378) j)) FROM generate_series(0, 399) i)",
    ),
    ("ab_scan", "ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[5,0,0]]::float8[])"),
    (
        "ab_scan",
        "(SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[5, y * 0.02, z * 0.02]::float8[] ORDER BY y, z), 0.004, 7) FROM generate_series(-20, 20) y, generate_series(-20, 20) z)",
    ),
    (
        "ab_scan",
        "ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[5,0,0],[5,0.01,0]]::float8[], intensity => ARRAY[1,65535], colour => ARRAY[[0,0,0],[255,1,2]], no_return => ARRAY[[1,0.1,0]]::float8[])",
    ),
    ("ab_scan", "ab_cloud(ARRAY[[5,0,0],[5,0.01,0],[5,0.02,0]]::float8[])"),
    ("ab_scan", "(ab_scan_agg(5, i * 0.01, 0, ARRAY[i * 0.1, 0, 0]::float8[]))[1] FROM generate_series(1, 50) i"),
    ("ab_evidence_model", "ab_evidence_model()"),
    ("ab_evidence_model", "ab_evidence_model('LOA40', 'meyer2022', spacing => 0.1)"),
    ("ab_evidence_model", "ab_evidence_model(spacing => 0.2, no_return_range => 30)"),
    (
        "ab_evidence",
        "ab_evidence_agg(ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)), p, ab_evidence_model(spacing => 0.2)) FROM (SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[5, y * 0.02, z * 0.02]::float8[] ORDER BY y, z), 0.004, 7) p FROM generate_series(-20, 20) y, generate_series(-20, 20) z) x",
    ),
    (
        "ab_evidence",
        "ab_evidence_agg(ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)), NULL, ab_evidence_model(spacing => 0.2))",
    ),
    (
        "ab_evidence",
        "ab_evidence_agg(ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)), p, ab_evidence_model('LOA20', 'meyer2022', spacing => 0.2)) FROM (SELECT ab_scan(ARRAY[0,1,0]::float8[], array_agg(ARRAY[5.01, y * 0.02, z * 0.02]::float8[] ORDER BY y, z), 0.004, 8) p FROM generate_series(-10, 10) y, generate_series(-10, 10) z) x",
    ),
    ("ab_point", "ab_point(1, 2, 3, 0.001)"),
    ("ab_point", "ab_point(0, -0.0, 0)"),
    ("ab_point", "ab_point(600000, 5300000, 500, 0.01)"),
    ("ab_line", "ab_line(ARRAY[0,0,0]::float8[], ARRAY[1,2,3]::float8[])"),
    ("ab_line", "ab_line(ab_point(0, 0, 0, 0.01), ab_point(1, 0, 0, 0.01))"),
    ("ab_plane", "ab_plane(ARRAY[0,0,0]::float8[], ARRAY[0,0,1]::float8[], 0.001, 0.001)"),
    ("ab_plane", "ab_plane(ARRAY[5,5,5]::float8[], ARRAY[1,0,0]::float8[])"),
    ("ab_pose", "ab_pose(ARRAY[1,2,3]::float8[])"),
    ("ab_pose", "ab_pose(ARRAY[1e6,2e6,3]::float8[], ARRAY[0.5,0.5,0.5,0.5]::float8[], 2, 0.001, 0.01, 0.001)"),
    ("ab_grid", "ab_grid(0.1, ab_box(0, -1, -1, 6, 1, 1))"),
    ("ab_grid", "ab_grid(0.05)"),
    ("ab_grid", "ab_grid(100, no_return_range => 10)"),
    ("ab_occupancy", "ab_voxelize(ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)), 0.1)"),
    (
        "ab_occupancy",
        "ab_occupancy_agg(p, ab_grid(0.1, ab_box(0, -1, -1, 6, 1, 1))) FROM (SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[5, y * 0.02, z * 0.02]::float8[] ORDER BY y, z), 0.004, 7) p FROM generate_series(-20, 20) y, generate_series(-20, 20) z) x",
    ),
    ("ab_occupancy", "ab_occupancy(ab_grid(0.1, ab_box(0, -1, -1, 6, 1, 1)))"),
    (
        "ab_change",
        "ab_change(ab_occupancy(ab_grid(0.1, ab_box(0, -1, -1, 6, 1, 1)), true), ab_occupancy_agg(p, ab_grid(0.1, ab_box(0, -1, -1, 6, 1, 1)))) FROM (SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[5, y * 0.02, z * 0.02]::float8[] ORDER BY y, z), 0.004, 7) p FROM generate_series(-20, 20) y, generate_series(-20, 20) z) x",
    ),
];

/// A quoted SQL literal.
pub fn quoted(text: &str) -> String {
    format!("E'{}'", text.replace('\\', "\\\\").replace('\'', "''"))
}

impl Pool {
    /// Makes the values, and a table `attack.v_TYPE (id, v)` of those of each of our types.
    pub fn make(session: &mut Session, catalogue: &Catalogue, rng: &mut ChaCha8Rng) -> Self {
        let mut pool = Self::default();
        for (ty, literals) in PLAIN {
            for l in *literals {
                pool.add(session, ty, &format!("{}::{ty}", quoted(l)));
            }
        }
        for w in ["", "occupied", "surface", "nan", "\u{1b}[31m", "../../etc", "x", "LOA30", "0.5", "=cmd|x"] {
            pool.add(session, "text", &format!("{}::text", quoted(w)));
        }
        for (ty, expression) in MADE.iter().chain(OURS) {
            if !pool.add(session, ty, expression) {
                println!("attack: STALE: no {ty} from {expression}");
            }
        }
        for polygon in crate::ewkb::polygons(rng, 24) {
            pool.add(session, "bytea", &format!("'\\x{polygon}'::bytea"));
        }
        pool.add_labels(session, catalogue);
        pool.derive(session, catalogue, rng);
        pool.store(session, catalogue);
        pool
    }

    /// Adds what the expression gives; `false` if it gives an error.
    pub fn add(&mut self, session: &mut Session, ty: &str, expression: &str) -> bool {
        let key = format!("value of {ty}");
        let Ok(binary) = session.query(&key, &format!("SELECT {expression}"), &[]) else { return false };
        let Ok(text) = session.text(&key, &format!("SELECT {expression}")) else { return false };
        let list = self.values.entry(ty.into()).or_default();
        for (text, binary) in text.into_iter().zip(binary).take(4) {
            if let (Some(text), Some(binary)) = (text, binary)
                && !list.iter().any(|v| v.text == text && v.binary == binary)
            {
                list.push(Value { text, binary });
            }
        }
        true
    }

    fn add_labels(&mut self, session: &mut Session, catalogue: &Catalogue) {
        for t in &catalogue.types {
            self.add(session, &t.name, &format!("unnest(enum_range(NULL::{}))", t.name));
        }
    }

    /// Types that no expression above makes: their values come from functions of the catalogue that return them, in a
    /// few rounds, because the arguments of one may come from another. Other types get some more values.
    fn derive(&mut self, session: &mut Session, catalogue: &Catalogue, rng: &mut ChaCha8Rng) {
        for _ in 0..3 {
            for f in catalogue.functions.iter().filter(|f| !f.aggregate) {
                let ours = catalogue.types.iter().any(|t| t.name == f.result);
                let most = if ours { 16 } else { 0 };
                for _ in 0..4 {
                    if self.of(&f.result).len() >= most || !self.can_call(f) {
                        break;
                    }
                    let arguments = self.literals(rng, f);
                    self.add(session, &f.result, &format!("{}({arguments})", f.name));
                }
            }
        }
        for t in &catalogue.types {
            if self.of(&t.name).is_empty() {
                println!("attack: STALE: no value of {}; add an expression to tests/attack/src/values.rs", t.name);
            }
        }
    }

    fn can_call(&self, f: &Function) -> bool {
        f.arguments.iter().all(|a| a != "internal" && a != "cstring")
    }

    fn store(&self, session: &mut Session, catalogue: &Catalogue) {
        for t in &catalogue.types {
            let table = format!("attack.v_{}", t.plain);
            let _ = session.execute("pool", &format!("CREATE TABLE {table} (id serial, v {})", t.name));
            for v in self.of(&t.name) {
                let _ = session.execute("pool", &format!("INSERT INTO {table} (v) VALUES ({})", quoted(&v.text)));
            }
            let _ = session.execute("pool", &format!("INSERT INTO {table} (v) VALUES (NULL)"));
        }
    }

    pub fn of(&self, ty: &str) -> &[Value] {
        self.values.get(ty).map_or(&[], Vec::as_slice)
    }

    pub fn push(&mut self, ty: &str, value: Value) {
        self.values.entry(ty.into()).or_default().push(value);
    }

    /// A value of the type; occasionally NULL.
    pub fn pick(&self, rng: &mut ChaCha8Rng, ty: &str) -> Option<&Value> {
        let all = self.of(ty);
        if all.is_empty() || rng.random_bool(0.06) { None } else { Some(&all[rng.random_range(0..all.len())]) }
    }

    /// SQL of an argument.
    pub fn literal(&self, rng: &mut ChaCha8Rng, ty: &str, words: &[String]) -> String {
        if ty == "internal" {
            return "NULL".into();
        }
        if ty == "text" && !words.is_empty() && rng.random_bool(0.7) {
            return format!("{}::text", quoted(&words[rng.random_range(0..words.len())]));
        }
        if let Some(element) = ty.strip_suffix("[]")
            && self.of(ty).is_empty()
        {
            return self.array(rng, element);
        }
        match self.pick(rng, ty) {
            Some(v) if v.text.len() <= LONGEST_LITERAL => format!("{}::{ty}", quoted(&v.text)),
            _ => format!("NULL::{ty}"),
        }
    }

    fn array(&self, rng: &mut ChaCha8Rng, element: &str) -> String {
        let n = rng.random_range(0..4);
        let elements: Vec<String> = (0..n).map(|_| self.literal(rng, element, &[])).collect();
        match rng.random_range(0..5) {
            0 if n > 0 => format!("ARRAY[[{}]]::{element}[]", elements.join("],[")),
            1 if n > 0 => format!("array_fill({}, ARRAY[2], ARRAY[-5])", elements[0]),
            _ => format!("ARRAY[{}]::{element}[]", elements.join(", ")),
        }
    }

    /// SQL of all arguments of a function.
    pub fn literals(&self, rng: &mut ChaCha8Rng, f: &Function) -> String {
        let all: Vec<String> = f.arguments.iter().map(|a| self.literal(rng, a, &f.words)).collect();
        all.join(", ")
    }

    /// The binary form of an argument, damaged with the given probability.
    pub fn raw(&self, rng: &mut ChaCha8Rng, ty: &str, damage: f64) -> Option<Raw> {
        let other = self.pick(rng, ty).map_or(&[][..], |v| &v.binary).to_vec();
        let value = self.pick(rng, ty)?;
        if !rng.random_bool(damage) {
            return Some(Raw(value.binary.clone()));
        }
        let damaged = crate::mutate::bytes(rng, &value.binary, &other);
        // Under a checksum that holds, damage gets past the first look at it.
        let mended = rng.random_bool(0.7) && matches!(value.binary.get(1), Some(b'P' | b'S' | b'E' | b'O' | b'C'));
        Some(Raw(if mended { asbuilt_fuzz_targets::mended(&damaged) } else { damaged }))
    }
}
