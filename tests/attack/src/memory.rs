//! Heavy calls in a server of little memory: each answers or says 53200 or 54000, and the other sessions live. And the
//! limits that the settings promise: what a backend takes at most, without what it shares, stays near them.

use std::time::Duration;

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::catalogue::Catalogue;
use crate::cluster::{Cluster, SMALL_KB};
use crate::report::{Kind, Report};
use crate::session::{Fault, Session};

/// Objects and scans large enough to be asked fine questions: a hall of 20 m, walls of it, 200 000 beams.
const TABLES: &str = "
    CREATE SCHEMA heavy;
    CREATE TABLE heavy.solids AS SELECT 1::bigint AS id, ab_solid(ab_box(5, -10, -2, 25, 10, 2)) AS solid
        UNION ALL SELECT 1 + i, ab_solid(ab_box(5, -10 + i, -2, 5.2, -9 + i, 2)) FROM generate_series(1, 19) i;
    CREATE TABLE heavy.rows AS SELECT s AS station, 5::float8 AS x, y * 0.02 AS y, z * 0.02 AS z, ARRAY[0, s * 0.5, 0]::float8[] AS origin
        FROM generate_series(1, 4) s, generate_series(-500, 500) y, generate_series(-25, 25) z;
    CREATE TABLE heavy.scans AS SELECT station, unnest(ab_scan_agg(x, y, z, origin, station ORDER BY y, z)) AS patch FROM heavy.rows GROUP BY station;
    ANALYZE;";

