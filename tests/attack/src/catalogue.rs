//! What the extensions contain, from the server's own catalogue: no name is written here.

use postgres::Client;

/// Our extensions, as an SQL list.
pub const OURS: &str = "('asbuilt', 'asbuilt_postgis', 'asbuilt_pointcloud', 'asbuilt_postgis_raster')";

#[derive(Debug, Clone)]
pub struct Function {
    /// Full name, as schema.name
    pub name: String,
    /// With argument types: names the attack.
    pub signature: String,
    pub aggregate: bool,
    pub immutable: bool,
    /// Types of the input arguments, as SQL.
    pub arguments: Vec<String>,
    pub result: String,
    /// Names of the input arguments; empty where they have none.
    pub names: Vec<String>,
    /// How many of the last arguments may be left out.
    pub defaults: i16,
    /// `OUT` arguments, as SQL.
    pub outs: String,
    /// What stands behind RETURNS.
    pub returns: String,
    /// Lower-case words of its comment and defaults: candidates for its text arguments.
    pub words: Vec<String>,
}

#[derive(Debug, Clone)]
pub struct Type {
    pub name: String,
    /// A name to build others from: no schema, no quotes.
    pub plain: String,
    pub ordered: bool,
    pub equal: bool,
}

#[derive(Debug, Clone)]
pub struct OpClass {
    pub name: String,
    pub method: String,
    pub ty: String,
    /// Operator and right-hand type, and whether it orders.
    pub operators: Vec<(String, String, bool)>,
}

pub struct Catalogue {
    pub functions: Vec<Function>,
    pub types: Vec<Type>,
    pub opclasses: Vec<OpClass>,
    /// Every operator: left type, name, right type.
    pub operators: Vec<(String, String, String)>,
    /// Settings that limit memory.
    pub limits: Vec<String>,
}

fn members(class: &str) -> String {
    format!(
        "FROM {class} o JOIN pg_depend d ON d.classid = '{class}'::regclass AND d.objid = o.oid AND d.deptype = 'e' \
         JOIN pg_extension x ON d.refclassid = 'pg_extension'::regclass AND d.refobjid = x.oid AND x.extname IN {OURS}"
    )
}

impl Catalogue {
    pub fn read(client: &mut Client) -> Self {
        // The settings are known once the library is loaded.
        client.batch_execute("LOAD '$libdir/asbuilt'").expect("the library loads");
        let limits = client
            .query("SELECT name FROM pg_settings WHERE name ~ '^asbuilt\\.max_.*memory$' ORDER BY 1", &[])
            .unwrap();
        Self {
            functions: functions(client),
            types: types(client),
            opclasses: opclasses(client),
            operators: operators(client),
            limits: limits.iter().map(|r| r.get(0)).collect(),
        }
    }
}

fn functions(client: &mut Client) -> Vec<Function> {
    let sql = format!(
        "SELECT format('%I.%I', o.pronamespace::regnamespace, o.proname), o.oid::regprocedure::text, o.prokind = 'a', \
         o.provolatile = 'i', o.prorettype::regtype::text, \
         ARRAY(SELECT t::regtype::text FROM unnest(o.proargtypes) WITH ORDINALITY u(t, n) ORDER BY n), \
         coalesce(obj_description(o.oid, 'pg_proc'), '') || ' ' || coalesce(pg_get_expr(o.proargdefaults, 0), ''), \
         coalesce(o.proargnames[:o.pronargs], '{{}}'), o.pronargdefaults, \
         coalesce((SELECT string_agg(format('OUT %I %s', n, t::regtype), ', ') FROM unnest(o.proargnames, o.proallargtypes, o.proargmodes) \
           u(n, t, m) WHERE m = 'o'), ''), coalesce(pg_get_function_result(o.oid), '') \
         {} WHERE o.prokind IN ('f', 'a') ORDER BY 2",
        members("pg_proc")
    );
    let of = |r: &postgres::Row| Function {
        name: r.get(0),
        signature: r.get(1),
        aggregate: r.get(2),
        immutable: r.get(3),
        result: r.get(4),
        arguments: r.get(5),
        words: words(r.get(6)),
        names: r.get(7),
        defaults: r.get(8),
        outs: r.get(9),
        returns: r.get(10),
    };
    client.query(&sql, &[]).expect("pg_proc").iter().map(of).collect()
}

