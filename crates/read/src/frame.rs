//! Bringing a scan into the frame of the model: an offset, or a transform with rotation and scale.

use std::fmt;
use std::io::Read;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::num::text::numbers;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::RawScan;

/// A rotation is one where its product with its transpose is 1 to within this; what a file writes with five digits.
const MAX_SKEW: f64 = 1e-4;

/// No such text is longer, bytes.
const MAX_TEXT: u64 = 1 << 16;

/// `model_from_file`: p ↦ s·R·p + t, metres.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameTransform {
    pub rotation: Matrix3<f64>,
    pub scale: f64,
    pub translation: Vec3,
}

impl FrameTransform {
    /// An offset alone.
    pub fn offset(translation: Vec3) -> Self {
        Self { rotation: Matrix3::identity(), scale: 1.0, translation }
    }

    /// From a text of 16 numbers, the rows of a 4 × 4 matrix as CloudCompare writes it, or of the first 12 of them.
    pub fn parse(text: &str) -> Result<Self> {
        let text = text.trim_start_matches('\u{feff}').replace('\r', "\n");
        let text = text.as_str();
        let Some(m) = numbers::<16>(text).or_else(|| numbers::<12>(text).map(with_last_row)) else {
            bail!("it is not 16 numbers, the rows of a 4 × 4 matrix (nor the 12 of its first three rows)");
        };
        if m[12..] != [0.0, 0.0, 0.0, 1.0] {
            bail!("the last row of a transform is 0 0 0 1, not {:?}; are its rows and columns exchanged?", &m[12..]);
        }
        let linear = Matrix3::from_fn(|row, column| m[4 * row + column]);
        let scale = linear.determinant().cbrt();
        if scale <= 0.0 || !(1e-6..=1e6).contains(&scale) {
            bail!(
                "its determinant is {}: it mirrors, or flattens; exchange the sign of one axis",
                linear.determinant()
            );
        }
        let rotation = linear / scale;
        if (rotation * rotation.transpose() - Matrix3::identity()).amax() > MAX_SKEW {
            bail!("it is no rotation with one scale: it would skew the scan");
        }
        Ok(Self { rotation, scale, translation: Vec3::new(m[3], m[7], m[11]) })
    }

    /// From a file of such a text.
    pub fn read(file: &Path) -> Result<Self> {
        let read = || -> Result<Self> {
            let mut text = String::new();
            std::fs::File::open(file)?.take(MAX_TEXT).read_to_string(&mut text)?;
            Self::parse(&text)
        };
        read().with_context(|| format!("--transform {}", file.display()))
    }

    /// Brings a scan from its file's frame into the model's.
    pub fn apply(&self, scan: &mut RawScan) {
        let turn = |v: &Vec3| self.rotation * v * self.scale;
        scan.content.beams.iter_mut().for_each(|b| b.offset = turn(&b.offset));
        scan.content.starts.iter_mut().flatten().for_each(|start| *start = turn(start));
        scan.anchor = turn(&scan.anchor) + self.translation;
        let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix(&self.rotation));
        scan.world_from_scan = scan.world_from_scan.map(|[w, i, j, k]| {
            let own = UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, i, j, k));
            let q = q * own;
            [q.w, q.i, q.j, q.k]
        });
        scan.origin_sd = scan.origin_sd.map(|sd| sd * self.scale);
        scan.notes.push(format!("brought into the model's frame by {self}"));
    }
}

fn with_last_row(m: [f64; 12]) -> [f64; 16] {
    let mut out = [0.0; 16];
    out[..12].copy_from_slice(&m);
    out[15] = 1.0;
    out
}

impl fmt::Display for FrameTransform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rotation, scale, translation: t } = self;
        write!(f, "an offset of ({:.3}, {:.3}, {:.3}) m", t.x, t.y, t.z)?;
        let angle = Rotation3::from_matrix(rotation).angle().to_degrees();
        if angle > 1e-6 {
            write!(f, ", a rotation by {angle:.4}°")?;
        }
        if (scale - 1.0).abs() > 1e-9 {
            write!(f, ", a scale of {scale:.6}")?;
        }
        Ok(())
    }
}

