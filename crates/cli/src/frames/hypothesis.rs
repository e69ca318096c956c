//! What may be wrong with the frame of scans.

use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_read::Unit;

/// How scans would have to be read to fit the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hypothesis {
    /// Which axis of the scan, counted from 0, goes along x, y and z; and its sense.
    pub axes: [(usize, f64); 3],
    /// Metres of the model to one of the scan.
    pub scale: f64,
}

/// As they are.
pub const AS_READ: Hypothesis = Hypothesis { axes: [(0, 1.0), (1, 1.0), (2, 1.0)], scale: 1.0 };

/// The units that are mistaken for metres; both feet are the same to boxes.
const UNITS: [Unit; 4] = [Unit::Ft, Unit::Mm, Unit::Cm, Unit::In];

/// Upright is y, or x and y are exchanged, as in files of other trades.
const TURNED: [[(usize, f64); 3]; 3] =
    [[(0, 1.0), (2, -1.0), (1, 1.0)], [(0, 1.0), (2, 1.0), (1, 1.0)], [(1, 1.0), (0, 1.0), (2, 1.0)]];

impl Hypothesis {
    /// All that are tried beside [`AS_READ`].
    pub fn others() -> impl Iterator<Item = Self> {
        let scales = UNITS.iter().flat_map(|u| [u.metres(), 1.0 / u.metres()]).map(|scale| Self { scale, ..AS_READ });
        scales.chain(TURNED.into_iter().map(|axes| Self { axes, ..AS_READ }))
    }

    /// Where a box of the scan would lie.
    pub fn of_box(&self, b: &Aabb) -> Aabb {
        Aabb::around(&[b.min, b.max].map(|corner| self.of_place(&Vec3::from(corner))))
    }

    fn of_place(&self, place: &Vec3) -> Vec3 {
        Vec3::from(self.axes.map(|(axis, sense)| place[axis] * sense * self.scale))
    }

    /// The unit that scans read as metres would have to count in; and the one of the model, if the scans are right.
    pub fn units(&self) -> [Option<Unit>; 2] {
        let unit = |scale: f64| UNITS.into_iter().find(|u| (u.metres() / scale - 1.0).abs() < 1e-9);
        [unit(self.scale), unit(1.0 / self.scale)]
    }

    /// The rows of the transform that `asbuilt load --transform` takes.
    pub fn rows(&self) -> String {
        let row = |(axis, sense): (usize, f64)| {
            let mut row = [0.0; 4];
            row[axis] = sense * self.scale;
            row.map(|v| v.to_string()).join(" ")
        };
        let rows = self.axes.map(row);
        format!("{} / 0 0 0 1", rows.join(" / "))
    }
}
