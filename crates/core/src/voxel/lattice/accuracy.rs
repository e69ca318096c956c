//! How accurate a statement in voxels can be at best (Meyer, 4.2).

use crate::error::{Error, Result};
use crate::evidence::Loa;

/// What a voxel size supports. The error is that of the voxel's centre alone: measurement and registration come on top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VoxelAccuracy {
    /// Greatest distance of a point from the centre of its voxel, metres: √3·a/2 (Meyer, 4.1).
    pub max_error: f64,
    /// Finest level of accuracy whose bound holds that error, for places; `None` where not even LOA10 does.
    pub absolute: Option<Loa>,
    /// The same for distances between two places, errors added as squares (4.4): T = √2·d.
    pub relative: Option<Loa>,
    /// The same, errors added linearly (4.5): T = 2·d.
    pub relative_linear: Option<Loa>,
}

impl VoxelAccuracy {
    /// For voxels of an edge, metres.
    pub fn of(voxel: f64) -> Result<Self> {
        if !(voxel > 0.0 && voxel.is_finite()) {
            return Err(Error::argument("the voxel size", "more than 0 m, and finite", voxel));
        }
        let max_error = 3f64.sqrt() * voxel / 2.0;
        let finest = |error: f64| Loa::ALL.into_iter().rev().find(|l| error <= l.upper());
        Ok(Self {
            max_error,
            absolute: finest(max_error),
            relative: finest(2f64.sqrt() * max_error),
            relative_linear: finest(2.0 * max_error),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Meyer 8.2: 0.86 cm (printed; 0.866) and LOA30 for 1 cm. He says that both relative tolerances exceed LOA30; the
    /// squared one, 12.2 mm, does not.
    #[test]
    fn a_centimetre_supports_loa30() {
        let a = VoxelAccuracy::of(0.01).unwrap();
        assert!((a.max_error - 0.008660254).abs() < 1e-9);
        assert_eq!((a.absolute, a.relative, a.relative_linear), (Some(Loa::Loa30), Some(Loa::Loa30), Some(Loa::Loa20)));
        assert_eq!(VoxelAccuracy::of(0.005).unwrap().absolute, Some(Loa::Loa40));
        assert_eq!(VoxelAccuracy::of(0.5).unwrap().absolute, None);
        assert!(VoxelAccuracy::of(0.0).is_err() && VoxelAccuracy::of(f64::NAN).is_err());
    }
}
