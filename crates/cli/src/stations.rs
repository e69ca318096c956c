//! From points read to packed patches.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::{Content, Origins, Patch, Setting, clusters, mean_step, spacing, tiles};
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
    let (all, has_origin) = (scan.content.len(), scan.world_from_scan.is_some());
    scan.retain(|b| !b.returned || !has_origin || b.offset.norm() >= min_range);
    let (scan, beams) = (&*scan, &scan.content.beams);
    let mut packed = Packed { beams: 0, no_returns: 0, too_near: (all - beams.len()) as u64, points: Aabb::EMPTY };
    let tiles = if has_origin {
        tiles(beams, NEVER)?
    } else {
        clusters(&beams.iter().map(|b| b.offset).collect::<Vec<_>>(), NEVER)?
    };
    // In batches, so that the packed patches of a large scan are not all in memory at once.
    for batch in tiles.chunks(256) {
        let patches = batch
            .par_iter()
            .map(|tile| encode(scan, station, &scan.content.select(tile)))
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

fn encode(scan: &RawScan, station: i64, content: &Content) -> asbuilt_core::Result<Patch> {
    let (origins, step) = if scan.world_from_scan.is_some() {
        (Origins::One, mean_step(&content.beams))
    } else {
        (Origins::Unknown, spacing(content.beams.iter().map(|b| &b.offset)))
    };
    Patch::pack(&Setting { origins, station, origin: scan.anchor, step, quantum: Patch::QUANTUM_M }, content)
}
