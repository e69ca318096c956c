//! Damaged files of every format against the loader: it loads them, or says why not and leaves nothing behind; it is
//! not killed, does not panic, ends in time, and shows no control characters.

use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use postgres::Client;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::cluster::{AMPLE_KB, Cluster, root};
use crate::mutate;
use crate::report::{Kind, Report, shortened};
use crate::seeds;

/// A program that runs longer than this on a file of some kilobytes hangs. Meshing is bounded by an option of its own.
const PATIENCE_S: u64 = 20;

/// The program: of ASBUILT, else of this project.
pub fn program() -> PathBuf {
    std::env::var("ASBUILT").map_or_else(|_| root().join("target/release/asbuilt"), PathBuf::from)
}

struct Loader {
    cluster: Cluster,
    client: Client,
    folder: PathBuf,
}

pub fn run(report: &mut Report, rng: &mut ChaCha8Rng, short: bool, seconds: f64) {
    let cluster = Cluster::start("files", AMPLE_KB, "");
    cluster.connect("postgres").batch_execute("CREATE DATABASE files").unwrap();
    let client = cluster.connect("files");
    let folder = cluster.socket_dir().join("files");
    std::fs::create_dir_all(&folder).unwrap();
    let seeds = seeds::write(&folder);
    let mut loader = Loader { cluster, client, folder };
    for seed in &seeds {
        loader.whole(report, seed);
    }
    for file in crafted(&loader.folder, &seeds) {
        loader.load(report, &file, &[]);
    }
    let mut victims = seeds.clone();
    if !short {
        let field = root().join("../shared/data/field");
        let found = std::fs::read_dir(&field).into_iter().flatten().flatten().map(|e| e.path()).filter(|p| is_small(p));
        victims.extend(found);
        victims.sort();
        for file in victims.iter().filter(|v| !seeds.contains(v)) {
            loader.load(report, file, &[]);
        }
    }
    let began = Instant::now();
    for round in 0.. {
        for victim in &victims {
            loader.damaged(report, rng, victim);
        }
        // The short form: the formats whose readers are crates of others get their share, all within seconds.
        if if short { round == 4 } else { began.elapsed().as_secs_f64() > seconds } {
            break;
        }
    }
}

/// Files whose counts promise more than they hold: what is believed before it is counted takes all memory.
fn crafted(folder: &Path, seeds: &[PathBuf]) -> Vec<PathBuf> {
    let read =
        |name: &str| seeds.iter().find(|s| s.ends_with(name)).and_then(|s| std::fs::read(s).ok()).unwrap_or_default();
    let words =
        |name: &str, from: &str, to: &str| String::from_utf8_lossy(&read(name)).replacen(from, to, 1).into_bytes();
    let number = |name: &str, at: &dyn Fn(&[u8]) -> usize, n: u32| {
        let mut b = read(name);
        let at = at(&b);
        if let Some(slot) = b.get_mut(at..at + 4) {
            slot.copy_from_slice(&n.to_le_bytes());
        }
        b
    };
    // The chunk table: its place stands where the points begin; there a version, then the count.
    let chunks = |b: &[u8]| {
        let u32_at = |at: usize| b.get(at..at + 4).map_or(0, |s| u32::from_le_bytes(s.try_into().unwrap())) as usize;
        u32_at(u32_at(96)) + 4
    };
    let all = [
        ("grid.ptx", words("seed.ptx", "10\n10\n", "1000000\n4000\n")),
        ("vertices.ply", words("ascii.ply", "vertex 100", "vertex 4294967295")),
        ("points.pcd", words("ascii.pcd", "POINTS 100", "POINTS 4294967295")),
        ("width.pcd", words("ascii.pcd", "WIDTH 100", "WIDTH 4294967295")),
        ("count.pts", words("seed.pts", "100\n", "4294967295\n")),
        ("count.las", number("seed.las", &|_| 107, u32::MAX)),
        ("count64.las", number("extended.las", &|_| 251, 0x7fff_ffff)),
        ("chunks.laz", number("seed.laz", &chunks, 0x7fff_ffff)),
        ("chunks64.laz", number("extended.laz", &chunks, 0x0fff_ffff)),
    ];
    let write = |(name, bytes): (&str, Vec<u8>)| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).expect("a crafted file");
        path
    };
    all.map(write).into()
}

