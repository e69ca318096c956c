//! The beams of a patch, unpacked, with what else was measured of each.

use super::cluster::{angular_spacing, clusters, spacing};
use super::tile::{mean_step, tiles};
use super::{Header, Origins};
use crate::geometry::Vec3;
use crate::{Grow, Interrupt, Result, room};

/// One laser beam relative to its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// From the origin to the return, metres; for a beam without return any vector along it.
    pub offset: Vec3,
    /// Whether something came back.
    pub returned: bool,
}

/// Beams with their optional attributes; an attribute that is present has one value per beam.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Content {
    /// The beams.
    pub beams: Vec<Beam>,
    /// Where each beam starts, metres from the patch's origin: only for moving platforms ([`super::Origins::Each`]).
    pub starts: Option<Vec<Vec3>>,
    /// Intensity as the sensor gave it.
    pub intensity: Option<Vec<u16>>,
    /// Red, green, blue.
    pub colour: Option<Vec<[u8; 3]>>,
}

impl Content {
    /// Beams alone.
    pub fn of(beams: Vec<Beam>) -> Self {
        Self { beams, ..Self::default() }
    }

    /// Number of beams.
    pub fn len(&self) -> usize {
        self.beams.len()
    }

    /// Whether there is no beam.
    pub fn is_empty(&self) -> bool {
        self.beams.is_empty()
    }

    /// Where beam `i` starts, metres from the patch's origin.
    pub fn start(&self, i: usize) -> Vec3 {
        self.starts.as_ref().map_or_else(Vec3::zeros, |s| s[i])
    }

    /// Where beam `i` ends, metres from the patch's origin.
    pub fn end(&self, i: usize) -> Vec3 {
        self.start(i) + self.beams[i].offset
    }

    /// The same with only the named beams, in that order.
    pub fn select(&self, beams: &[u32]) -> Self {
        fn pick<T: Copy>(from: &[T], which: &[u32]) -> Vec<T> {
            which.iter().map(|&i| from[i as usize]).collect()
        }
        Self {
            beams: pick(&self.beams, beams),
            starts: self.starts.as_deref().map(|p| pick(p, beams)),
            intensity: self.intensity.as_deref().map(|p| pick(p, beams)),
            colour: self.colour.as_deref().map(|p| pick(p, beams)),
        }
    }

    /// Adds the beams of another; an attribute that only one of them has is lost.
    pub fn append(&mut self, mut other: Self, interrupt: Interrupt) -> Result<()> {
        let more = other.len();
        self.beams.grow(more, interrupt)?;
        self.starts.iter_mut().try_for_each(|s| s.grow(more, interrupt))?;
        self.intensity.iter_mut().try_for_each(|p| p.grow(more, interrupt))?;
        self.colour.iter_mut().try_for_each(|p| p.grow(more, interrupt))?;
        fn join<T>(mine: &mut Option<Vec<T>>, theirs: Option<Vec<T>>) {
            match (mine.as_mut(), theirs) {
                (Some(m), Some(t)) => m.extend(t),
                _ => *mine = None,
            }
        }
        join(&mut self.starts, other.starts);
        join(&mut self.intensity, other.intensity);
        join(&mut self.colour, other.colour);
        self.beams.append(&mut other.beams);
        Ok(())
    }

    /// Adds beams without return; they have neither intensity nor colour, so these attributes hold 0 for them.
    pub fn extend_without_return(&mut self, directions: impl IntoIterator<Item = Vec3>) {
        let before = self.len();
        self.beams.extend(directions.into_iter().map(|offset| Beam { offset, returned: false }));
        let more = self.len() - before;
        self.intensity.iter_mut().for_each(|plane| plane.extend(std::iter::repeat_n(0, more)));
        self.colour.iter_mut().for_each(|plane| plane.extend(std::iter::repeat_n([0; 3], more)));
    }

    /// Cuts the beams into patches of neighbours, each a list of beam numbers: by direction where they start at one place,
    /// else by where they end. A beam of one origin and zero length is in none.
    pub fn cut(&self, origins: Origins, interrupt: Interrupt) -> Result<Vec<Vec<u32>>> {
        match origins {
            Origins::One => tiles(&self.beams, interrupt),
            Origins::Each | Origins::Unknown => {
                room::<Vec3>(self.len(), interrupt)?;
                clusters(&(0..self.len()).map(|i| self.end(i)).collect::<Vec<Vec3>>(), interrupt)
            }
        }
    }

    /// The step of a patch of these beams ([`super::Setting::step`]) when it is not given.
    pub fn step(&self, origins: Origins) -> f64 {
        match origins {
            Origins::One => mean_step(&self.beams),
            Origins::Each => angular_spacing(self),
            Origins::Unknown => spacing(self.beams.iter().map(|b| &b.offset)),
        }
    }

    /// The flags of the attributes that are present.
    pub(super) fn plane_flags(&self) -> u8 {
        let flag = |there: bool, flag: u8| if there { flag } else { 0 };
        flag(self.starts.is_some(), Header::FLAG_ORIGIN_EACH)
            | flag(self.intensity.is_some(), Header::FLAG_INTENSITY)
            | flag(self.colour.is_some(), Header::FLAG_COLOUR)
    }
}
