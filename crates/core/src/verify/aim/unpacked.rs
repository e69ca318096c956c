//! A patch unpacked once for all the objects that it may concern.

use super::crossing::BeamCrossing;
use super::near_face::NearFace;
use crate::Result;
use crate::geometry::Vec3;
use crate::scan::{Origins, Patch, PatchHeader, RangeImage, by_origin};

/// A patch made ready for any number of objects.
#[derive(Debug)]
pub struct Unpacked {
    pub header: PatchHeader,
    pub beams: UnpackedBeams,
}

#[derive(Debug)]
pub enum UnpackedBeams {
    FromOne(Box<RangeImage>),
    FromMany(Vec<RangeImage>),
    /// Relative to the header's origin, metres.
    Points(Vec<Vec3>),
}

impl Unpacked {
    /// Number of returns that objects can claim: of beams from one place, and of points without origin.
    pub fn claimable(&self) -> usize {
        match &self.beams {
            UnpackedBeams::FromOne(view) => view.len(),
            UnpackedBeams::FromMany(_) => 0,
            UnpackedBeams::Points(points) => points.len(),
        }
    }

    /// Unpacks a patch; its intensities only if they are asked for.
    pub fn of(patch: &[u8], with_intensities: bool) -> Result<Self> {
        let unpack = if with_intensities { Patch::content_of } else { Patch::beams_of };
        let (header, content) = unpack(patch)?;
        let beams = match header.origins() {
            Origins::One => {
                let intensities = content.intensity.as_deref();
                UnpackedBeams::FromOne(Box::new(RangeImage::with_intensities(
                    header.clone(),
                    &content.beams,
                    intensities,
                )))
            }
            Origins::Each => {
                let by_place = by_origin(&header, &content)?;
                UnpackedBeams::FromMany(
                    by_place.into_iter().map(|(header, beams)| RangeImage::new(header, &beams)).collect(),
                )
            }
            Origins::Unknown => {
                UnpackedBeams::Points(content.beams.iter().filter(|b| b.returned).map(|b| b.offset).collect())
            }
        };
        Ok(Self { header, beams })
    }
}

/// What the beams of a patch are aimed at in one solid.
#[derive(Debug)]
pub enum Aim {
    /// None of it: the patch tells nothing of the solid.
    Aside,
    /// The first crossing of every beam that crosses.
    At(Vec<BeamCrossing>),
    /// Of points without origin, by number, those that lie near a face.
    Near(Vec<(u32, NearFace)>),
    /// To be found out beam by beam.
    Unknown,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::{Beam, Beams, PatchSpec, Spacing};

    /// One image where beams start at one place, one a place on a moving platform, else the points that returned.
    #[test]
    fn by_where_the_beams_start() {
        let beam = |i: i32| Beam { offset: Vec3::new(4.0, 0.01 * f64::from(i), 0.0), returned: i % 5 != 0 };
        let unpacked = |origins: Origins, starts: Option<Vec<Vec3>>| {
            let spec = PatchSpec {
                origins,
                station: 1,
                origin: Vec3::new(10.0, 0.0, 0.0),
                spacing: Spacing::of(origins, 2e-3),
                quantum: 1e-4,
            };
            let intensity = Some((0..20).collect());
            let beams = Beams { starts, intensity, ..Beams::of((0..20).map(beam).collect()) };
            Unpacked::of(&Patch::pack(&spec, &beams).unwrap().to_bytes(), true).unwrap()
        };
        let one = unpacked(Origins::One, None);
        assert_eq!(one.claimable(), 20);
        let UnpackedBeams::FromOne(view) = one.beams else { panic!("{:?}", one.beams) };
        assert!(view.intensities.is_some() && view.ranges.iter().filter(|r| r.is_infinite()).count() == 4);
        let starts = (0..20).map(|i| Vec3::new(0.0, f64::from(i / 2), 0.0)).collect();
        let each = unpacked(Origins::Each, Some(starts));
        assert_eq!(each.claimable(), 0);
        let UnpackedBeams::FromMany(views) = each.beams else { panic!("{:?}", each.beams) };
        assert_eq!((views.len(), views.iter().map(RangeImage::len).sum::<usize>()), (10, 20));
        let unknown = unpacked(Origins::Unknown, None);
        assert_eq!(unknown.claimable(), 16);
        let UnpackedBeams::Points(points) = unknown.beams else { panic!("{:?}", unknown.beams) };
        assert_eq!(points.len(), 16);
    }
}
