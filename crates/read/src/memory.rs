//! A memory budget for the processes that read files: beyond it an allocation fails in that process, instead of
//! exhausting the machine.

use anyhow::Result;

/// The least that a reader can work with, bytes.
const MIN_BUDGET: u64 = 64 << 20;

/// Three quarters of the machine's memory, or of what its container may use; where neither is known, 4 GB.
pub fn budget() -> u64 {
    let text = |path: &str| std::fs::read_to_string(path).ok();
    let machine = text("/proc/meminfo").and_then(|t| {
        let line = t.lines().find_map(|l| l.strip_prefix("MemTotal:").map(ToOwned::to_owned))?;
        line.split_whitespace().next()?.parse::<u64>().ok().map(|kib| kib << 10)
    });
    let container = text("/sys/fs/cgroup/memory.max").and_then(|t| t.trim().parse::<u64>().ok());
    let most = machine.into_iter().chain(container).min().unwrap_or(4 << 30);
    (most / 4 * 3).max(MIN_BUDGET)
}

/// `512MB`, `4GB`: a number with a unit that is a power of 1024, as in PostgreSQL.
pub fn parse(text: &str) -> std::result::Result<u64, String> {
    let (number, unit) = text.split_at(text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len()));
    let shift = match unit.trim().to_ascii_lowercase().as_str() {
        "kb" => 10,
        "mb" => 20,
        "gb" => 30,
        "tb" => 40,
        _ => return Err(format!("\"{text}\" is no size of memory; write 512MB or 4GB")),
    };
    let bytes = number.parse::<u64>().ok().and_then(|n| n.checked_mul(1 << shift));
    let bytes = bytes.filter(|&b| b <= i64::MAX as u64).ok_or_else(|| format!("\"{text}\" is no size of memory"))?;
    if bytes < MIN_BUDGET { Err(format!("{text} is too little to read with; at least 64MB")) } else { Ok(bytes) }
}

/// Bytes as people write them.
pub fn shown(bytes: u64) -> String {
    if bytes >= 10 << 30 { format!("{} GB", bytes >> 30) } else { format!("{} MB", bytes >> 20) }
}

/// Limits this process to this much from here on.
#[cfg(unix)]
pub fn limit(bytes: u64) -> Result<()> {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    // Linux counts what can be written; elsewhere the address space, with some room for what is only reserved.
    let (resource, most) =
        if cfg!(target_os = "linux") { (Resource::Data, bytes) } else { (Resource::As, bytes.saturating_add(4 << 30)) };
    let now = getrlimit(resource);
    let least = |limit: Option<u64>| Some(limit.map_or(most, |l| l.min(most)));
    setrlimit(resource, Rlimit { current: least(now.current), maximum: now.maximum })?;
    // Where it ends, it ends as meant: without a file of its memory.
    setrlimit(Resource::Core, Rlimit { current: Some(0), maximum: getrlimit(Resource::Core).maximum })?;
    Ok(())
}

#[cfg(not(unix))]
pub fn limit(_: u64) -> Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(parse("512MB"), Ok(512 << 20));
        assert_eq!(parse("4 GB"), Ok(4 << 30));
        for wrong in ["", "4", "GB", "1kB", "-1GB", "99999999999TB"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
        assert!(budget() >= MIN_BUDGET);
    }
}
