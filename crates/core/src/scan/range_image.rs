//! A decoded patch as a small range image.

use super::angular_grid::AngularGrid;
use super::beam::Beam;
use super::beams::Beams;
use super::header::PatchHeader;
use crate::geometry::Vec3;

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
    /// Angle between neighbouring beams around each, radians, where they form no grid.
    pub steps: Option<Vec<f32>>,
    basis: [Vec3; 2],
    grid: AngularGrid,
}

impl RangeImage {
    /// Sorts beams with an origin.
    pub fn new(header: PatchHeader, beams: &[Beam]) -> Self {
        Self::sorted(header, beams, None, None)
    }

    /// Sorts the beams of a patch with an origin, with their intensities and steps where they are there.
    pub fn of(header: PatchHeader, content: &Beams) -> Self {
        Self::sorted(header, &content.beams, content.intensity.as_deref(), content.steps.as_deref())
    }

    fn sorted(header: PatchHeader, beams: &[Beam], intensities: Option<&[u16]>, steps: Option<&[f32]>) -> Self {
        let basis = header.cone.basis();
        let (mut kept, mut image) = (Vec::with_capacity(beams.len()), Vec::with_capacity(beams.len()));
        for (i, b) in beams.iter().enumerate() {
            let length = b.offset.norm();
            if length > 0.0 {
                let d = b.offset / length;
                kept.push((i, d, if b.returned { length } else { f64::INFINITY }));
                image.push(header.cone.image(&basis, &d));
            }
        }
        let (grid, slots) = AngularGrid::sort(
            &image,
            steps.and_then(|s| root_mean_square(s.iter().copied())).unwrap_or(header.spacing.angle()),
        );
        let (mut directions, mut ranges) = (vec![Vec3::zeros(); kept.len()], vec![0.0; kept.len()]);
        let mut order = vec![0; kept.len()];
        for (slot, (i, direction, range)) in slots.into_iter().zip(kept) {
            directions[slot as usize] = direction;
            ranges[slot as usize] = range;
            order[slot as usize] = i;
        }
        let intensities = intensities.map(|all| order.iter().map(|&i| all[i]).collect());
        let steps = steps.map(|all| order.iter().map(|&i| all[i]).collect());
        Self { header, directions, ranges, intensities, steps, basis, grid }
    }

    /// Widest angle between neighbouring beams, radians.
    pub fn widest_step(&self) -> f64 {
        self.header.spacing.angle()
    }

    /// Angle between neighbouring beams around one of them, radians.
    pub fn step_at(&self, slot: usize) -> f64 {
        self.steps.as_ref().map_or(self.widest_step(), |steps| steps[slot].into())
    }

    /// Mean angle between neighbouring beams around some of them, radians; the one step where there is but one.
    pub fn mean_step(&self, slots: impl Iterator<Item = usize>) -> f64 {
        let of = |steps: &Vec<f32>| root_mean_square(slots.map(|slot| steps[slot]));
        self.steps.as_ref().and_then(of).unwrap_or(self.widest_step())
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
        (depth > 1e-6 * offset.norm()).then(|| self.header.cone.image(&self.basis, offset))
    }

    /// Slot ranges, one per row of cells, that hold all beams within the image rectangle (and some around it).
    /// In the image plane at unit distance from the scanner.
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.grid.slots_in(min, max)
    }
}

/// The step of beams that cover together as much as these do each; `None` where there is none.
fn root_mean_square(steps: impl Iterator<Item = f32>) -> Option<f64> {
    let (sum, n) = steps.fold((0.0, 0.0), |(sum, n), s| (sum + f64::from(s).powi(2), n + 1.0));
    (n > 0.0).then(|| (sum / n).sqrt())
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
