//! The beams of a patch, unpacked, with what else was measured of each.

use super::beam::Beam;
use crate::geometry::Vec3;
use crate::{Grow, Interrupt, Result};

/// Beams with their optional attributes; an attribute that is present has one value per beam.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Beams {
    /// The beams.
    pub beams: Vec<Beam>,
    /// Where each beam starts, metres from the patch's origin: only for moving platforms ([`super::Origins::Each`]).
    pub starts: Option<Vec<Vec3>>,
    /// Intensity as the sensor gave it.
    pub intensity: Option<Vec<u16>>,
    /// Red, green, blue.
    pub colour: Option<Vec<[u8; 3]>>,
}

impl Beams {
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
    /// Directions from the scanner, of any length.
    pub fn extend_without_return(&mut self, directions: impl IntoIterator<Item = Vec3>) {
        let before = self.len();
        self.beams.extend(directions.into_iter().map(|offset| Beam { offset, returned: false }));
        let more = self.len() - before;
        self.intensity.iter_mut().for_each(|plane| plane.extend(std::iter::repeat_n(0, more)));
        self.colour.iter_mut().for_each(|plane| plane.extend(std::iter::repeat_n([0; 3], more)));
    }
}
