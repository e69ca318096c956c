//! A patch unpacked once for all the objects that it may concern.

use super::crossing::BeamCrossing;
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
    /// Number of beams that start at one place; 0 for other patches.
    pub fn aimed_beams(&self) -> usize {
        if let UnpackedBeams::FromOne(view) = &self.beams { view.len() } else { 0 }
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
    /// To be found out beam by beam.
    Unknown,
}
