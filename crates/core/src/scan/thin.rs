//! Patches thinned by cubes.

use std::collections::HashMap;

use super::beams::Beams;
use super::header::PatchHeader;
use super::local_step::steps_of;
use super::origins::Origins;
use super::patch::Patch;
use crate::error::{Error, Result};

impl Patch {
    /// The first beam of every cube of side `spacing` (metres, lattice of the reference system) that a return lies in,
    /// and every beam without return.
    pub fn thinned(bytes: &[u8], spacing: f64) -> Result<Option<Self>> {
        if !(1e-6..=1e6).contains(&spacing) {
            return Err(Error::argument("the spacing", "from 0.000001 to 1000000 m", spacing));
        }
        let (header, content) = Self::content_of(bytes)?;
        let thinned = Thinned::of(&header, &content, spacing);
        if thinned.kept.len() == content.len() {
            return Self::pack(&header.setting(), &content).map(Some);
        }
        let mut kept = content.select(&thinned.kept);
        if header.origins() != Origins::One {
            return Self::pack_found(&header.frame(), kept).map(Some);
        }
        let mean = (thinned.stand_for.iter().sum::<f64>() / kept.len() as f64).sqrt();
        kept.steps = Some(steps_of(&kept.beams, &thinned.stand_for, mean));
        Self::pack(&header.setting(), &kept).map(Some)
    }
}

/// The beams that are left of a patch where every cube keeps the first return in it.
struct Thinned {
    kept: Vec<u32>,
    /// The solid angle of each and of those dropped in its favour, steradians, by their steps.
    stand_for: Vec<f64>,
}

impl Thinned {
    fn of(header: &PatchHeader, content: &Beams, side: f64) -> Self {
        let mut out = Self { kept: Vec::new(), stand_for: Vec::new() };
        let mut taken: HashMap<[i64; 3], usize> = HashMap::new();
        for (i, beam) in content.beams.iter().enumerate() {
            let cube: [i64; 3] = (content.end(i) + header.origin).map(|x| (x / side).floor() as i64).into();
            let step = content.steps.as_ref().map_or(header.spacing.angle(), |steps| steps[i].into());
            let place = if beam.returned { *taken.entry(cube).or_insert(out.kept.len()) } else { out.kept.len() };
            if place == out.kept.len() {
                out.kept.push(i as u32);
                out.stand_for.push(0.0);
            }
            out.stand_for[place] += step * step;
        }
        out
    }
}
