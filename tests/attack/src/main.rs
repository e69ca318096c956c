//! `make attack`: everything that a hostile client, file or user can send, against a private server.
//!
//! What is called comes from the server's catalogue, so that new SQL objects are attacked without anyone remembering.
//! The short form runs a fixed number of rounds from a fixed seed; the long form repeats until its minutes are over, each
//! round from a seed of its own that is printed.

mod aggregates;
mod catalogue;
mod cluster;
mod ewkb;
mod files;
mod functions;
mod fuzz;
mod hijack;
mod indexes;
mod memory;
mod mutate;
mod replication;
mod report;
mod seeds;
mod session;
mod types;
mod values;
mod watch;

use std::time::{Duration, Instant};

use catalogue::Catalogue;
use cluster::{AMPLE_KB, Cluster};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use report::{Kind, Report};
use session::Session;
use values::Pool;

/// Seed of the short form: it repeats.
const FIXED_SEED: u64 = 14;

pub struct Plan {
    short: bool,
    seed: u64,
    minutes: f64,
    only: Option<Vec<String>>,
}

impl Plan {
    fn from_arguments() -> Self {
        let mut plan = Self { short: false, seed: FIXED_SEED, minutes: 30.0, only: None };
        let number = |name: &str| std::env::var(name).ok().and_then(|v| v.parse::<f64>().ok());
        plan.minutes = number("MINUTES").unwrap_or(plan.minutes);
        let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(1, |d| d.as_secs());
        let mut seed = number("SEED").map(|s| s as u64);
        for argument in std::env::args().skip(1) {
            match argument.split_once('=') {
                None if argument == "--short" => plan.short = true,
                Some(("--seed", s)) => seed = Some(s.parse().expect("a seed")),
                Some(("--minutes", m)) => plan.minutes = m.parse().expect("minutes"),
                Some(("--only", pieces)) => plan.only = Some(pieces.split(',').map(String::from).collect()),
                _ => panic!("unknown argument {argument}: --short --seed=N --minutes=N --only=PIECE,PIECE"),
            }
        }
        plan.seed = seed.unwrap_or(if plan.short { FIXED_SEED } else { now });
        plan
    }

    fn wants(&self, piece: &str) -> bool {
        self.only.as_ref().is_none_or(|o| o.iter().any(|p| p == piece))
    }

    /// A random generator for each piece, so that a piece run alone repeats what it did among the others.
    fn rng(&self, piece: &str, round: u64) -> ChaCha8Rng {
        let name = piece.bytes().fold(0u64, |h, b| h.wrapping_mul(31).wrapping_add(u64::from(b)));
        ChaCha8Rng::seed_from_u64(self.seed.wrapping_add(round.wrapping_mul(1_000_003)) ^ name.rotate_left(32))
    }

    fn seconds(&self, piece: &str) -> f64 {
        SHARES.iter().find(|s| s.0 == piece).map_or(0.0, |s| s.1 * self.minutes * 60.0)
    }

    fn cancel_after(&self) -> Duration {
        Duration::from_secs(if self.short { 2 } else { 5 })
    }
}

/// Shares of the minutes of the long form; what is not named makes one pass.
const SHARES: [(&str, f64); 8] = [
    ("types", 0.12),
    ("functions", 0.22),
    ("aggregates", 0.06),
    ("parallel", 0.04),
    ("indexes", 0.04),
    ("memory", 0.18),
    ("files", 0.12),
    ("fuzz", 0.18),
];

fn main() {
    let plan = Plan::from_arguments();
    let form = if plan.short { "short form".into() } else { format!("{} minutes", plan.minutes) };
    println!("attack: {form}, seed {}", plan.seed);
    let mut report = Report::new(plan.seed, cluster::root().join("target/attack/findings"));
    through_sql(&plan, &mut report);
    piece(&plan, &mut report, "memory", |r| {
        memory::run(r, &mut plan.rng("memory", 0), plan.short, plan.seconds("memory"))
    });
    piece(&plan, &mut report, "hijack", hijack::run);
    piece(&plan, &mut report, "files", |r| files::run(r, &mut plan.rng("files", 0), plan.short, plan.seconds("files")));
    piece(&plan, &mut report, "fuzz", |r| fuzz::run(r, plan.short, plan.seconds("fuzz")));
    let clean = report.print();
    std::process::exit(i32::from(!clean));
}

fn piece(plan: &Plan, report: &mut Report, name: &'static str, run: impl FnOnce(&mut Report)) {
    if plan.wants(name) {
        report.begin(name);
        run(report);
        report.end();
    }
}

/// Types, functions, aggregates, indexes, replication: one server, rounds until the time is over.
fn through_sql(plan: &Plan, report: &mut Report) {
    let pieces = ["types", "functions", "aggregates", "parallel", "indexes", "replication"];
    if !pieces.iter().any(|p| plan.wants(p)) {
        return;
    }
    let mut cluster = Cluster::start("sql", AMPLE_KB, replication::PUBLISHER);
    let catalogue = Catalogue::read(&mut cluster.database("attack"));
    println!(
        "attack: {} functions and aggregates, {} types, {} operators, {} operator classes",
        catalogue.functions.len(),
        catalogue.types.len(),
        catalogue.operators.len(),
        catalogue.opclasses.len()
    );
    report.begin("values");
    let mut s = Session::new(&mut cluster, report, "attack", plan.cancel_after());
    let mut pool = Pool::make(&mut s, &catalogue, &mut plan.rng("values", 0));
    types::declare(&mut s, &catalogue);
    s.report.end();
    for piece in pieces.into_iter().filter(|p| plan.wants(p)) {
        s.report.begin(piece);
        let began = Instant::now();
        for round in 0.. {
            one_round(piece, &mut s, &catalogue, &mut pool, &mut plan.rng(piece, round));
            if plan.short || began.elapsed().as_secs_f64() > plan.seconds(piece) {
                break;
            }
        }
        s.report.end();
    }
    // What nobody waited for: workers, the checkpointer.
    let log = s.cluster.new_log();
    for death in cluster::deaths(&log) {
        s.report.finding(Kind::Crash, "server log", "-- see the log", &death);
    }
}

fn one_round(piece: &str, s: &mut Session, catalogue: &Catalogue, pool: &mut Pool, rng: &mut ChaCha8Rng) {
    match piece {
        "types" => types::run(s, catalogue, pool, rng, 40),
        "functions" => functions::run(s, catalogue, pool, rng, 16),
        "aggregates" => aggregates::run(s, catalogue, pool, rng, 40),
        "parallel" => aggregates::run_parallel(s, catalogue, pool, rng, 1),
        "replication" => replication::run(s, catalogue),
        _ => indexes::run(s, catalogue, pool, rng, 3),
    }
}
