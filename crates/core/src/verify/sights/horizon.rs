//! How far the beams of a station got, direction by direction: what lies behind is out of its sight.

use std::f64::consts::PI;

use super::sphere_grid::SphereGrid;
use crate::geometry::Vec3;

/// Height and width of a cell, radians.
const CELL: f64 = 0.1;
/// A direction is not farther from the middle of its cell, radians.
const OFF_MIDDLE: f64 = 1.5 * CELL;

/// The farthest range in each direction.
#[derive(Debug)]
pub struct Horizon {
    grid: SphereGrid,
    /// Of each cell its middle and how far a beam got, metres; −∞ where none was sent.
    cells: Vec<(Vec3, f32)>,
}

impl Horizon {
    /// Nobody looked anywhere yet.
    pub fn new() -> Self {
        let grid = SphereGrid::new(CELL);
        Self { cells: grid.middles().map(|middle| (middle, f32::NEG_INFINITY)).collect(), grid }
    }

    /// A beam in a unit direction got as far, metres; infinity without return.
    pub fn add(&mut self, direction: &Vec3, range: f64) {
        let farthest = &mut self.cells[self.grid.place(direction).0].1;
        *farthest = farthest.max((range as f32).next_up());
    }

    /// Whether a beam towards a ball (from the scanner, metres), or `aside` radians beside it, may have got as near to it
    /// as `within` metres.
    pub fn may_meet(&self, centre_scanner: &Vec3, radius: f64, aside: f64, within: f64) -> bool {
        let distance = centre_scanner.norm();
        let nearest = distance - radius - within;
        if nearest <= 0.0 {
            return true;
        }
        let angle = (radius / distance).asin() + OFF_MIDDLE + aside;
        let (direction, least) = (centre_scanner / distance, angle.min(PI).cos());
        self.cells.iter().any(|(middle, farthest)| f64::from(*farthest) >= nearest && middle.dot(&direction) >= least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A ball that a beam ends in, or nearly, may be met; one far behind or on the other side is not.
        #[test]
        fn no_beam_is_forgotten(
            end in prop::array::uniform3(-9.0..9.0f64), aside in prop::array::uniform3(-1.0..1.0f64), within in 0.0..1.0f64)
        {
            let (end, aside) = (Vec3::from(end), Vec3::from(aside));
            prop_assume!(end.norm() > 0.2);
            let mut horizon = Horizon::new();
            horizon.add(&end.normalize(), end.norm());
            prop_assert!(horizon.may_meet(&(end + aside), aside.norm(), 0.0, within));
            let behind = end * (1.0 + (within + 0.3) / end.norm());
            prop_assert!(!horizon.may_meet(&behind, 0.1, 0.0, within));
            prop_assert!(!horizon.may_meet(&-end, 0.05, 0.02, 0.0));
        }
    }
}
