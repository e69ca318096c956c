//! From the points that were read to packed patches.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::{Origins, Patch, PatchSpec};
use rayon::prelude::*;

use crate::RawScan;

/// What became of a scan's beams.
#[derive(Debug, Clone, Copy)]
pub struct Packed {
    pub beams: u64,
    pub no_returns: u64,
    pub too_near: u64,
    pub points: Aabb,
}

/// [`Packed`] as plain numbers, between processes.
type PackedNumbers = ([u64; 3], [[f64; 3]; 2]);

impl Packed {
    pub fn to_bytes(self) -> Result<Vec<u8>> {
        let numbers: PackedNumbers = ([self.beams, self.no_returns, self.too_near], [self.points.min, self.points.max]);
        Ok(postcard::to_stdvec(&numbers)?)
    }

    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let ([beams, no_returns, too_near], [min, max]): PackedNumbers = postcard::from_bytes(bytes)?;
        Ok(Self { beams, no_returns, too_near, points: Aabb { min, max } })
    }
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
    let scan = &*scan;
    let too_near = (all - scan.content.len()) as u64;
    let mut packed = Packed { beams: 0, no_returns: 0, too_near, points: Aabb::EMPTY };
    let origins = if has_origin { Origins::One } else { Origins::Unknown };
    let (origin, quantum) = (scan.anchor, Patch::QUANTUM_M);
    let encode = |tile: &Vec<u32>| {
        let own = scan.content.select(tile);
        Patch::pack(&PatchSpec { origins, station, origin, spacing: own.spacing(origins), quantum }, &own)
    };
    let tiles = scan.content.cut(origins, NEVER)?;
    // In batches, so that the packed patches of a large scan are not all in memory at once.
    for batch in tiles.chunks(256) {
        let patches = batch.par_iter().map(encode).collect::<asbuilt_core::Result<Vec<Patch>>>()?;
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