/// Name, whether a memory setting bounds it, statement.
const HEAVY: &[(&str, bool, &str)] = &[
    (
        "verify_table 3 mm",
        true,
        "SELECT count(evidence) FROM ab_verify_table('SELECT id, solid FROM heavy.solids', 'SELECT patch FROM heavy.scans', ab_evidence_model(spacing => 0.003))",
    ),
    ("occupancy_agg 4 mm", true, "SELECT ab_box(ab_occupancy_agg(patch, ab_grid(0.004))) FROM heavy.scans"),
    (
        "occupancy_agg in groups",
        true,
        "SELECT count(o) FROM (SELECT ab_occupancy_agg(patch, ab_grid(0.02)) AS o FROM heavy.scans GROUP BY patch::text) x",
    ),
    (
        "occupancy_agg no returns",
        true,
        "SELECT ab_box(ab_occupancy_agg(ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[5,0,0]]::float8[], no_return => ARRAY[[1,0.5,0],[1,-0.5,0]]::float8[]), ab_grid(0.0005, no_return_range => 100)))",
    ),
    (
        "change",
        true,
        "SELECT ab_box(ab_change(ab_voxelize(solid, 0.01), ab_voxelize(solid, 0.01))) FROM heavy.solids WHERE id = 1",
    ),
    ("voxelize 4 mm", true, "SELECT ab_box(ab_voxelize(solid, 0.004)) FROM heavy.solids WHERE id = 1"),
    (
        "voxelize surface 2 mm",
        true,
        "SELECT ab_box(ab_voxelize(solid, 0.002, 'surface')) FROM heavy.solids WHERE id = 1",
    ),
    (
        "evidence_agg 2 mm",
        true,
        "SELECT ab_count(ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.002))) FROM heavy.solids, heavy.scans WHERE id = 1",
    ),
    (
        "evidence_agg in groups",
        true,
        "SELECT count(e) FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.01)) AS e FROM heavy.solids, heavy.scans GROUP BY id) x",
    ),
    (
        "rollup_agg of evidence",
        true,
        "SELECT ab_count(ab_rollup_agg(e)) FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.02)) AS e FROM heavy.solids, heavy.scans WHERE id = 1 GROUP BY station) x, generate_series(1, 3)",
    ),
    (
        "rollup_agg of occupancies",
        true,
        "SELECT ab_box(ab_rollup_agg(o)) FROM (SELECT ab_occupancy_agg(patch, ab_grid(0.02)) AS o FROM heavy.scans GROUP BY station) x",
    ),
    (
        "rollup of occupancies",
        true,
        "SELECT ab_box(ab_union(o, o)) FROM (SELECT ab_voxelize(solid, 0.015) AS o FROM heavy.solids WHERE id = 1) x",
    ),
    (
        "denoise, downsample, components",
        true,
        "SELECT ab_box(ab_denoise(o)), ab_box(ab_downsample(o)), (SELECT count(*) FROM ab_components(ab_change(o, o), min_voxels => 1)) FROM (SELECT ab_voxelize(solid, 0.015) AS o FROM heavy.solids WHERE id = 1) x",
    ),
    ("voxels", true, "SELECT count(*) FROM heavy.solids, ab_voxels(ab_voxelize(solid, 0.03)) WHERE id = 1"),
    (
        "slice",
        true,
        "SELECT array_length(ab_slice(ab_voxelize(solid, 0.01), 'z', 0), 1) FROM heavy.solids WHERE id = 1",
    ),
    (
        "samples",
        false,
        "SELECT count(*) FROM (SELECT ab_evidence_agg(solid, NULL, ab_evidence_model(spacing => 0.02)) AS e FROM heavy.solids WHERE id = 1) x, ab_samples(e)",
    ),
    ("union of patches", false, "SELECT ab_count(ab_union(patch)) FROM heavy.scans, generate_series(1, 40)"),
    (
        "retile",
        false,
        "SELECT count(*) FROM ab_retile((SELECT array_agg(patch) FROM heavy.scans, generate_series(1, 10)))",
    ),
    (
        "scan_agg of 2 000 000 rows",
        false,
        "SELECT array_length(ab_scan_agg(5, (i % 2000) * 0.005, (i / 2000) * 0.005, '{0,0,0}'), 1) FROM generate_series(1, 2000000) i",
    ),
    (
        "scan_agg, every row an origin",
        false,
        "SELECT array_length(ab_scan_agg(5, i * 0.001, 0, ARRAY[0, i * 0.001, 0]::float8[]), 1) FROM generate_series(1, 1000000) i",
    ),
    (
        "cloud_agg of 2 000 000 rows",
        false,
        "SELECT array_length(ab_cloud_agg(i % 1000, i / 1000, 0), 1) FROM generate_series(1, 2000000) i",
    ),
    (
        "plane_agg of 2 000 000 points",
        false,
        "SELECT ab_plane_agg(ab_point(i % 1000, i / 1000, 0, 0.001)) FROM generate_series(1, 2000000) i",
    ),
    (
        "line of an array",
        false,
        "SELECT ab_line((SELECT array_agg(ab_point(i, 0, 0, 0.001)) FROM generate_series(1, 500000) i))",
    ),
    ("beams", false, "SELECT count(*) FROM heavy.scans, generate_series(1, 3), ab_beams(patch)"),
    (
        "solid of large arrays",
        false,
        "SELECT ab_area(ab_solid(array_fill(1::float8, ARRAY[3000000, 3]), array_fill(0, ARRAY[3000000, 3])))",
    ),
    (
        "solid of a large surface",
        false,
        "SELECT ab_area(s), length(ab_as_ewkb(s)), ab_area(ab_solid_from_ewkb(ab_as_ewkb(s))) FROM (SELECT ab_solid(array_agg(ARRAY[i % 500, i / 500, 0]::float8[] ORDER BY i), (SELECT array_agg(ARRAY[j, j + 1, j + 500] ORDER BY j) FROM generate_series(0, 249498) j)) AS s FROM generate_series(0, 249999) i) x",
    ),
    ("cloud of a large array", false, "SELECT ab_cloud(array_fill(1::float8, ARRAY[5000000, 3]))"),
    (
        "scan of a large array",
        false,
        "SELECT ab_scan(ARRAY[0,0,0]::float8[], array_fill(1::float8, ARRAY[5000000, 3]))",
    ),
    ("numbers of a large array", false, "SELECT ab_point_of(array_fill(1::float8, ARRAY[40000000]))"),
    (
        "tiles",
        false,
        "SELECT count(*) FROM (SELECT ab_tiles(ab_box(-1e6, -1e6, -1e6, 1e6, 1e6, 1e6), 0.01) LIMIT 1000000) x",
    ),
    ("text of 300 MB", false, "SELECT length((left('ab_solid:1:02', 13) || repeat('00', 150000000))::ab_solid::text)"),
    ("text of 300 MB as a patch", false, "SELECT ('ab_scan:1:02' || repeat('00', 150000000))::ab_scan"),
    ("text of 300 MB as evidence", false, "SELECT ('ab_evidence:1:02' || repeat('00', 150000000))::ab_evidence"),
    ("text of 300 MB as occupancy", false, "SELECT ('ab_occupancy:1:02' || repeat('00', 150000000))::ab_occupancy"),
    ("text of 700 MB", false, "SELECT repeat('00', 350000000)::ab_change"),
    ("text of 200 MB as a box", false, "SELECT ('BOX3D(' || repeat('1 ', 100000000))::ab_box"),
    ("ewkb of 300 MB", false, "SELECT ab_area(ab_solid_from_ewkb(decode(repeat('00', 300000000), 'hex')))"),
];

/// Codes of a proper refusal: no memory, a limit, a bad argument, cancelled.
fn is_refusal(code: &str) -> bool {
    matches!(code, "53200" | "54000" | "57014") || code.starts_with("22") || code.starts_with("driver")
}

pub fn run(report: &mut Report, rng: &mut ChaCha8Rng, short: bool, seconds: f64) {
    // The short form has less of everything: the end of memory comes within a second or two.
    let ulimit_kb = if short { SMALL_KB / 3 } else { SMALL_KB };
    let mut cluster = Cluster::start("memory", ulimit_kb, "max_parallel_workers_per_gather = 0");
    let mut client = cluster.database("attack");
    client.batch_execute(TABLES).expect("the tables of the heavy calls");
    let catalogue = Catalogue::read(&mut client);
    drop(client);
    // Long enough to reach the peak; what takes longer is cancelled, and that is an answer.
    let cancel_after = Duration::from_millis(if short { 1200 } else { 20_000 });
    let mut s = Session::new(&mut cluster, report, "attack", cancel_after);
    let began = std::time::Instant::now();
    let calls = if short { 1 } else { 100 };
    for call in 0..calls {
        for heavy in HEAVY {
            one(&mut s, heavy);
            at_another_end(&mut s, rng, heavy);
        }
        if began.elapsed().as_secs_f64() > seconds && !short {
            println!("attack: memory: {} of {calls} calls of each heavy function in the time given", call + 1);
            break;
        }
    }
    huge_binary(&mut s, &catalogue, if short { 32 << 20 } else { 700 << 20 });
    let limits: &[u64] = if short { &[64] } else { &[64, 128, 256] };
    for &limit in limits {
        for heavy in HEAVY.iter().filter(|h| h.1) {
            measured(&mut s, &catalogue, heavy, limit);
        }
    }
}

