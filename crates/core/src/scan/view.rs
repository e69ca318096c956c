//! A decoded patch as a small range image.

use super::{Beam, Cone, Header};
use crate::geometry::Vec3;

/// Beams of one origin, sorted into the cells of an angular grid.
///
/// Directions are projected on the plane at unit distance along the cone's axis (gnomonic: straight lines stay
/// straight). Beams of a cell, and of neighbouring cells of a row, lie side by side in memory.
#[derive(Debug)]
pub struct View {
    /// The patch's header.
    pub header: Header,
    /// Unit direction of each beam, by slot.
    pub directions: Vec<Vec3>,
    /// Range of each beam, metres; infinite without return.
    pub ranges: Vec<f64>,
    basis: [Vec3; 2],
    low: [f64; 2],
    cell: f64,
    columns: usize,
    rows: usize,
    /// First slot of each cell, row by row, and the end.
    starts: Vec<u32>,
}

/// Cells per side at the most; a patch of 4096 beams needs far fewer.
const MAX_CELLS: f64 = 256.0;

impl View {
    /// Sorts the beams of a patch with an origin.
    pub fn new(header: Header, beams: &[Beam]) -> Self {
        let basis = header.cone.basis();
        let mut kept: Vec<(Vec3, f64, [f64; 2])> = Vec::with_capacity(beams.len());
        for b in beams {
            let length = b.offset.norm();
            if length > 0.0 {
                let d = b.offset / length;
                let range = if b.returned { length } else { f64::INFINITY };
                kept.push((d, range, gnomonic(&header.cone, &basis, &d)));
            }
        }
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (_, _, uv) in &kept {
            for k in 0..2 {
                low[k] = low[k].min(uv[k]);
                high[k] = high[k].max(uv[k]);
            }
        }
        if kept.is_empty() {
            (low, high) = ([0.0; 2], [0.0; 2]);
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let cell = (2.0 * f64::from(header.step)).max(extent / MAX_CELLS).max(1e-9);
        let count = |k: usize| ((high[k] - low[k]) / cell) as usize + 1;
        let mut view = Self {
            header,
            directions: vec![Vec3::zeros(); kept.len()],
            ranges: vec![0.0; kept.len()],
            basis,
            low,
            cell,
            columns: count(0),
            rows: count(1),
            starts: Vec::new(),
        };
        view.sort(&kept);
        view
    }

    fn sort(&mut self, kept: &[(Vec3, f64, [f64; 2])]) {
        let cell_of: Vec<usize> = kept
            .iter()
            .map(|(_, _, uv)| {
                let [c, r] = [0, 1].map(|k| ((uv[k] - self.low[k]) / self.cell) as usize);
                r.min(self.rows - 1) * self.columns + c.min(self.columns - 1)
            })
            .collect();
        let mut starts = vec![0u32; self.rows * self.columns + 1];
        cell_of.iter().for_each(|&c| starts[c + 1] += 1);
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        for (&c, (direction, range, _)) in cell_of.iter().zip(kept) {
            let slot = next[c] as usize;
            next[c] += 1;
            self.directions[slot] = *direction;
            self.ranges[slot] = *range;
        }
        self.starts = starts;
    }

    /// Number of beams.
    pub fn len(&self) -> usize {
        self.ranges.len()
    }

    /// Whether there is no beam.
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// Where the line from the origin to `offset` meets the image plane; `None` beside or behind the scanner.
    pub fn project(&self, offset: &Vec3) -> Option<[f64; 2]> {
        let depth = offset.dot(&self.header.cone.axis);
        (depth > 1e-6 * offset.norm()).then(|| gnomonic(&self.header.cone, &self.basis, offset))
    }

    /// Slot ranges, one a row of cells, that hold all beams within the image rectangle (and some around it).
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let index = |k: usize, x: f64, n: usize| ((x - self.low[k]) / self.cell).floor().clamp(-1.0, n as f64) as isize;
        let c0 = index(0, min[0], self.columns).max(0);
        let c1 = index(0, max[0], self.columns).min(self.columns as isize - 1);
        let r0 = index(1, min[1], self.rows).max(0);
        let r1 = index(1, max[1], self.rows).min(self.rows as isize - 1);
        let rows = if c0 <= c1 && r0 <= r1 { r0..r1 + 1 } else { 0..0 };
        rows.map(move |r| {
            let row = r as usize * self.columns;
            self.starts[row + c0 as usize] as usize..self.starts[row + c1 as usize + 1] as usize
        })
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
            let beams: Vec<Beam> = ends.iter().map(|&(x, y, z)| Beam { offset: Vec3::new(x, y, z), returned: true }).collect();
            let bytes = Patch::encode(0, Vec3::zeros(), 5e-3, 1e-4, &beams).unwrap().to_bytes();
            let (header, content) = Patch::beams_of(&bytes).unwrap();
            let (beams, view) = (&content.beams, View::new(header, &content.beams));
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