fn words(text: &str) -> Vec<String> {
    let mut all: Vec<String> = text
        .split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
        .filter(|w| w.len() > 2 && w.len() < 24)
        .map(String::from)
        .collect();
    all.sort();
    all.dedup();
    all
}

/// Rows are left out: PostgreSQL reads and writes them itself.
fn types(client: &mut Client) -> Vec<Type> {
    let has = |methods: &str| {
        format!(
            "EXISTS (SELECT FROM pg_opclass c JOIN pg_am a ON a.oid = c.opcmethod WHERE a.amname IN ({methods}) \
             AND c.opcdefault AND c.opcintype IN (o.oid, CASE WHEN o.typtype = 'e' THEN 'anyenum'::regtype END))"
        )
    };
    let sql = format!(
        "SELECT o.oid::regtype::text, o.typname, {}, {} \
         {} WHERE o.typtype IN ('b', 'e', 'd', 'r') AND o.typcategory <> 'A' ORDER BY 1",
        has("'btree'"),
        has("'btree', 'hash'"),
        members("pg_type")
    );
    let of = |r: &postgres::Row| Type { name: r.get(0), plain: r.get(1), ordered: r.get(2), equal: r.get(3) };
    client.query(&sql, &[]).expect("pg_type").iter().map(of).collect()
}

fn opclasses(client: &mut Client) -> Vec<OpClass> {
    let sql = format!(
        "SELECT format('%I.%I', o.opcnamespace::regnamespace, o.opcname), m.amname, o.opcintype::regtype::text, \
         ARRAY(SELECT format('OPERATOR(%I.%s)', p.oprnamespace::regnamespace, p.oprname) FROM pg_amop a JOIN pg_operator p \
           ON p.oid = a.amopopr WHERE a.amopfamily = o.opcfamily AND a.amoplefttype = o.opcintype ORDER BY a.oid), \
         ARRAY(SELECT a.amoprighttype::regtype::text FROM pg_amop a WHERE a.amopfamily = o.opcfamily \
           AND a.amoplefttype = o.opcintype ORDER BY a.oid), \
         ARRAY(SELECT a.amoppurpose = 'o' FROM pg_amop a WHERE a.amopfamily = o.opcfamily \
           AND a.amoplefttype = o.opcintype ORDER BY a.oid) \
         {} JOIN pg_am m ON m.oid = o.opcmethod ORDER BY 1",
        members("pg_opclass")
    );
    let of = |r: &postgres::Row| {
        let (names, rights, orders): (Vec<String>, Vec<String>, Vec<bool>) = (r.get(3), r.get(4), r.get(5));
        let operators = names.into_iter().zip(rights).zip(orders).map(|((n, r), o)| (n, r, o)).collect();
        OpClass { name: r.get(0), method: r.get(1), ty: r.get(2), operators }
    };
    client.query(&sql, &[]).expect("pg_opclass").iter().map(of).collect()
}

fn operators(client: &mut Client) -> Vec<(String, String, String)> {
    let sql = format!(
        "SELECT o.oprleft::regtype::text, format('OPERATOR(%I.%s)', o.oprnamespace::regnamespace, o.oprname), \
         o.oprright::regtype::text {} WHERE o.oprleft <> 0 ORDER BY o.oid::regoperator::text",
        members("pg_operator")
    );
    client.query(&sql, &[]).expect("pg_operator").iter().map(|r| (r.get(0), r.get(1), r.get(2))).collect()
}
