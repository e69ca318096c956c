//! Coverage-guided fuzzing of the decoders (tests/fuzz), and the replay of the corpus that is kept.

use std::path::PathBuf;
use std::process::Command;

use asbuilt_fuzz_targets::End;

use crate::cluster::root;
use crate::report::{Kind, Report};

/// The passes that libFuzzer listens to, with the stable compiler.
const FLAGS: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 -Cdebug-assertions=on -Coverflow-checks=on";

fn crate_dir() -> PathBuf {
    root().join("tests/fuzz")
}

pub fn run(report: &mut Report, short: bool, seconds: f64) {
    replay(report);
    if short {
        return;
    }
    match build() {
        Ok(()) => targets().iter().for_each(|t| one(report, t, seconds / targets().len() as f64)),
        Err(why) => println!("SKIPPED: no coverage-guided fuzzing, the corpus alone was replayed: {why}"),
    }
}

/// Every kept input through its target, in this process: a panic is a finding, and so is what takes too long.
fn replay(report: &mut Report) {
    for target in asbuilt_fuzz_targets::TARGETS {
        let folder = crate_dir().join("corpus").join(target.name);
        let mut files: Vec<PathBuf> =
            std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()).collect();
        files.sort();
        for file in files {
            report.executed(1);
            let key = format!("fuzz {}", target.name);
            let shown = file.display().to_string();
            match asbuilt_fuzz_targets::replay(target, std::fs::read(&file).unwrap_or_default()) {
                End::Survived => {}
                End::Panicked => report.finding(Kind::Crash, &key, &shown, "a kept input panics"),
                End::Hung => report.finding(Kind::Hang, &key, &shown, "a kept input takes more than 5 s"),
            }
        }
    }
}

fn targets() -> Vec<&'static str> {
    asbuilt_fuzz_targets::TARGETS.iter().map(|t| t.name).collect()
}

fn build() -> Result<(), String> {
    let out = Command::new("cargo")
        .args(["build", "--release", "--quiet", "--target", "x86_64-unknown-linux-gnu"])
        .current_dir(crate_dir().join("libfuzzer"))
        .env("CARGO_TARGET_DIR", root().join("target/fuzz"))
        .env("RUSTFLAGS", FLAGS)
        .output()
        .map_err(|e| e.to_string())?;
    if out.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&out.stderr).into_owned()) }
}

/// libFuzzer for its seconds, on a growing corpus under target/, from the kept one and the seeds.
fn one(report: &mut Report, target: &str, seconds: f64) {
    let work = root().join("target/attack/fuzz").join(target);
    let kept = crate_dir().join("corpus").join(target);
    std::fs::create_dir_all(&work).expect("a folder for the corpus");
    std::fs::create_dir_all(&kept).expect("the corpus");
    for (i, seed) in asbuilt_fuzz_targets::seeds(target).iter().enumerate() {
        std::fs::write(work.join(format!("seed-{i}")), seed).expect("a seed");
    }
    let artifacts = root().join("target/attack/findings").join(format!("fuzz-{target}-"));
    // Through a shell that forks: Linux counts the peak of who calls exec as that of the program called, and libFuzzer
    // would take ours for its own.
    let out = Command::new("sh")
        .args(["-c", "\"$@\"; exit $?", "sh"])
        .arg(root().join("target/fuzz/x86_64-unknown-linux-gnu/release/fuzz"))
        .arg(format!("-max_total_time={}", seconds.max(1.0) as u64))
        .args(["-timeout=5", "-rss_limit_mb=2048", "-malloc_limit_mb=1024", "-max_len=65536"])
        .args(["-print_final_stats=1", "-use_value_profile=1"])
        .arg(format!("-seed={}", report.seed % u64::from(u32::MAX)))
        .arg(format!("-artifact_prefix={}", artifacts.display()))
        .args([&work, &kept])
        .env("ASBUILT_FUZZ_TARGET", target)
        .output()
        .expect("the fuzzer runs");
    judge(report, target, &String::from_utf8_lossy(&out.stderr), out.status.success());
}

fn judge(report: &mut Report, target: &str, said: &str, success: bool) {
    let stat = said.lines().find_map(|l| l.strip_prefix("stat::number_of_executed_units:"));
    let executed = stat.and_then(|n| n.trim().parse().ok()).unwrap_or(0);
    let covered = said.lines().rev().find(|l| l.contains(" cov: ")).unwrap_or("no coverage").trim();
    report.executed(executed);
    println!("attack: fuzz {target}: {executed} inputs; {covered}");
    if success {
        return;
    }
    let kind = if said.contains("timeout after") { Kind::Hang } else { Kind::Crash };
    let file = said.lines().find(|l| l.contains("Test unit written to")).unwrap_or("no input was written");
    let is_cause = |l: &&str| ["panicked at", "ERROR: libFuzzer", "out-of-memory"].iter().any(|c| l.contains(c));
    let why: Vec<&str> = said.lines().filter(is_cause).collect();
    report.finding(kind, &format!("fuzz {target}"), file, &why.join("; "));
}