fn is_small(path: &Path) -> bool {
    path.metadata().is_ok_and(|m| m.is_file() && m.len() < 2 << 20) && path.extension().is_some_and(|e| e != "md")
}

/// Files for others that run the program: a model, a scan with its origin, one without.
pub fn for_hijack(folder: &Path) -> Vec<String> {
    let files = seeds::write(folder);
    let of = |name: &str| files.iter().find(|f| f.ends_with(name)).map(|f| f.display().to_string());
    ["wall.ifc", "seed.e57", "seed.xyz"].into_iter().filter_map(of).collect()
}

impl Loader {
    /// An undamaged seed must load.
    fn whole(&mut self, report: &mut Report, seed: &Path) {
        if !self.load(report, seed, &[]) {
            report.finding(
                Kind::Stale,
                &format!("seed {}", seed.display()),
                &seed.display().to_string(),
                "a valid file is refused",
            );
        }
    }

    fn damaged(&mut self, report: &mut Report, rng: &mut ChaCha8Rng, seed: &Path) {
        let bytes = std::fs::read(seed).unwrap_or_default();
        let ending = seed.extension().unwrap_or_default().to_string_lossy().into_owned();
        let damaged = if rng.random_bool(0.3) { text_damage(rng, &bytes) } else { mutate::bytes(rng, &bytes, &bytes) };
        let damaged = if ending == "e57" && rng.random_bool(0.7) { with_page_checksums(damaged) } else { damaged };
        let path = self.folder.join(format!("damaged.{ending}"));
        std::fs::write(&path, damaged).expect("a damaged file");
        let options: &[&str] = match rng.random_range(0..5) {
            0 => &[],
            1 => &["--origin", "0,0,0"],
            2 => &["--origins", "recover"],
            3 => &["--origins", "none", "--intensity"],
            _ => &["--origin", "0,0,0", "--intensity", "--colour"],
        };
        self.load(report, &path, options);
    }

    /// Loads under a bound of time and memory; whether it was loaded.
    fn load(&mut self, report: &mut Report, file: &Path, options: &[&str]) -> bool {
        let before = rows(&mut self.client);
        let line = format!("ulimit -c 0; ulimit -v {AMPLE_KB}; exec timeout -k 2 {PATIENCE_S} \"$@\"");
        let began = Instant::now();
        let out = Command::new("bash")
            .args(["-c", &line, "load"])
            .arg(program())
            .arg("load")
            .arg(file)
            .args(["--mesh-timeout", "4"])
            .args(options)
            .env("PGHOST", self.cluster.socket_dir())
            .env("PGUSER", "postgres")
            .env("PGDATABASE", "files")
            .env("RUST_BACKTRACE", "0")
            .output()
            .expect("the program runs");
        report.executed(1);
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        let code = out.status.code().unwrap_or_else(|| 128 + out.status.signal().unwrap_or(0));
        report.error(&format!("exit {code}"));
        self.judge(report, file, options, code, &said, began.elapsed());
        if code != 0 && rows(&mut self.client) != before {
            let detail = format!("{before:?} before, {:?} after: {said}", rows(&mut self.client));
            report.finding(Kind::Partial, &format!("partial {}", ending(file)), &kept(file), &detail);
        }
        code == 0
    }

