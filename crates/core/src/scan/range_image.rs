//! A decoded patch as a small range image.

use super::angular_grid::AngularGrid;
use super::beam::Beam;
use super::cone::Cone;
use super::header::PatchHeader;
use super::range_pyramid::RangePyramid;
use super::window::Window;
use crate::geometry::Vec3;

/// Beams farther from the axis have no proper place in the image, radians.
const MAX_PROJECTED: f64 = 1.5;

/// Beams of one origin, sorted into the cells of an angular grid.
///
/// Directions are projected onto the plane at unit distance along the cone's axis (gnomonic: straight lines stay
/// straight). Beams of a cell, and of neighbouring cells of a row, are adjacent in memory.
#[derive(Debug)]
pub struct RangeImage {
    /// The patch's header.
    pub header: PatchHeader,
    /// Unit direction of each beam, by slot.
    pub directions: Vec<Vec3>,
    /// Range of each beam, metres; infinite without return.
    pub ranges: Vec<f64>,
    /// Intensity of each beam, where it was measured and asked for.
    pub intensities: Option<Vec<u16>>,
    basis: [Vec3; 2],
    grid: AngularGrid,
    farthest: RangePyramid,
}

impl RangeImage {
    /// Sorts the beams of a patch with an origin.
    pub fn new(header: PatchHeader, beams: &[Beam]) -> Self {
        Self::with_intensities(header, beams, None)
    }

    /// The same with the beams' intensities.
    pub fn with_intensities(header: PatchHeader, beams: &[Beam], intensities: Option<&[u16]>) -> Self {
        let basis = header.cone.basis();
        let (mut kept, mut image) = (Vec::with_capacity(beams.len()), Vec::with_capacity(beams.len()));
        for (i, b) in beams.iter().enumerate() {
            let length = b.offset.norm();
            if length > 0.0 {
                let d = b.offset / length;
                let range = if b.returned { length } else { f64::INFINITY };
                kept.push((d, range, intensities.map_or(0, |all| all[i])));
                image.push(gnomonic(&header.cone, &basis, &d));
            }
        }
        let (grid, slots) = AngularGrid::sort(&image, header.spacing.angle());
        let (mut directions, mut ranges) = (vec![Vec3::zeros(); kept.len()], vec![0.0; kept.len()]);
        let mut sorted = intensities.map(|_| vec![0; kept.len()]);
        for (slot, (direction, range, intensity)) in slots.into_iter().zip(kept) {
            directions[slot as usize] = direction;
            ranges[slot as usize] = range;
            if let Some(sorted) = &mut sorted {
                sorted[slot as usize] = intensity;
            }
        }
        let farthest = RangePyramid::of(&grid, &ranges);
        Self { header, directions, ranges, intensities: sorted, basis, grid, farthest }
    }

    /// Angle between neighbouring beams, radians.
    pub fn step(&self) -> f64 {
        self.header.spacing.angle()
    }

    /// Number of beams.
    pub fn len(&self) -> usize {
        self.ranges.len()
    }

    /// Whether there is no beam.
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// Where the line from the scanner along `offset` (scanner-relative) meets the image plane; `None` beside or behind
    /// the scanner.
    pub fn project(&self, offset: &Vec3) -> Option<[f64; 2]> {
        let depth = offset.dot(&self.header.cone.axis);
        (depth > 1e-6 * offset.norm()).then(|| gnomonic(&self.header.cone, &self.basis, offset))
    }

    /// Slot ranges, one per row of cells, that hold all beams within the image rectangle (and some around it).
    /// In the image plane at unit distance from the scanner.
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.grid.slots_in(min, max)
    }

    /// At least as far as any beam within the image rectangle got, metres: infinity where one did not return, −∞ where
    /// there is none.
    pub fn farthest_in(&self, min: [f64; 2], max: [f64; 2]) -> f64 {
        self.farthest.farthest(self.grid.cells_in(min, max))
    }

    /// What of a triangle (corners from the scanner, metres) lies within the image.
    pub fn window_on(&self, corners_scanner: &[Vec3; 3]) -> Option<Window> {
        if self.header.cone.half_angle > MAX_PROJECTED {
            return Some(Window { min: [f64::NEG_INFINITY; 2], max: [f64::INFINITY; 2], depth: 0.0 });
        }
        let seen =
            corners_scanner.map(|c| [c.dot(&self.basis[0]), c.dot(&self.basis[1]), c.dot(&self.header.cone.axis)]);
        Window::on(&seen, self.grid.extent())
    }

    /// The rectangle in the image around what has these corners (from the scanner, metres); the whole image when one is
    /// beside or behind it.
    pub fn rectangle_around(&self, corners_scanner: &[Vec3]) -> ([f64; 2], [f64; 2]) {
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for corner in corners_scanner {
            let Some(uv) = self.project(corner) else {
                return ([f64::NEG_INFINITY; 2], [f64::INFINITY; 2]);
            };
            for k in 0..2 {
                min[k] = min[k].min(uv[k] - 1e-9);
                max[k] = max[k].max(uv[k] + 1e-9);
            }
        }
        (min, max)
    }
}

fn gnomonic(cone: &Cone, basis: &[Vec3; 2], v: &Vec3) -> [f64; 2] {
    let depth = v.dot(&cone.axis).max(1e-12);
    [v.dot(&basis[0]) / depth, v.dot(&basis[1]) / depth]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::Patch;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rectangle_finds_what_a_full_search_finds(
            ends in prop::collection::vec((3.0..5.0f64, -1.0..1.0f64, -1.0..1.0f64), 1..500),
            a in (-0.4..0.4f64, -0.4..0.4f64), size in (0.0..0.3f64, 0.0..0.3f64))
        {
            let beam = |&(x, y, z)| Beam { offset: Vec3::new(x, y, z), returned: true };
            let beams: Vec<Beam> = ends.iter().map(beam).collect();
            let bytes = Patch::encode(0, Vec3::zeros(), 5e-3, 1e-4, &beams).unwrap().to_bytes();
            let (header, content) = Patch::beams_of(&bytes).unwrap();
            let (beams, view) = (&content.beams, RangeImage::new(header, &content.beams));
            prop_assert_eq!(view.len(), beams.len());
            let (min, max) = ([a.0, a.1], [a.0 + size.0, a.1 + size.1]);
            let found: Vec<usize> = view.slots_in(min, max).flatten().collect();
            for slot in 0..view.len() {
                let uv = view.project(&view.directions[slot]).unwrap();
                let inside = (0..2).all(|k| min[k] <= uv[k] && uv[k] <= max[k]);
                prop_assert!(!inside || found.contains(&slot));
            }
        }
    }
}
