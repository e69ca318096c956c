//! The lattice, and the tile of it that is looked at.

use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3};
use crate::scan::NO_RETURN_REACH_M;

/// Voxels of edge `voxel`; number `i` reaches from `i · voxel` to `(i + 1) · voxel` on every axis. SQL's `ab_grid`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Edge of a voxel, metres.
    pub voxel: f64,
    /// A voxel is looked at when its centre lies in this box (its upper faces excluded); world metres.
    pub tile: Aabb,
    /// A beam says "empty" up to this far before its return, metres: for range noise and registration.
    pub margin: f64,
    /// A beam without return says "empty" up to this range, metres.
    pub no_return_range: f64,
}

impl Grid {
    /// Numbers of voxels keep within this, so that those of blocks fit in 32 bits.
    const MAX_INDEX: f64 = 1e9;
    /// The coordinates that a lattice reaches, metres, where the tile is "all".
    pub const EVERYWHERE: Aabb = Aabb { min: [f64::NEG_INFINITY; 3], max: [f64::INFINITY; 3] };

    /// Checks its numbers.
    pub fn new(voxel: f64, tile: Aabb, margin: f64, no_return_range: f64) -> Result<Self> {
        if !(1e-4..=100.0).contains(&voxel) {
            return Err(Error::argument("the voxel size", "from 0.0001 to 100 m", voxel));
        }
        if !(0.0..=10.0).contains(&margin) {
            return Err(Error::argument("the margin", "from 0 to 10 m", margin));
        }
        if !(0.0..=NO_RETURN_REACH_M).contains(&no_return_range) {
            return Err(Error::argument("the range of beams without return", "from 0 to 30 m", no_return_range));
        }
        if (0..3).any(|i| tile.min[i].is_nan() || tile.max[i].is_nan() || tile.min[i] > tile.max[i]) {
            return Err(Error::argument("the tile", "a box", tile.to_text()));
        }
        Ok(Self { voxel, tile, margin, no_return_range })
    }

    /// Number of the voxel that holds a point; an error beyond the lattice.
    pub fn index(&self, point: &Vec3) -> Result<[i64; 3]> {
        let i = point.map(|c| (c / self.voxel).floor());
        match i.iter().all(|c| c.abs() <= Self::MAX_INDEX) {
            true => Ok(i.map(|c| c as i64).into()),
            false => Err(Error::Limit {
                what: "a coordinate in voxels",
                value: format!("{:e}", point.amax() / self.voxel),
                limit: format!("{:e} (voxels of {} m)", Self::MAX_INDEX, self.voxel),
            }),
        }
    }

    /// The voxels of the tile.
    pub fn span(&self) -> Span {
        let first = |c: f64| (c / self.voxel - 0.5).ceil().clamp(-Self::MAX_INDEX, Self::MAX_INDEX) as i64;
        Span([0, 1, 2].map(|axis| [first(self.tile.min[axis]), first(self.tile.max[axis])]))
    }

    /// Centre of a voxel, world metres.
    pub fn centre(&self, voxel: [i64; 3]) -> Vec3 {
        Vec3::from(voxel.map(|i| (i as f64 + 0.5) * self.voxel))
    }
}

/// A box of voxels: on every axis the first, and the one behind the last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span(pub [[i64; 2]; 3]);

impl Span {
    /// Whether a voxel belongs to it.
    pub fn holds(&self, voxel: [i64; 3]) -> bool {
        (0..3).all(|axis| (self.0[axis][0]..self.0[axis][1]).contains(&voxel[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_tiles_share_no_voxel_and_miss_none() {
        let tile = |a: f64, b: f64| Grid::new(0.02, Aabb { min: [a; 3], max: [b; 3] }, 0.0, 0.0).unwrap();
        let (low, high) = (tile(-1.0, 0.5), tile(0.5, 2.0));
        let (low_span, high_span) = (low.span(), high.span());
        assert_eq!(low_span.0[0][1], high_span.0[1][0]);
        assert_eq!(low_span.0[2], [-50, 25]);
        assert!(low_span.holds([24, 0, -50]) && !low_span.holds([25, 0, 0]) && high_span.holds([25, 30, 99]));
        let i = low.index(&Vec3::new(-0.001, 0.0, 0.019)).unwrap();
        assert_eq!(i, [-1, 0, 0]);
        assert!((low.centre(i) - Vec3::new(-0.01, 0.01, 0.01)).norm() < 1e-12);
    }

    #[test]
    fn wrong_numbers() {
        let all = Grid::EVERYWHERE;
        for voxel in [0.0, -1.0, f64::NAN, 1e-9, f64::INFINITY] {
            assert!(Grid::new(voxel, all, 0.0, 0.0).is_err());
        }
        assert!(Grid::new(0.01, Aabb::EMPTY, 0.0, 0.0).is_err());
        let grid = Grid::new(0.001, all, 0.0, 0.0).unwrap();
        assert!(grid.index(&Vec3::repeat(6e5)).is_ok());
        assert!(matches!(grid.index(&Vec3::repeat(6e6)), Err(Error::Limit { .. })));
        assert!(grid.index(&Vec3::repeat(f64::NAN)).is_err());
    }
}
