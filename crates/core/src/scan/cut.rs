//! Beams cut into patches of neighbours.

use super::beams::Beams;
use super::cluster::{angular_spacing, clusters, spacing};
use super::local_step::steps_off_grid;
use super::origins::Origins;
use super::patch::Patch;
use super::patch_spec::PatchFrame;
use super::spacing::Spacing;
use super::tile::{mean_step, tiles};
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll, room};

impl Patch {
    /// Packs beams whose spacing nobody tells, and that need not be a scanner's.
    pub fn pack_found(frame: &PatchFrame, mut content: Beams) -> Result<Self> {
        let spacing = content.find_spacing(frame.origins);
        Self::pack(&frame.spaced(spacing), &content)
    }
}

impl Beams {
    /// Cuts the beams into patches of neighbours, each a list of beam numbers: by direction where they start at one
    /// place, else by where they end. A beam of one origin and zero length is in none.
    pub fn cut(&self, origins: Origins, interrupt: Interrupt) -> Result<Vec<Vec<u32>>> {
        match origins {
            Origins::One => tiles(&self.beams, interrupt),
            Origins::Each | Origins::Unknown => {
                room::<Vec3>(self.len(), interrupt)?;
                clusters(&(0..self.len()).map(|i| self.end(i)).collect::<Vec<Vec3>>(), interrupt)
            }
        }
    }

    /// How far neighbouring ones of these beams are apart, when nobody tells.
    /// An angle, radians; a distance, metres, for points without origin.
    pub fn spacing(&self, origins: Origins) -> Spacing {
        match origins {
            Origins::One => Spacing::Angle(mean_step(&self.beams)),
            Origins::Each => Spacing::Angle(angular_spacing(self)),
            Origins::Unknown => Spacing::Distance(spacing(self.beams.iter().map(|b| &b.offset))),
        }
    }

    /// The same of beams that need not be a scanner's: where those of one origin form no grid, each gets a step of its
    /// own.
    pub fn find_spacing(&mut self, origins: Origins) -> Spacing {
        let spacing = self.spacing(origins);
        self.steps = match spacing {
            Spacing::Angle(mean) if origins == Origins::One => steps_off_grid(&self.beams, mean),
            _ => None,
        };
        spacing
    }

    /// The beams cut into packed patches of neighbours.
    pub(super) fn packed(&self, frame: &PatchFrame, interrupt: Interrupt) -> Result<Vec<Patch>> {
        let pack = |tile: &Vec<u32>| {
            poll(interrupt)?;
            Patch::pack_found(frame, self.select(tile))
        };
        self.cut(frame.origins, interrupt)?.iter().map(pack).collect()
    }
}
