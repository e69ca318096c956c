//! How much memory this process holds.

/// How the meshing process ends where a product takes too much memory.
pub const TOO_MUCH_MEMORY: i32 = 75;

/// Bytes in memory; 0 where the system does not tell.
pub fn resident() -> u64 {
    const PAGE: u64 = 4096;
    let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    text.split_whitespace().nth(1).and_then(|n| n.parse::<u64>().ok()).unwrap_or(0) * PAGE
}
