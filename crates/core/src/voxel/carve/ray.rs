//! A way through empty space.

use crate::geometry::Vec3;
use crate::voxel::lattice::VoxelBox;

/// A way through empty space, in voxels from a [`super::local_origin::LocalOrigin`].
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    /// Where it begins.
    pub start: Vec3,
    /// Where it stops.
    pub stop: Vec3,
    /// Part of the way to its return at which it stops.
    pub part: f64,
}

impl Ray {
    /// The part inside a box of voxels.
    pub fn clipped(&self, tile: &VoxelBox) -> Option<Self> {
        let way = self.stop - self.start;
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for axis in 0..3 {
            let faces = tile.0[axis].map(|i| i as f64);
            let [a, b] = faces.map(|face| (face - self.start[axis]) / way[axis]);
            if way[axis] != 0.0 {
                (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
            } else if self.start[axis] < faces[0] || self.start[axis] >= faces[1] {
                return None;
            }
        }
        (from < to).then(|| Self { start: self.start + way * from, stop: self.start + way * to, part: self.part })
    }
}