/// The call again where memory ends elsewhere: which allocation is the one refused depends on that alone.
fn at_another_end(s: &mut Session, rng: &mut ChaCha8Rng, heavy: &(&str, bool, &str)) {
    s.set_up("LOAD '$libdir/asbuilt'");
    // As often below what the ballast takes as above it.
    let megabytes = 2f64.powf(rng.random_range(2.0..9.0));
    s.leave_memory((megabytes * 1048576.0) as u64);
    one(s, heavy);
    s.set_up("");
}

fn one(s: &mut Session, (name, _, sql): &(&str, bool, &str)) {
    let began = std::time::Instant::now();
    let answer = s.query(name, sql, &[]);
    if shows_times() {
        println!("{:>6.2} s {name}: {:?}", began.elapsed().as_secs_f64(), answer.as_ref().map(|r| r.len()));
    }
    match answer {
        Err(Fault::State(code)) if code.starts_with("42") => {
            s.report.finding(
                Kind::Stale,
                name,
                sql,
                &format!("{code}: the call is gone; mend tests/attack/src/memory.rs"),
            );
        }
        Err(Fault::State(code)) if !is_refusal(&code) => {
            s.report.finding(Kind::Wrong, name, sql, &format!("neither an answer nor 53200 or 54000, but {code}"));
        }
        _ => {}
    }
    if !s.others_live() {
        s.report.finding(Kind::Crash, &format!("{name}, others"), sql, "another session does not answer");
    }
}

/// Whether the calls are to be printed one by one.
fn shows_times() -> bool {
    std::env::var("ATTACK_SHOW").is_ok_and(|c| c == "times")
}

/// A field of hundreds of megabytes in binary COPY, for every type, its first byte that of a layout that may be.
fn huge_binary(s: &mut Session, catalogue: &Catalogue, bytes: usize) {
    let mut stream = b"PGCOPY\n\xff\r\n\0\0\0\0\0\0\0\0\0\0\x01".to_vec();
    stream.extend((bytes as u32).to_be_bytes());
    stream.resize(stream.len() + bytes, 0);
    stream.extend((-1i16).to_be_bytes());
    for t in &catalogue.types {
        let key = format!("binary form of {} MB as {}", bytes >> 20, t.name);
        let table = format!("heavy.huge_{}", t.plain);
        let _ = s.execute(&key, &format!("CREATE TABLE IF NOT EXISTS {table} (v {})", t.name));
        let sql = format!("COPY {table} FROM STDIN (FORMAT binary)");
        for front in [0, 1, 2] {
            stream[25] = front;
            match s.copy_in(&key, &sql, &stream) {
                Err(Fault::State(code)) if !is_refusal(&code) => {
                    s.report.finding(Kind::Wrong, &key, &sql, &format!("refused by {code}"));
                }
                _ => {}
            }
        }
    }
}

/// One call with all limits set: the most that the backend took of its own.
fn measured(s: &mut Session, catalogue: &Catalogue, (name, _, sql): &(&str, bool, &str), limit_mb: u64) {
    let settings: Vec<String> = catalogue.limits.iter().map(|l| format!("SET {l} = '{limit_mb}MB'")).collect();
    s.set_up(&format!("LOAD '$libdir/asbuilt'; {}", settings.join("; ")));
    let pid = s.pid();
    let key = format!("{name} within limits");
    let result = s.query(&key, sql, &[]);
    let Some(peak) = private_peak_mb(pid) else { return };
    if shows_times() {
        println!("{peak:>6} MB with limits of {limit_mb} MB {name}: {:?}", result.as_ref().map(|r| r.len()));
    }
    let most = limit_mb * 11 / 10 + 64;
    if result != Err(Fault::Lost) && peak > most {
        let detail = format!("{peak} MB with limits of {limit_mb} MB; at most {most} are promised");
        s.report.finding(Kind::OverLimit, name, &format!("{}; {sql}", settings.join("; ")), &detail);
    }
}

/// The high-water mark of a backend, minus what it shares with others (shared buffers, the files of the programs).
fn private_peak_mb(pid: i32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).ok()?;
    let kb = |name: &str| {
        let line = status.lines().find(|l| l.starts_with(name))?;
        line.split_whitespace().nth(1)?.parse::<u64>().ok()
    };
    Some(kb("VmHWM")?.saturating_sub(kb("RssFile")? + kb("RssShmem")?) / 1024)
}