/// How a scan gets into the model's frame, as it is given on the command line.
#[derive(Debug, Clone, Default, PartialEq, clap::Args)]
pub struct FrameOptions {
    /// Added to every coordinate of a scan, metres: from its frame into the model's (a false origin, a projected frame)
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_metres, conflicts_with = "transform")]
    pub offset: Option<Vec3>,
    /// Text with the 16 numbers of a 4 × 4 matrix, row by row (as CloudCompare writes it): from the scan's frame into the model's,
    /// a rotation, one scale and an offset, metres
    #[arg(long, value_name = "FILE")]
    pub transform: Option<PathBuf>,
}

/// Three numbers on the command line, metres.
pub fn parse_metres(text: &str) -> Result<Vec3, String> {
    numbers::<3>(text).map(Vec3::from).ok_or_else(|| format!("\"{text}\" is not three numbers x,y,z"))
}

impl FrameOptions {
    /// The transform, where one is given.
    pub fn model_from_file(&self) -> Result<Option<FrameTransform>> {
        match (&self.transform, self.offset) {
            (Some(file), _) => FrameTransform::read(file).map(Some),
            (None, offset) => Ok(offset.map(FrameTransform::offset)),
        }
    }

    /// As arguments of a command line.
    pub fn arguments(&self) -> impl Iterator<Item = String> {
        let offset = self.offset.map(|by| format!("--offset={},{},{}", by.x, by.y, by.z));
        offset.into_iter().chain(self.transform.as_ref().map(|file| format!("--transform={}", file.display())))
    }
}

#[cfg(test)]
mod tests {
    use asbuilt_core::scan::{Beam, Beams};

    use super::super::NO_ROTATION;
    use super::*;

    const QUARTER: &str = "0 -2 0 10\n2 0 0 20\n0 0 2 30\n0 0 0 1\n";

    #[test]
    fn a_scan_is_turned_scaled_and_moved() {
        let beam = |x, y, z| Beam { offset: Vec3::new(x, y, z), returned: true };
        let content = Beams::of(vec![beam(1.0, 0.0, 0.0), beam(0.0, 3.0, 1.0)]);
        let mut scan = RawScan {
            content,
            anchor: Vec3::new(5.0, 0.0, 1.0),
            world_from_scan: Some(NO_ROTATION),
            ..RawScan::default()
        };
        FrameTransform::parse(QUARTER).unwrap().apply(&mut scan);
        assert_eq!(scan.anchor, Vec3::new(10.0, 30.0, 32.0));
        let offsets: Vec<[f64; 3]> = scan.content.beams.iter().map(|b| b.offset.into()).collect();
        assert_eq!(offsets, [[0.0, 2.0, 0.0], [-6.0, 0.0, 2.0]]);
        let [w, _, _, k] = scan.world_from_scan.unwrap();
        assert!((w - 0.5f64.sqrt()).abs() < 1e-12 && (k - 0.5f64.sqrt()).abs() < 1e-12);
        let note = scan.notes.pop().unwrap();
        assert!(note.contains("(10.000, 20.000, 30.000) m, a rotation by 90.0000°, a scale of 2.000000"), "{note}");
    }

    #[test]
    fn what_is_no_transform_is_refused() {
        for (text, said) in [
            ("1 0 0 0", "16 numbers"),
            ("1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1", "exchanged"),
            ("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "mirrors"),
            ("1 0 0 0 0 1 0 0 0 0 2 0 0 0 0 1", "skew"),
            ("0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1", "flattens"),
            ("1 nan 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "16 numbers"),
        ] {
            let error = FrameTransform::parse(text).unwrap_err().to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
        assert_eq!(
            FrameTransform::parse(&QUARTER.replace('\n', "\r\n")).unwrap(),
            FrameTransform::parse(QUARTER).unwrap()
        );
        let twelve = FrameTransform::parse("1,0,0,5, 0,1,0,6, 0,0,1,7").unwrap();
        assert_eq!(twelve, FrameTransform::offset(Vec3::new(5.0, 6.0, 7.0)));
    }
}
