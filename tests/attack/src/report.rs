//! What was tried, what came back, what must not have come back.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// What the extension or the program must never do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A process was killed by a signal, or panicked.
    Crash,
    /// A statement that cancel did not end within 5 s, or a program that did not end.
    Hang,
    /// SQLSTATE of class XX: an error that nobody foresaw.
    Internal,
    /// A Rust backtrace or a source path of the server shown to a client.
    Backtrace,
    /// Memory above the limit that was set.
    OverLimit,
    /// Rows left behind by a load that failed.
    Partial,
    /// A value that changed on its way, or an index whose answer differs from the table's.
    Wrong,
    /// Code of another role ran.
    Hijack,
    /// The harness itself is out of date: a call that it names is gone.
    Stale,
}

const KINDS: [(Kind, &str); 9] = [
    (Kind::Crash, "crashes"),
    (Kind::Hang, "hangs"),
    (Kind::Internal, "XX"),
    (Kind::Backtrace, "traces"),
    (Kind::OverLimit, "limit"),
    (Kind::Partial, "partial"),
    (Kind::Wrong, "wrong"),
    (Kind::Hijack, "hijack"),
    (Kind::Stale, "stale"),
];

/// Findings of a kind that are printed; all of them are kept in files.
const MAX_SHOWN: usize = 12;

/// Counts of one piece.
#[derive(Default)]
struct Tally {
    executions: u64,
    errors: BTreeMap<String, u64>,
    findings: BTreeMap<Kind, u64>,
    time: Duration,
}

pub struct Report {
    pub seed: u64,
    folder: PathBuf,
    tallies: Vec<(&'static str, Tally)>,
    seen: BTreeSet<(Kind, String)>,
    /// A line for each of `seen`, told once more at the end: of a long log often only the end is kept.
    lines: Vec<String>,
    started: Instant,
    /// The longest time from a cancel to the end of its statement.
    pub slowest_cancel: Duration,
}

impl Report {
    pub fn new(seed: u64, folder: PathBuf) -> Self {
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("a folder for the findings");
        let started = Instant::now();
        Self {
            seed,
            folder,
            tallies: vec![],
            seen: BTreeSet::new(),
            lines: vec![],
            started,
            slowest_cancel: Duration::ZERO,
        }
    }

    /// Opens the account of a piece; what follows is recorded there.
    pub fn begin(&mut self, piece: &'static str) {
        self.tallies.push((piece, Tally::default()));
        self.started = Instant::now();
    }

    pub fn end(&mut self) {
        let time = self.started.elapsed();
        self.tally().time = time;
        let (piece, tally) = self.tallies.last().unwrap();
        println!("attack: {piece}: {} executions in {:.1} s", tally.executions, time.as_secs_f64());
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tallies.last_mut().expect("a piece has begun").1
    }

    pub fn executed(&mut self, n: u64) {
        self.tally().executions += n;
    }

    pub fn error(&mut self, sqlstate: &str) {
        *self.tally().errors.entry(sqlstate.into()).or_default() += 1;
    }

    /// Whether a finding of this kind and key is known: meeting it again would only cost a restart of the server.
    pub fn has(&self, kind: Kind, key: &str) -> bool {
        self.seen.contains(&(kind, key.to_string()))
    }

    /// Counts a finding; prints it and keeps it whole in a file when it is the first of its key.
    pub fn finding(&mut self, kind: Kind, key: &str, statement: &str, detail: &str) {
        *self.tally().findings.entry(kind).or_default() += 1;
        if !self.seen.insert((kind, key.to_string())) {
            return;
        }
        let piece = self.tallies.last().unwrap().0;
        let file = self.folder.join(format!("{:03}-{piece}-{kind:?}.sql", self.seen.len()));
        let seed = self.seed;
        let whole = format!("-- {kind:?} [{key}] piece {piece}, seed {seed}\n-- {}\n{statement}\n", one_line(detail));
        let _ = std::fs::write(&file, whole);
        let line = format!("FINDING {kind:?} in {piece} [{key}], seed {seed}: {}", shortened(detail, 400));
        self.lines.push(line.clone());
        let n = self.seen.iter().filter(|(k, _)| *k == kind).count();
        if n > MAX_SHOWN {
            if n == MAX_SHOWN + 1 {
                println!("    … further {kind:?} findings only in {}", self.folder.display());
            }
            return;
        }
        println!("{line}");
        println!("    {}", shortened(statement, 700));
        println!("    whole: {}", file.display());
    }

    /// The table of counts; whether nothing was found.
    pub fn print(&self) -> bool {
        println!("\n{:<12} {:>10} {:>7}", "piece", "executions", "s");
        for (piece, t) in &self.tallies {
            print!("{piece:<12} {:>10} {:>7.1} ", t.executions, t.time.as_secs_f64());
            for (kind, name) in KINDS {
                print!(" {name} {}", t.findings.get(&kind).unwrap_or(&0));
            }
            let errors: Vec<String> = t.errors.iter().map(|(code, n)| format!("{code}×{n}")).collect();
            println!("\n{:<12} errors: {}", "", if errors.is_empty() { "none".into() } else { errors.join(" ") });
        }
        let executions: u64 = self.tallies.iter().map(|(_, t)| t.executions).sum();
        let time: f64 = self.tallies.iter().map(|(_, t)| t.time.as_secs_f64()).sum();
        let found: u64 = self.tallies.iter().flat_map(|(_, t)| t.findings.values()).sum();
        println!(
            "sum: {executions} executions in {:.1} minutes, seed {}, {found} findings ({} distinct), slowest cancel {} ms",
            time / 60.0,
            self.seed,
            self.seen.len(),
            self.slowest_cancel.as_millis()
        );
        for line in self.lines.iter().take(MAX_SHOWN) {
            println!("{line}");
        }
        found == 0
    }
}

fn one_line(text: &str) -> String {
    text.replace('\n', " | ")
}

/// At most `most` characters, with what no terminal should see made visible.
pub fn shortened(text: &str, most: usize) -> String {
    let clean: String = text.chars().map(|c| if c.is_control() { '·' } else { c }).take(most).collect();
    if text.chars().count() > most { format!("{clean}… ({} characters)", text.chars().count()) } else { clean }
}
