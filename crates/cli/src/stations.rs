//! From points read to packed patches.

use anyhow::Result;
use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::scan::{Beam, Patch, clusters, mean_step, spacing, tiles};
use rayon::prelude::*;

use crate::read::RawScan;

/// What became of a scan's beams.
#[derive(Debug, Clone, Copy)]
pub struct Packed {
    pub beams: u64,
    pub no_returns: u64,
    pub too_near: u64,
    pub points: Aabb,
}

/// Drops what lies nearer than `min_range` (the scanner's own platform), cuts the rest into tiles and packs them
/// in parallel; calls `sink` with each patch's bytes in a fixed order.
pub fn pack(
    scan: &mut RawScan,
    station: i64,
    min_range: f64,
    mut sink: impl FnMut(&[u8]) -> Result<()>,
) -> Result<Packed> {
    let (all, has_origin) = (scan.beams.len(), scan.world_from_scan.is_some());
    scan.beams.retain(|b| !b.returned || !has_origin || b.offset.norm() >= min_range);
    let (scan, beams) = (&*scan, &scan.beams);
    let mut packed = Packed { beams: 0, no_returns: 0, too_near: (all - beams.len()) as u64, points: Aabb::EMPTY };
    let tiles = if has_origin { tiles(beams) } else { clusters(&beams.iter().map(|b| b.offset).collect::<Vec<_>>()) };
    // In batches, so that the packed patches of a large scan are not all in memory at once.
    for batch in tiles.chunks(256) {
        let patches = batch
            .par_iter()
            .map(|tile| {
                let own: Vec<Beam> = tile.iter().map(|&i| beams[i as usize]).collect();
                encode(scan, station, &own)
            })
            .collect::<asbuilt_core::Result<Vec<Patch>>>()?;
        for patch in patches {
            let h = patch.header();
            packed.beams += u64::from(h.beams);
            packed.no_returns += u64::from(h.beams - h.returns);
            if h.returns > 0 {
                packed.points = packed.points.union(&h.points);
            }
            sink(&patch.to_bytes())?;
        }
    }
    Ok(packed)
}

fn encode(scan: &RawScan, station: i64, beams: &[Beam]) -> asbuilt_core::Result<Patch> {
    if scan.world_from_scan.is_some() {
        return Patch::encode(station, scan.anchor, mean_step(beams), Patch::QUANTUM_M, beams);
    }
    let points: Vec<Vec3> = beams.iter().map(|b| b.offset + scan.anchor).collect();
    Patch::encode_cloud(station, scan.anchor, spacing(&points), Patch::QUANTUM_M, &points)
}