    fn judge(&mut self, report: &mut Report, file: &Path, options: &[&str], code: i32, said: &str, time: Duration) {
        let how = format!("asbuilt load {} {}", file.display(), options.join(" "));
        let mut found = |kind: Kind, what: &str| {
            // The panic's place tells one cause from another.
            let place =
                said.lines().find(|l| l.contains("panicked at") || l.contains("memory allocation")).unwrap_or(what);
            let place: String = place.chars().filter(|c| !c.is_ascii_digit()).collect();
            let detail = format!("{what}, {:.1} s: {said}", time.as_secs_f64());
            report.finding(
                kind,
                &format!("{} {}", ending(file), shortened(&place, 90)),
                &format!("{how} -- {}", kept(file)),
                &detail,
            );
        };
        match code {
            124 | 137 => found(Kind::Hang, "does not end"),
            101 => found(Kind::Crash, "a panic ends it"),
            128.. => found(Kind::Crash, &format!("killed by signal {}", code - 128)),
            _ if said.contains("panicked at") => found(Kind::Crash, "a panic is shown"),
            _ if said.contains("memory allocation of") => found(Kind::Crash, "a child aborts for memory"),
            _ => {}
        }
        if said.chars().any(is_hostile) {
            found(Kind::Wrong, "control characters of the file reach the terminal");
        }
    }
}

/// Characters that a terminal obeys instead of showing: controls, and those that turn the direction of writing.
fn is_hostile(c: char) -> bool {
    (c.is_control() && c != '\n' && c != '\t')
        || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}')
}

fn ending(file: &Path) -> String {
    file.extension().unwrap_or_default().to_string_lossy().into_owned()
}

/// Copies a file beside the findings, where it stays.
fn kept(file: &Path) -> String {
    let bytes = std::fs::read(file).unwrap_or_default();
    let sum = bytes.iter().fold(0xcbf2_9ce4_8422_2325u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3));
    let to = root().join(format!("target/attack/findings/{sum:016x}.{}", ending(file)));
    let _ = std::fs::write(&to, bytes);
    to.display().to_string()
}

/// Rows of every table of the database.
fn rows(client: &mut Client) -> Vec<(String, i64)> {
    let tables = "SELECT oid::regclass::text FROM pg_class WHERE relkind = 'r' AND relnamespace = 'public'::regnamespace ORDER BY 1";
    let names: Vec<String> = client.query(tables, &[]).expect("tables").iter().map(|r| r.get(0)).collect();
    let mut count =
        |name: &String| client.query_one(&format!("SELECT count(*) FROM {name}"), &[]).expect("rows").get(0);
    names.iter().map(|n| (n.clone(), count(n))).filter(|(_, n)| *n > 0).collect()
}

/// Damage to words: numbers of headers blown up, hostile names.
fn text_damage(rng: &mut ChaCha8Rng, bytes: &[u8]) -> Vec<u8> {
    const WORDS: [&str; 12] = [
        "4294967295",
        "-1",
        "1e308",
        "nan",
        "99999999999999999999",
        "0",
        "\u{1b}[2J\u{202e}",
        "'; DROP TABLE scan; --",
        "",
        "\n",
        "#1",
        "((((((((",
    ];
    let mut out = bytes.to_vec();
    for _ in 0..rng.random_range(1..=3) {
        if out.is_empty() {
            break;
        }
        let most = if rng.random_bool(0.6) { out.len().min(400) } else { out.len() };
        let from = rng.random_range(0..most);
        let is_word = |b: &u8| b.is_ascii_alphanumeric() || *b == b'.' || *b == b'-';
        let begin = out[..from].iter().rposition(|b| !is_word(b)).map_or(0, |p| p + 1);
        let end = out[from..].iter().position(|b| !is_word(b)).map_or(out.len(), |p| from + p);
        out.splice(begin..end.max(begin), WORDS[rng.random_range(0..WORDS.len())].bytes());
    }
    out
}

/// E57 guards every page of 1024 bytes by a CRC-32C: damage gets past it only with the sums set right.
fn with_page_checksums(mut bytes: Vec<u8>) -> Vec<u8> {
    for page in bytes.chunks_exact_mut(1024) {
        let sum = crc32c(&page[..1020]);
        page[1020..].copy_from_slice(&sum.to_be_bytes());
    }
    bytes
}

fn crc32c(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _: u32| if crc & 1 == 1 { crc >> 1 ^ 0x82f6_3b78 } else { crc >> 1 };
    !bytes.iter().fold(!0u32, |crc, b| (0..8).fold(crc ^ u32::from(*b), step))
}
