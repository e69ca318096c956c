//! Damage to bytes and to text: flips, cuts, lengths blown up, pieces of others.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// Unexpected numbers for counts and lengths.
const WORDS: [u32; 10] = [0, 1, 0x7f, 0xff, 0xffff, 0x10000, 0x7fff_ffff, 0x8000_0000, 0xffff_fffe, 0xffff_ffff];
/// Unexpected numbers for coordinates.
const FLOATS: [f64; 9] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 5e-324, 1e308, -1e308, 1e-300, 9.007_199_254_740_993e15];

/// One to three kinds of damage; `other` lends its bytes.
pub fn bytes(rng: &mut ChaCha8Rng, valid: &[u8], other: &[u8]) -> Vec<u8> {
    let mut b = valid.to_vec();
    for _ in 0..rng.random_range(1..=3) {
        damage(rng, &mut b, other);
    }
    b
}

fn damage(rng: &mut ChaCha8Rng, b: &mut Vec<u8>, other: &[u8]) {
    if b.is_empty() {
        return b.extend_from_slice(other);
    }
    // The front is where counts and headers are.
    let most = if rng.random_bool(0.5) { b.len().min(64) } else { b.len() };
    let at = rng.random_range(0..most);
    match rng.random_range(0..9) {
        0 => b[at] ^= 1 << rng.random_range(0..8),
        1 => b[at] = rng.random(),
        2 => b.truncate(at),
        3 => write(b, at, &WORDS[rng.random_range(0..WORDS.len())].to_le_bytes()),
        4 => write(b, at, &WORDS[rng.random_range(0..WORDS.len())].to_be_bytes()),
        5 => {
            let f = FLOATS[rng.random_range(0..FLOATS.len())];
            let bits = if rng.random_bool(0.5) { f.to_le_bytes() } else { f.to_be_bytes() };
            write(b, if rng.random_bool(0.7) { at / 8 * 8 } else { at }, &bits);
        }
        6 if !other.is_empty() => {
            let from = rng.random_range(0..other.len());
            let len = rng.random_range(1..=(other.len() - from).min(64));
            write(b, at, &other[from..from + len]);
        }
        7 => {
            let len = rng.random_range(1..=(b.len() - at).min(32));
            b.drain(at..at + len);
        }
        _ => {
            let n = rng.random_range(1..=32);
            let extra: Vec<u8> = (0..n).map(|_| rng.random()).collect();
            b.splice(at..at, extra);
        }
    }
}

fn write(b: &mut [u8], at: usize, what: &[u8]) {
    for (to, from) in b[at..].iter_mut().zip(what) {
        *to = *from;
    }
}

/// Damaged text, still valid UTF-8 without a NUL.
pub fn text(rng: &mut ChaCha8Rng, valid: &str, other: &str) -> String {
    const PIECES: [&str; 12] =
        ["nan", "-", "1e999", "\u{202e}", "\u{1b}[31m", "(", ")", ",", "99999999999999999999", "NULL", "é", " "];
    let mut chars: Vec<char> = valid.chars().collect();
    for _ in 0..rng.random_range(1..=3) {
        let at = rng.random_range(0..=chars.len());
        match rng.random_range(0..4) {
            0 => chars.truncate(at),
            1 if at < chars.len() => {
                chars.remove(at);
            }
            2 => {
                let piece = PIECES[rng.random_range(0..PIECES.len())];
                chars.splice(at..at, piece.chars());
            }
            _ => {
                let from: Vec<char> = other.chars().take(40).collect();
                chars.splice(at..at, from);
            }
        }
    }
    chars.into_iter().filter(|&c| c != '\0').collect()
}
