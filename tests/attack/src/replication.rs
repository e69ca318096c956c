//! Logical replication with `binary = true`: a table of every type, changed in every way; both servers live and agree.

use std::time::{Duration, Instant};

use postgres::Client;

use crate::catalogue::{Catalogue, Type};
use crate::cluster::{AMPLE_KB, Cluster, deaths};
use crate::report::Kind;
use crate::session::Session;

/// Settings that a publisher needs.
pub const PUBLISHER: &str = "wal_level = logical\nmax_wal_senders = 10\nmax_replication_slots = 10";

/// The subscriber catches up within this, or something is wrong.
const PATIENCE: Duration = Duration::from_secs(20);

/// All types at once; each alone, to name the one, when that fails.
pub fn run(s: &mut Session, catalogue: &Catalogue) {
    let mut subscriber = Cluster::start(
        "subscriber",
        AMPLE_KB,
        "max_logical_replication_workers = 8\nmax_sync_workers_per_subscription = 4",
    );
    let mut there = subscriber.database("attack");
    // Only what the publisher says from now on is of this piece.
    s.cluster.new_log();
    let all: Vec<&Type> = catalogue.types.iter().collect();
    if replicate(s, &mut subscriber, &mut there, &all, "all") {
        return;
    }
    for t in all {
        replicate(s, &mut subscriber, &mut there, &[t], &t.plain);
    }
}

/// Values alone, in arrays and in composites; REPLICA IDENTITY FULL where the type has `=`: rows are then found by it.
fn table(t: &Type, publisher: bool) -> String {
    let made =
        format!("CREATE TABLE attack.s_{0} (id integer PRIMARY KEY, v {1}, a {1}[], c attack.c_{0})", t.plain, t.name);
    match publisher {
        true if t.equal => format!(
            "DROP TABLE IF EXISTS attack.s_{0}; {made}; ALTER TABLE attack.s_{0} REPLICA IDENTITY FULL",
            t.plain
        ),
        true => format!("DROP TABLE IF EXISTS attack.s_{}; {made}", t.plain),
        false => format!("CREATE TYPE attack.c_{0} AS (n integer, v {1}, a {1}[]); {made}", t.plain, t.name),
    }
}

/// Publishes, subscribes, changes, compares; whether all went well.
fn replicate(s: &mut Session, subscriber: &mut Cluster, there: &mut Client, types: &[&Type], p: &str) -> bool {
    let key = format!("replication of {p}");
    let names: Vec<String> = types.iter().map(|t| format!("attack.s_{}", t.plain)).collect();
    let mut publish: Vec<String> = types.iter().map(|t| table(t, true)).collect();
    publish.push(format!("CREATE PUBLICATION p_{p} FOR TABLE {}", names.join(", ")));
    let mut subscribe: Vec<String> = types.iter().map(|t| table(t, false)).collect();
    subscribe.push(format!(
        "CREATE SUBSCRIPTION s_{p} CONNECTION 'host={} user=postgres dbname=attack' PUBLICATION p_{p} \
         WITH (binary = true, slot_name = 's_{p}')",
        s.cluster.socket_dir().display()
    ));
    let changes: Vec<String> = types.iter().flat_map(|t| changes(&t.plain)).collect();
    let statement =
        [&publish[..], &["-- there:".into()], &subscribe, &["-- here:".into()], &changes].concat().join(";\n");
    clear(s, p);
    for sql in &publish {
        let _ = s.execute(&key, sql);
    }
    let clean = match subscribe.iter().try_for_each(|sql| there.batch_execute(sql)) {
        Ok(()) => {
            for change in changes {
                let _ = s.execute(&key, &change);
            }
            caught_up(s, subscriber, there, types, &key, &statement)
        }
        Err(e) => {
            s.report.finding(Kind::Stale, &key, &statement, &format!("{e:?}"));
            false
        }
    };
    end(subscriber, there, types, p);
    clear(s, p);
    // A publisher that died took this session with it.
    s.set_up("");
    clean
}

