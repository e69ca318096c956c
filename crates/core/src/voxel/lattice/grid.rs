//! The lattice, and the tile of it that is looked at.

use super::voxel_box::VoxelBox;
use crate::error::{Error, LatticeMismatch, Limited, Result};
use crate::geometry::{Aabb, Vec3};
use crate::num::bytes::{ByteReader, Put};
use crate::num::text::number;
use crate::num::whole::floor;
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
    /// Only voxels that a beam itself passes are empty; else those between neighbouring beams of a patch are too.
    pub exact: bool,
}

impl Grid {
    /// Numbers of voxels keep within this, so that those of blocks fit in 32 bits.
    const MAX_INDEX: f64 = 1e9;
    /// Bytes of [`Grid::write`].
    pub const LEN: usize = 80;
    /// Default of [`Grid::margin`]: three standard deviations of range (2 mm) and registration (2 mm), and a little.
    pub const MARGIN_M: f64 = 0.01;
    /// The coordinates that a lattice reaches, metres, where the tile is "all".
    pub const EVERYWHERE: Aabb = Aabb { min: [f64::NEG_INFINITY; 3], max: [f64::INFINITY; 3] };

    /// Checks its numbers. World metres.
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
        let grid = Self { voxel, tile, margin, no_return_range, exact: false };
        for corner in [tile.min, tile.max].into_iter().filter(|c| c.iter().all(|x| x.is_finite())) {
            grid.index(&corner.into())?;
        }
        Ok(grid)
    }

    /// Whether voxels of both are the same voxels.
    pub fn same_lattice(&self, other: &Self) -> Result<()> {
        if self.voxel == other.voxel {
            return Ok(());
        }
        Err(Error::Lattice(LatticeMismatch::VoxelSize(self.voxel, other.voxel)))
    }

    /// Whether what beams say was gathered by the same rules.
    pub fn same_rules(&self, other: &Self) -> Result<()> {
        self.same_lattice(other)?;
        let rules = |g: &Self| format!("margin {}, no_return_range {}, exact {}", g.margin, g.no_return_range, g.exact);
        if rules(self) == rules(other) {
            return Ok(());
        }
        Err(Error::Lattice(LatticeMismatch::Rules(rules(self), rules(other))))
    }

    /// The same with the part of its tile that lies in a box.
    pub(crate) fn clipped(&self, to: &Aabb) -> Result<Self> {
        let own = &self.tile;
        let min = [0, 1, 2].map(|i| own.min[i].max(to.min[i]));
        let max = [0, 1, 2].map(|i| own.max[i].min(to.max[i]).max(min[i]));
        let part = Self::new(self.voxel, Aabb { min, max }, self.margin, self.no_return_range)?;
        Ok(Self { exact: self.exact, ..part })
    }

    /// Whether the tile has a border.
    pub fn is_bounded(&self) -> bool {
        self.tile != Self::EVERYWHERE
    }

    /// Volume of a voxel, m³.
    pub fn voxel_volume(&self) -> f64 {
        self.voxel.powi(3)
    }

    /// Appends voxel, tile, margin and no-return range, 9×f64, and a u64 that is 1 for exact.
    pub fn write(&self, out: &mut Vec<u8>) {
        let numbers =
            [&[self.voxel][..], &self.tile.min, &self.tile.max, &[self.margin, self.no_return_range]].concat();
        numbers.iter().for_each(|&n| out.put_f64(n + 0.0));
        out.put_i64(i64::from(self.exact));
    }

    /// Reads what [`Grid::write`] wrote.
    pub fn read(r: &mut ByteReader) -> Result<Self> {
        let voxel = r.f64()?;
        let tile = Aabb { min: r.vec3()?.into(), max: r.vec3()?.into() };
        let is_bounded = tile.min.iter().chain(&tile.max).all(|c| c.is_finite());
        if !is_bounded && tile != Self::EVERYWHERE {
            return Err(r.bad("a tile without end on some axes"));
        }
        let grid = Self::new(voxel, tile, r.f64()?, r.f64()?)?;
        match r.i64()? {
            0 => Ok(grid),
            1 => Ok(Self { exact: true, ..grid }),
            n => Err(r.bad(format!("flags {n} of a grid"))),
        }
    }

    /// Text form: `voxel=0.01 margin=0.01 no_return_range=30 exact=false tile=all`.
    pub fn to_text(&self) -> String {
        let tile = if self.is_bounded() { self.tile.to_text() } else { "all".into() };
        let [voxel, margin, range] = [self.voxel, self.margin, self.no_return_range].map(number);
        format!("voxel={voxel} margin={margin} no_return_range={range} exact={} tile={tile}", self.exact)
    }

    /// Reads [`Grid::to_text`]'s form; what is not named keeps its default, but for the voxel. The tile comes last.
    pub fn from_text(text: &str) -> Result<Self> {
        let bad = || Error::syntax("ab_grid", text);
        let (words, tile) = text.split_once("tile=").unwrap_or((text, "all"));
        let tile = if tile.trim() == "all" { Self::EVERYWHERE } else { Aabb::from_text(tile)? };
        let (mut voxel, mut margin, mut range, mut exact) = (None, Self::MARGIN_M, 0.0, false);
        for word in words.split_whitespace() {
            let (name, value) = word.split_once('=').ok_or_else(bad)?;
            let number = || value.parse::<f64>().map_err(|_| bad());
            match name {
                "voxel" => voxel = Some(number()?),
                "margin" => margin = number()?,
                "no_return_range" => range = number()?,
                "exact" => exact = value.parse().map_err(|_| bad())?,
                _ => return Err(bad()),
            }
        }
        Ok(Self { exact, ..Self::new(voxel.ok_or_else(bad)?, tile, margin, range)? })
    }

    /// Number of the voxel that holds a point; an error beyond the lattice.
    #[inline]
    pub fn index(&self, point: &Vec3) -> Result<[i64; 3]> {
        let [x, y, z] = [0, 1, 2].map(|i| point[i] / self.voxel);
        match x.abs().max(y.abs()).max(z.abs()) <= Self::MAX_INDEX && !(x + y + z).is_nan() {
            true => Ok([floor(x), floor(y), floor(z)]),
            false => Err(self.beyond(point)),
        }
    }

    #[cold]
    fn beyond(&self, point: &Vec3) -> Error {
        let worst = point.iter().find(|c| c.is_nan()).copied().unwrap_or(point.amax());
        Error::Limit {
            what: Limited::VoxelIndex,
            value: format!("{:e}", worst / self.voxel),
            limit: format!("{:e} (voxels of {} m)", Self::MAX_INDEX, self.voxel),
        }
    }

    /// The voxels of the tile.
    pub fn span(&self) -> VoxelBox {
        let first = |c: f64| (c / self.voxel - 0.5).ceil().clamp(-Self::MAX_INDEX, Self::MAX_INDEX) as i64;
        VoxelBox([0, 1, 2].map(|axis| [first(self.tile.min[axis]), first(self.tile.max[axis])]))
    }

    /// Centre of a voxel, world metres.
    pub fn centre(&self, voxel: [i64; 3]) -> Vec3 {
        Vec3::from(voxel.map(|i| (i as f64 + 0.5) * self.voxel))
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
    fn text_and_bytes_round_trip() {
        let tile = Aabb { min: [0.0, -1.0, 2.0], max: [20.0, 19.0, 22.0] };
        for tile in [tile, Grid::EVERYWHERE] {
            let grid = Grid { exact: tile == Grid::EVERYWHERE, ..Grid::new(0.02, tile, 0.003, 12.5).unwrap() };
            assert_eq!(Grid::from_text(&grid.to_text()).unwrap(), grid);
            let mut bytes = Vec::new();
            grid.write(&mut bytes);
            assert_eq!((bytes.len(), Grid::read(&mut ByteReader::new(&bytes, "test"))), (Grid::LEN, Ok(grid)));
        }
        for bad in ["", "voxel", "voxel=x", "margin=1", "voxel=0.01 colour=red", "voxel=0.01 tile=none", "voxel=-1"] {
            assert!(Grid::from_text(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn wrong_numbers() {
        let all = Grid::EVERYWHERE;
        for voxel in [0.0, -1.0, f64::NAN, 1e-9, f64::INFINITY] {
            assert!(Grid::new(voxel, all, 0.0, 0.0).is_err());
        }
        assert!(Grid::new(0.01, Aabb::EMPTY, 0.0, 0.0).is_err());
        let wide = Aabb { min: [0.0; 3], max: [2e6; 3] };
        assert!(matches!(Grid::new(0.001, wide, 0.0, 0.0), Err(Error::Limit { .. })));
        let grid = Grid::new(0.001, all, 0.0, 0.0).unwrap();
        assert!(grid.index(&Vec3::repeat(6e5)).is_ok());
        assert!(matches!(grid.index(&Vec3::repeat(6e6)), Err(Error::Limit { .. })));
        assert!(grid.index(&Vec3::repeat(f64::NAN)).is_err());
    }
}
