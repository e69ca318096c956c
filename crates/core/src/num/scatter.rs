//! Places spread over a list.

/// At most `wanted` of `len` places, scattered so that no period appears in them (Fibonacci hashing, Knuth 1973, 6.4).
pub fn scattered(len: usize, wanted: usize) -> impl Iterator<Item = usize> {
    let every = (len as f64 / wanted as f64).max(1.0);
    let count = len.min(wanted);
    (0..count).map(move |i| {
        let jitter = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        let within = if every > 1.0 { jitter as f64 / (1u64 << 24) as f64 } else { 0.0 };
        (((i as f64 + within) * every) as usize).min(len - 1)
    })
}
