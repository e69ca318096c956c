//! From points read to packed patches.

use anyhow::Result;
use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::scan::{Beam, MAX_BEAMS, Patch, mean_step, tiles};
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
pub fn pack(scan: &RawScan, station: i64, min_range: f64, mut sink: impl FnMut(&[u8]) -> Result<()>) -> Result<Packed> {
    let keep = |b: &&Beam| !b.returned || scan.world_from_scan.is_none() || b.offset.norm() >= min_range;
    let beams: Vec<Beam> = scan.beams.iter().filter(keep).copied().collect();
    let mut packed =
        Packed { beams: 0, no_returns: 0, too_near: (scan.beams.len() - beams.len()) as u64, points: Aabb::EMPTY };
    let tiles = if scan.world_from_scan.is_some() { tiles(&beams) } else { clusters(&beams) };
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
    let b = Aabb::around(&points);
    let side = |i: usize| b.max[i] - b.min[i];
    // Points on surfaces: about the largest side of the box a surface is spread over.
    let area = [side(0) * side(1), side(1) * side(2), side(2) * side(0)].into_iter().fold(1e-6, f64::max);
    Patch::encode_cloud(station, scan.anchor, (area / points.len() as f64).sqrt(), Patch::QUANTUM_M, &points)
}

/// Points without origin, cut by place: halved across the longest side until the clusters are small.
fn clusters(points: &[Beam]) -> Vec<Vec<u32>> {
    fn split(points: &[Beam], own: &mut [u32], out: &mut Vec<Vec<u32>>) {
        if own.len() <= MAX_BEAMS {
            if !own.is_empty() {
                own.sort_unstable();
                out.push(own.to_vec());
            }
            return;
        }
        let b = Aabb::around(own.iter().map(|&i| &points[i as usize].offset));
        let axis = (0..3).max_by(|&i, &j| (b.max[i] - b.min[i]).total_cmp(&(b.max[j] - b.min[j]))).unwrap_or(0);
        let tiles = own.len().div_ceil(MAX_BEAMS);
        let middle = own.len() * (tiles / 2) / tiles;
        let at = |i: &u32| points[*i as usize].offset[axis];
        own.select_nth_unstable_by(middle, |a, b| at(a).total_cmp(&at(b)).then(a.cmp(b)));
        let (low, high) = own.split_at_mut(middle);
        split(points, low, out);
        split(points, high, out);
    }
    let mut all: Vec<u32> = (0..points.len() as u32).collect();
    let mut out = Vec::new();
    split(points, &mut all, &mut out);
    out
}
