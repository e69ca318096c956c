//! Mutated bytes with valid checksums: otherwise every mutation would end at the first check.

/// Tag, length and checksum before the content of a section (`num/sections.rs` of the core).
const SECTION_HEAD: usize = 12;

/// The bytes with the checksums that belong to them, as far as their sections (or, in older layouts, their length) go.
pub fn mended(data: &[u8]) -> Vec<u8> {
    let mut bytes = data.to_vec();
    match data {
        [1 | 2, b'P', ..] => flat(&mut bytes, 12, 200),
        [1, b'S', ..] => flat(&mut bytes, 12, 80),
        [1, b'O' | b'C', ..] if data.len() >= 8 => {
            let checksum = crc(&[&data[..4], &data[8..]]);
            bytes[4..8].copy_from_slice(&checksum);
        }
        _ => sections(&mut bytes),
    }
    bytes
}

/// Sets the checksum at one place, which covers everything from another place on.
fn flat(bytes: &mut [u8], at: usize, from: usize) {
    if let Some(body) = bytes.get(from..) {
        let checksum = crc(&[body]);
        bytes[at..at + 4].copy_from_slice(&checksum);
    }
}

/// The first section's checksum covers the four bytes before it, too. A section that is longer than what is left ends there.
fn sections(bytes: &mut [u8]) {
    let mut at = 4;
    while let Some(head) = bytes.get(at..at + SECTION_HEAD) {
        let left = bytes.len() - at - SECTION_HEAD;
        let len = u32::from_le_bytes([head[4], head[5], head[6], head[7]]) as usize;
        let len = if len > left { left } else { len };
        bytes[at + 4..at + 8].copy_from_slice(&(len as u32).to_le_bytes());
        let preamble = if at == 4 { &bytes[..4] } else { &[] };
        let end = at + SECTION_HEAD + len;
        let checksum = crc(&[preamble, &bytes[at..at + 8], &bytes[at + SECTION_HEAD..end]]);
        bytes[at + 8..at + SECTION_HEAD].copy_from_slice(&checksum);
        at = end;
    }
}

fn crc(parts: &[&[u8]]) -> [u8; 4] {
    let mut hasher = crc32fast::Hasher::new();
    parts.iter().for_each(|part| hasher.update(part));
    hasher.finalize().to_le_bytes()
}
