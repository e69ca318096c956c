//! Patches of a moving platform, split into patches of one origin.

use std::collections::BTreeMap;

use super::beam::Beam;
use super::beams::Beams;
use super::encode::describe;
use super::header::PatchHeader;
use super::origins::Origins;
use super::patch_spec::PatchSpec;
use super::tile::tiles;
use crate::NEVER;
use crate::error::Result;

/// Cuts beams that start at many places into groups of one origin and one cone, each with a header of its own; mostly
/// single beams. Groups are ordered by the first beam of each place.
pub fn by_origin(header: &PatchHeader, content: &Beams) -> Result<Vec<(PatchHeader, Vec<Beam>)>> {
    let mut places: BTreeMap<[u64; 3], Vec<u32>> = BTreeMap::new();
    for i in 0..content.len() {
        let place = content.start(i).map(f64::to_bits).into();
        places.entry(place).or_default().push(i as u32);
    }
    let mut groups: Vec<Vec<u32>> = places.into_values().collect();
    groups.sort_unstable();
    let mut out = Vec::with_capacity(groups.len());
    for group in groups {
        let origin = header.origin + content.start(group[0] as usize);
        let setting = PatchSpec { origins: Origins::One, origin, ..header.setting() };
        let beams: Vec<Beam> = group.iter().map(|&i| content.beams[i as usize]).collect();
        for tile in tiles(&beams, NEVER)? {
            let own: Vec<Beam> = tile.iter().map(|&i| beams[i as usize]).collect();
            let no_returns = if own.iter().all(|b| b.returned) { 0 } else { PatchHeader::FLAG_NO_RETURNS };
            let content = Beams::of(own);
            out.push((describe(no_returns, &setting, &content)?, content.beams));
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vec3;
    use crate::scan::{Patch, Spacing};

    #[test]
    fn every_beam_keeps_its_start_and_end() {
        let n = 300;
        let starts: Vec<Vec3> = (0..n).map(|i| Vec3::new(0.01 * f64::from(i / 2), 0.0, 1.5)).collect();
        let beam =
            |i: i32| Beam { offset: Vec3::new(0.0, if i % 2 == 0 { 3.0 } else { -4.0 }, 0.2), returned: i % 9 != 0 };
        let content = Beams { starts: Some(starts.clone()), ..Beams::of((0..n).map(beam).collect()) };
        let origin = Vec3::new(6e6, 6e6, 100.0);
        let setting =
            PatchSpec { origins: Origins::Each, station: 4, origin, spacing: Spacing::Angle(0.01), quantum: 1e-4 };
        let bytes = Patch::pack(&setting, &content).unwrap().to_bytes();
        let (header, back) = Patch::beams_of(&bytes).unwrap();
        let groups = by_origin(&header, &back).unwrap();
        assert_eq!(groups.iter().map(|(_, b)| b.len()).sum::<usize>(), n as usize);
        assert_eq!(groups.len(), n as usize, "two directions of each place are two cones");
        for (k, (header, beams)) in groups.iter().enumerate() {
            let i = k; // Places come in the order of their first beams, and each has an even and an odd one.
            let near = (header.origin - origin - starts[i]).amax();
            assert!(near < 1e-4 && header.station == 4 && beams.len() == 1, "{near}");
            assert!(header.cone.half_angle < 1e-3);
        }
    }
}
