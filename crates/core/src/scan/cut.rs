//! Beams cut into patches of neighbours.

use super::beams::Beams;
use super::cluster::{angular_spacing, clusters, spacing};
use super::origins::Origins;
use super::patch::Patch;
use super::patch_spec::PatchSpec;
use super::spacing::Spacing;
use super::tile::{mean_step, tiles};
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll, room};

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

    /// The beams cut into patches of neighbours, each packed by the setting that `patch_spec` gives it.
    pub(super) fn packed(
        &self,
        origins: Origins,
        interrupt: Interrupt,
        setting: impl Fn(&Self) -> PatchSpec,
    ) -> Result<Vec<Patch>> {
        let pack = |tile: &Vec<u32>| {
            poll(interrupt)?;
            let own = self.select(tile);
            Patch::pack(&setting(&own), &own)
        };
        self.cut(origins, interrupt)?.iter().map(pack).collect()
    }
}
