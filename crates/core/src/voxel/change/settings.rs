//! How two epochs are compared.

use crate::error::{Error, Result};
use crate::voxel::lattice::steps_within;

/// How two epochs are compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChangeSettings {
    /// Returns from which a voxel is occupied, 1 to 255.
    pub threshold: u8,
    /// A voxel counts as changed only if the other epoch has nothing occupied within this gap, metres; 0 compares voxel
    /// by voxel, as published.
    pub tolerance: f64,
}

impl ChangeSettings {
    /// Checks a threshold from SQL.
    pub fn threshold(n: i32) -> Result<u8> {
        let checked = u8::try_from(n).ok().filter(|&n| n > 0);
        checked.ok_or_else(|| Error::argument("the threshold", "from 1 to 255 returns", n))
    }

    /// The steps to the voxels within the tolerance; none for 0.
    pub(super) fn steps(&self, voxel: f64) -> Result<Vec<[i64; 3]>> {
        if !(0.0..=8.0 * voxel).contains(&self.tolerance) {
            return Err(Error::argument("the tolerance", "from 0 to 8 voxels", format!("{} m", self.tolerance)));
        }
        Ok(if self.tolerance > 0.0 { steps_within(self.tolerance / voxel) } else { Vec::new() })
    }
}
