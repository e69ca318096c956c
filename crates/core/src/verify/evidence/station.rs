//! A station's part of the evidence.

use std::collections::BTreeMap;

use crate::geometry::Vec3;
use crate::verify::model::{Sums, ViewingGeometry};
use crate::{Interrupt, Result, poll_now_and_then};

/// Where the beams of a station start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StationOrigin {
    /// At one point, world metres.
    At(Vec3),
    /// Along the way of a moving platform.
    Many,
    /// Nobody knows: points without rays.
    Unknown,
}

impl StationOrigin {
    /// As three numbers: the point, infinity for many, NaN for unknown.
    pub(in crate::verify) fn to_vec3(self) -> Vec3 {
        match self {
            Self::At(origin) => origin,
            Self::Many => Vec3::repeat(f64::INFINITY),
            Self::Unknown => Vec3::repeat(f64::NAN),
        }
    }

    /// The mirror of [`StationOrigin::to_vec3`]; `None` for numbers that are no place.
    pub(in crate::verify) fn from_vec3(v: Vec3) -> Option<Self> {
        match v {
            v if v.iter().all(|c| c.is_finite()) => Some(Self::At(v)),
            v if v.iter().all(|c| *c == f64::INFINITY) => Some(Self::Many),
            v if v.iter().all(|c| c.is_nan()) => Some(Self::Unknown),
            _ => None,
        }
    }
}

/// What one station's beams add up to, by block of samples; blocks it never saw are absent.
#[derive(Debug, Clone, PartialEq)]
pub struct StationEvidence {
    /// The station's number, as in its patches.
    pub id: i64,
    /// Where its beams start. With the number, what tells stations apart.
    pub place: StationOrigin,
    /// Widest angle between neighbouring beams, radians; 0 where it is not known.
    pub(in crate::verify) step: f32,
    /// By number of the block.
    pub(in crate::verify) blocks: BTreeMap<u32, Box<[Sums]>>,
}

impl StationEvidence {
    /// A station that saw nothing yet.
    pub(super) fn new(id: i64, place: StationOrigin) -> Self {
        Self { id, place, step: 0.0, blocks: BTreeMap::new() }
    }

    /// Order of stations in a value: by number, then by place.
    pub(in crate::verify) fn key(&self) -> (i64, [u64; 3]) {
        let place = match self.place {
            StationOrigin::At(origin) => origin.map(f64::to_bits).into(),
            StationOrigin::Many => [u64::MAX - 1; 3],
            StationOrigin::Unknown => [u64::MAX; 3],
        };
        (self.id, place)
    }

    /// Adds what another part of the evidence holds of this station.
    pub(super) fn add(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        self.step = self.step.max(other.step);
        for (round, (block, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            self.add_block(*block, theirs);
        }
        Ok(())
    }

    /// How it looks at a sample. Without one place that sees it, a sample counts along the normal and has no range.
    pub(in crate::verify) fn viewing_geometry(&self, position_world: &Vec3, normal: &Vec3) -> ViewingGeometry {
        let (sight, range) = match self.place {
            StationOrigin::At(origin) => (position_world - origin, (position_world - origin).norm().max(1e-6)),
            StationOrigin::Many | StationOrigin::Unknown => (-normal, 0.0),
        };
        ViewingGeometry {
            range,
            cos: sight.dot(normal).abs() / sight.norm().max(1e-6),
            from_outside: sight.dot(normal) <= 0.0,
            step: f64::from(self.step),
            has_rays: self.place != StationOrigin::Unknown,
        }
    }

    /// The sums of a block of `len` samples, zeros if it has none yet.
    pub(in crate::verify) fn block(&mut self, block: u32, len: u32) -> &mut [Sums] {
        self.blocks.entry(block).or_insert_with(|| vec![Sums::default(); len as usize].into())
    }

    /// Adds the sums of a block of samples.
    pub(in crate::verify) fn add_block(&mut self, block: u32, theirs: &[Sums]) {
        match self.blocks.get_mut(&block) {
            Some(mine) => mine.iter_mut().zip(theirs).for_each(|(a, b)| a.add(b)),
            None => {
                self.blocks.insert(block, theirs.into());
            }
        }
    }
}
