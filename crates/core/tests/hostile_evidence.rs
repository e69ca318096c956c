//! Crafted evidence: small values that promise much.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::Solid;
use asbuilt_core::num::bytes::Put;
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel};

/// The head of a real value in layout 3, which has no checksums, with other counts: one face, then blocks, samples and
/// stations as given.
fn head(blocks: u32, samples: u32, stations: u32) -> Vec<u8> {
    let cube = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap();
    let evidence = Collector::new(&cube, EvidenceModel::default(), NEVER).unwrap().into_evidence();
    let bytes = evidence.to_bytes(NEVER).unwrap();
    // Behind the first section's tag, length and checksum.
    let mut out = [&[3], &bytes[1..4], &bytes[16..Evidence::HEADER_LEN]].concat();
    for (i, n) in [1, blocks, samples, stations].into_iter().enumerate() {
        out[8 + 4 * i..12 + 4 * i].copy_from_slice(&n.to_le_bytes());
    }
    [0.0, 0.0, 1.0].into_iter().for_each(|c| out.put_f64(c));
    out.put_varint(0);
    out
}

/// Every station could speak about every block, but each speaks about one: memory depends on what is present.
#[test]
fn forty_thousand_stations_on_forty_thousand_blocks() {
    const N: u32 = 40_000;
    let mut bytes = head(N, N, N);
    for _ in 0..N {
        bytes.put(&[0, 1]);
    }
    (0..3 * N).for_each(|_| bytes.put_f32(0.5));
    for station in 0..N {
        bytes.put_i64(i64::from(station));
        [0.0; 3].into_iter().for_each(|c| bytes.put_f64(c));
        bytes.put_f32(0.001);
        bytes.put_u32(1);
        bytes.put_varint(u64::from(station));
        bytes.put_varint(0);
    }
    assert!(bytes.len() < 3_000_000);
    let e = Evidence::from_bytes(&bytes, NEVER).unwrap();
    assert_eq!(e.stations().len(), N as usize);
    // Written in today's layout it is the same value, and the same body behind the two sections' heads.
    let today = e.to_bytes(NEVER).unwrap();
    assert!(today.ends_with(&bytes[Evidence::HEADER_LEN - 12..]) && today.len() == bytes.len() + 24);
    assert!(Evidence::from_bytes(&today, NEVER).unwrap() == e);
}

/// 2²⁶ blocks of 64 samples are 2³² samples, which is zero in 32 bits.
#[test]
fn blocks_that_count_round_to_zero() {
    const N: u32 = 1 << 26;
    let mut bytes = head(N, 0, 0);
    bytes.resize(bytes.len() + 2 * N as usize, 0);
    let start = bytes.len() - 2 * N as usize;
    bytes[start..].iter_mut().skip(1).step_by(2).for_each(|b| *b = 64);
    let error = Evidence::from_bytes(&bytes, NEVER).unwrap_err().to_string();
    assert!(error.contains("its blocks do not hold its samples"), "{error}");
}

/// What every station says of every block is more than a value may hold.
#[test]
fn more_sums_than_memory() {
    const BLOCKS: u32 = 20_000;
    const STATIONS: u32 = 60;
    let mut bytes = head(BLOCKS, 64 * BLOCKS, STATIONS);
    (0..BLOCKS).for_each(|_| bytes.put(&[0, 64]));
    (0..3 * 64 * BLOCKS).for_each(|_| bytes.put_f32(0.5));
    for station in 0..STATIONS {
        bytes.put_i64(i64::from(station));
        [0.0; 3].into_iter().for_each(|c| bytes.put_f64(c));
        bytes.put_f32(0.001);
        bytes.put_u32(BLOCKS);
        bytes.resize(bytes.len() + 65 * BLOCKS as usize, 0);
    }
    let error = Evidence::from_bytes(&bytes, NEVER).unwrap_err().to_string();
    assert!(error.contains("sums"), "{error}");
}
