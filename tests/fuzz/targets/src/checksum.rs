//! Checksums set right, so that damage gets past them. Where they stand is found out from valid values, so that this
//! keeps working when a layout changes.

use std::collections::HashMap;

/// The CRC-32 at `at` is of the bytes from `from`, to the end or for `len` bytes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Rule {
    at: usize,
    from: usize,
    len: Option<usize>,
}

/// Longer seeds would take seconds: every stretch of bytes is tried.
const LONGEST: usize = 1500;

/// The checksums in a valid value.
pub fn rules(valid: &[u8]) -> Vec<Rule> {
    if valid.len() > LONGEST {
        return vec![];
    }
    let words: HashMap<u32, usize> =
        valid.windows(4).enumerate().map(|(at, w)| (u32::from_le_bytes(w.try_into().unwrap()), at)).collect();
    let mut found = vec![];
    for from in 0..valid.len() {
        let mut hasher = crc32fast::Hasher::new();
        for to in from + 1..=valid.len() {
            hasher.update(&valid[to - 1..to]);
            // Short stretches meet by chance.
            let at = words.get(&hasher.clone().finalize()).filter(|&&at| to - from > 8 && (at + 4 <= from || at >= to));
            if let Some(&at) = at {
                let len = (to < valid.len()).then_some(to - from);
                found.push(Rule { at, from, len });
            }
        }
    }
    found
}

/// The input with the checksums of `rules` set right where they fit.
pub fn mended(input: &[u8], rules: &[Rule]) -> Vec<u8> {
    let mut bytes = input.to_vec();
    for r in rules {
        let to = r.len.map_or(bytes.len(), |len| r.from + len);
        if r.from < to && to <= bytes.len() && r.at + 4 <= bytes.len() {
            let sum = crc32fast::hash(&bytes[r.from..to]);
            bytes[r.at..r.at + 4].copy_from_slice(&sum.to_le_bytes());
        }
    }
    bytes
}

/// Rules of all seeds of a target.
pub fn of_seeds(target: &str) -> Vec<Rule> {
    let mut all: Vec<Rule> = super::seeds(target).iter().flat_map(|s| rules(s)).collect();
    all.dedup();
    all
}

/// A static that holds the rules of a target.
macro_rules! with_checksums {
    ($target:literal, $input:expr) => {{
        static RULES: std::sync::OnceLock<Vec<crate::checksum::Rule>> = std::sync::OnceLock::new();
        crate::checksum::mended($input, RULES.get_or_init(|| crate::checksum::of_seeds($target)))
    }};
}
pub(crate) use with_checksums;
