//! A ray as a line through slabs along an axis of the lattice.

use super::ray::Ray;
use crate::geometry::Vec3;
use crate::voxel::lattice::VoxelBox;

/// A ray along the slabs' axis: its other two coordinates as functions of the first, which grows. In voxels from the
/// bundle's `LocalOrigin`; along the axis with the other sign where the lines run against it.
#[derive(Debug, Clone, Copy)]
pub struct SlabLine {
    /// Where it starts along the axis.
    pub from: f64,
    /// Where it stops along the axis.
    pub to: f64,
    /// Where its return lies along the axis.
    pub end: f64,
    /// Its other two coordinates where it starts.
    at: [f64; 2],
    /// How far its other two coordinates go a voxel along the axis.
    pub slope: [f64; 2],
    /// 1 / slope; infinite for a line that stays in its row.
    inverse_direction: [f64; 2],
    /// The part of it inside the tile.
    pub clipped: [f64; 2],
}

/// The axes of a bundle of lines: along it, and across it in the order that blocks store them.
#[derive(Debug, Clone, Copy)]
pub struct SlabAxes {
    /// The slabs' axis.
    pub along: usize,
    /// The other two.
    pub across: [usize; 2],
    /// Lines run with the axis or against it.
    pub sign: f64,
}

impl SlabAxes {
    /// For rays that all lean towards `sign` × the axis `along`.
    pub fn new(along: usize, sign: f64) -> Self {
        let across = match along {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        };
        Self { along, across, sign }
    }

    /// Whether voxels are counted against the axis.
    pub fn is_mirrored(&self) -> bool {
        self.sign < 0.0
    }

    /// The voxel at a place along the axis (already mirrored) and two across it.
    pub fn voxel(&self, along: i64, across: [i64; 2]) -> [i64; 3] {
        let mut voxel = [0; 3];
        voxel[self.along] = along;
        (0..2).for_each(|k| voxel[self.across[k]] = across[k]);
        voxel
    }

    /// The point of a line at a place along the axis.
    pub fn point(&self, line: &SlabLine, along: f64) -> Vec3 {
        let mut p = Vec3::zeros();
        p[self.along] = self.sign * along;
        (0..2).for_each(|k| p[self.across[k]] = line.across(k, along));
        p
    }

    /// A ray as a line, and its part inside a tile (voxels from the origin).
    pub fn line(&self, ray: &Ray, tile: &VoxelBox) -> SlabLine {
        let (from, to) = (self.sign * ray.start[self.along], self.sign * ray.stop[self.along]);
        let at = self.across.map(|k| ray.start[k]);
        let slope = self.across.map(|k| (ray.stop[k] - ray.start[k]) / (to - from));
        let inverse_direction = slope.map(f64::recip);
        let own = tile.0[self.along].map(|i| self.sign * i as f64);
        let mut clipped = [from.max(own[0].min(own[1])), to.min(own[0].max(own[1]))];
        for k in 0..2 {
            let faces = tile.0[self.across[k]].map(|i| i as f64);
            if slope[k] != 0.0 {
                let [a, b] = faces.map(|face| from + (face - at[k]) * inverse_direction[k]);
                clipped = [clipped[0].max(a.min(b)), clipped[1].min(a.max(b))];
            } else if at[k] < faces[0] || at[k] >= faces[1] {
                clipped[1] = f64::NEG_INFINITY;
            }
        }
        SlabLine { from, to, end: from + (to - from) / ray.part, at, slope, inverse_direction, clipped }
    }
}

impl SlabLine {
    /// Square of its length a voxel along the axis.
    pub fn length_squared(&self) -> f64 {
        1.0 + self.slope[0].powi(2) + self.slope[1].powi(2)
    }

    /// Stops so many voxels (of its own length) earlier.
    pub fn stop_before(&mut self, voxels: f64) {
        self.to = (self.to - voxels / self.length_squared().sqrt()).max(self.from);
        self.clipped[1] = self.clipped[1].min(self.to);
    }

    /// Its coordinate on the axis across `k` at a place along the axis.
    pub fn across(&self, k: usize, along: f64) -> f64 {
        self.at[k] + self.slope[k] * (along - self.from)
    }

    /// Where it leaves the row of voxels numbered `row` on the axis across `k`.
    pub fn leaves(&self, k: usize, row: i64) -> f64 {
        let face = if self.slope[k] > 0.0 { row + 1 } else { row };
        if self.slope[k] == 0.0 {
            f64::INFINITY
        } else {
            self.from + (face as f64 - self.at[k]) * self.inverse_direction[k]
        }
    }

    /// The part inside the tile and a slab. In voxels along the carving axis.
    pub fn within(&self, slab: [i64; 2]) -> Option<[f64; 2]> {
        let part = [self.clipped[0].max(slab[0] as f64), self.clipped[1].min(slab[1] as f64)];
        (part[0] < part[1]).then_some(part)
    }
}
