//! Voxels from a first to a last one on every axis.

use super::bits::{Bits, EDGE};

/// A box of voxels: on every axis the first, and the one behind the last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VoxelBox(pub [[i64; 2]; 3]);

impl VoxelBox {
    /// From one voxel to another, both included.
    pub fn between(low: [i64; 3], high: [i64; 3]) -> Self {
        Self([0, 1, 2].map(|axis| [low[axis], high[axis] + 1]))
    }

    /// Whether a voxel belongs to it.
    pub fn holds(&self, voxel: [i64; 3]) -> bool {
        (0..3).all(|axis| (self.0[axis][0]..self.0[axis][1]).contains(&voxel[axis]))
    }

    /// The voxels of both.
    pub fn common(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|axis| {
            let ([a, b], [c, d]) = (self.0[axis], other.0[axis]);
            [a.max(c), b.min(d).max(a.max(c))]
        }))
    }

    /// The same voxels counted from another one.
    pub fn counted_from(&self, voxel: [i64; 3]) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis].map(|i| i - voxel[axis])))
    }

    /// Whether it holds no voxel.
    pub fn is_empty(&self) -> bool {
        self.0.iter().any(|[first, end]| first >= end)
    }

    /// Which voxels of a block belong to it.
    pub fn of_block(&self, key: [i32; 3]) -> Bits {
        let inside = [0, 1, 2].map(|axis| {
            let first = i64::from(key[axis]) * EDGE;
            let [low, end] = self.0[axis].map(|i| (i - first).clamp(0, EDGE));
            if low < end { ((1u64 << end) - 1) & !((1u64 << low) - 1) } else { 0 }
        });
        let plane = (0..8).filter(|y| inside[1] >> y & 1 == 1).fold(0u64, |m, y| m | inside[0] << (8 * y));
        std::array::from_fn(|z| if inside[2] >> z & 1 == 1 { plane } else { 0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn part_of_a_block() {
        let span = VoxelBox([[-3, 5], [0, 100], [7, 8]]);
        let bits = span.of_block([0, 0, 0]);
        assert_eq!(bits[..7], [0; 7]);
        assert_eq!(bits[7], 0x1f1f_1f1f_1f1f_1f1f);
        assert_eq!(span.of_block([-1, 3, 0])[7], 0xe0e0_e0e0_e0e0_e0e0);
        assert_eq!(span.of_block([1, 0, 0]), [0; 8]);
    }
}
