//! Scans as the database gets them.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchSpec};
use asbuilt_fieldscan::{Scan, delivery};
use rayon::prelude::*;

/// Edge of the cubes to which merged clouds are thinned, metres.
const THINNED_M: f64 = 0.005;

/// How scans are delivered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Delivery {
    /// Every station with its place and all of its beams.
    Stations,
    /// One cloud of all stations' points, thinned, without any place.
    Merged,
}

impl Delivery {
    /// In words.
    pub fn name(self) -> &'static str {
        ["stations", "merged"][self as usize]
    }

    /// The packed patches of all scans.
    pub fn patches(self, scans: &[Scan]) -> Result<Vec<Vec<u8>>> {
        let mut out = Vec::new();
        match self {
            Self::Stations => {
                for (i, scan) in scans.iter().enumerate() {
                    let beams = scan.shots.iter().map(|s| Beam { offset: s.offset, returned: s.returned });
                    out.extend(pack(beams.collect(), scan.place, i as i64 + 1, Origins::One)?);
                }
            }
            Self::Merged => {
                let points = delivery::merged(scans, THINNED_M);
                let zero = points.first().map_or_else(Vec3::zeros, |p| p.map(f64::round));
                let beams = points.iter().map(|p| Beam { offset: p - zero, returned: true });
                out.extend(pack(beams.collect(), zero, 1, Origins::Unknown)?);
            }
        }
        Ok(out)
    }
}

/// As `asbuilt load` does.
fn pack(beams: Vec<Beam>, origin: Vec3, station: i64, origins: Origins) -> Result<Vec<Vec<u8>>> {
    let content = Beams::of(beams);
    let patch = |tile: &Vec<u32>| {
        let own = content.select(tile);
        let spec = PatchSpec { origins, station, origin, spacing: own.spacing(origins), quantum: Patch::QUANTUM_M };
        Ok(Patch::pack(&spec, &own)?.to_bytes())
    };
    content.cut(origins, NEVER)?.par_iter().map(patch).collect()
}