/// What happens to the published table.
fn changes(p: &str) -> [String; 4] {
    let row = format!("v, ARRAY[v, NULL, v], ROW(1, v, ARRAY[v])::attack.c_{p}");
    let next = "y.id = (x.id + 1) % 7 AND x.id % 2 = 0";
    [
        format!("INSERT INTO attack.s_{p} SELECT id, {row} FROM attack.v_{p} WHERE id <= 30"),
        format!("UPDATE attack.s_{p} x SET v = y.v, a = ARRAY[y.v] FROM attack.v_{p} y WHERE {next}"),
        format!("UPDATE attack.s_{p} SET c = NULL WHERE id % 5 = 0"),
        format!("DELETE FROM attack.s_{p} WHERE id % 3 = 0"),
    ]
}

/// Removes publication and slot, by a connection of its own: what the sender did to the server is recorded already.
fn clear(s: &Session, p: &str) {
    let slot = format!("FROM pg_replication_slots WHERE slot_name = 's_{p}'");
    for sql in [
        format!("DROP PUBLICATION IF EXISTS p_{p}"),
        format!("SELECT pg_terminate_backend(active_pid) {slot}"),
        "SELECT pg_sleep(0.1)".into(),
        format!("SELECT pg_drop_replication_slot(slot_name) {slot}"),
    ] {
        let _ = s.cluster.connect("attack").batch_execute(&sql);
    }
}

/// Waits until both hold the same; records what died in the meantime.
fn caught_up(
    s: &mut Session,
    subscriber: &mut Cluster,
    there: &mut Client,
    types: &[&Type],
    key: &str,
    statement: &str,
) -> bool {
    let sum = |t: &&Type| {
        format!(
            "(SELECT count(*) || ' ' || coalesce(md5(string_agg(x::text, ';' ORDER BY id)), '') FROM attack.s_{} x)",
            t.plain
        )
    };
    let sums = format!("SELECT {}", types.iter().map(sum).collect::<Vec<_>>().join(" || "));
    let began = Instant::now();
    loop {
        for (who, log) in [("publisher", s.cluster.new_log()), ("subscriber", subscriber.new_log())] {
            let dead = deaths(&log);
            if !dead.is_empty() {
                s.report.finding(Kind::Crash, key, statement, &format!("{who}: {}", dead.join("; ")));
                return false;
            }
            if let Some(line) = log.lines().find(|l| l.contains(" XX0")) {
                s.report.finding(Kind::Internal, key, statement, &format!("{who}: {line}"));
            }
        }
        let here = s.text(key, &sums).ok().and_then(|r| r.first().cloned().flatten());
        let copy: Option<String> = there.query_one(&sums, &[]).ok().map(|r| r.get(0));
        if here.is_some() && here == copy {
            return true;
        }
        if began.elapsed() > PATIENCE {
            s.report.finding(Kind::Wrong, key, statement, &format!("the copies differ: {here:?}, {copy:?}"));
            return false;
        }
        std::thread::sleep(Duration::from_millis(100));
    }
}

/// Drops the subscription, whatever became of the publisher.
fn end(subscriber: &Cluster, there: &mut Client, types: &[&Type], p: &str) {
    if there.is_closed() {
        *there = subscriber.connect("attack");
    }
    let mut sql = vec![
        format!("ALTER SUBSCRIPTION s_{p} DISABLE"),
        format!("ALTER SUBSCRIPTION s_{p} SET (slot_name = NONE)"),
        format!("DROP SUBSCRIPTION s_{p}"),
    ];
    sql.extend(types.iter().map(|t| format!("DROP TABLE attack.s_{0}; DROP TYPE attack.c_{0}", t.plain)));
    sql.iter().for_each(|sql| drop(there.batch_execute(sql)));
}
