//! A scan gets its origin, or loses it. Its points stay where they are.

use asbuilt_core::geometry::Vec3;
use serde::{Deserialize, Serialize};

use crate::{NO_ROTATION, RawScan};

/// Who says where the scanner stood.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum OriginSource {
    /// The file of the scans.
    File,
    /// The user: `--origin`, or a listing.
    Given,
    /// The order of the points.
    Recovered,
}

impl OriginSource {
    /// As it stands in the column `station.origin_source`.
    pub fn name(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Given => "given",
            Self::Recovered => "recovered",
        }
    }
}

/// An origin that is known no better than this (standard deviation, metres) is not used: beams from a place beside the
/// true one pass through edges of what stands there, and would prove it away.
const MAX_ORIGIN_SD_M: f64 = 0.1;

/// A place where a scanner stood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownOrigin {
    pub source: OriginSource,
    /// World metres.
    pub position_world: Vec3,
    /// Standard deviation an axis, metres, where it is known.
    pub sd: Option<f64>,
}

/// Points without origin get one, if it is known well enough.
pub fn placed(mut scan: RawScan, origin: KnownOrigin) -> RawScan {
    if let Some(sd) = origin.sd.filter(|sd| *sd >= MAX_ORIGIN_SD_M) {
        scan.notes.push(format!(
            "its origin is known to {sd:.2} m (standard deviation), and must be to less than {MAX_ORIGIN_SD_M} m to prove \
             that a place is empty; loaded as points without origin"
        ));
        return scan;
    }
    move_anchor(&mut scan, origin.position_world);
    scan.world_from_scan = Some(NO_ROTATION);
    (scan.origin_source, scan.origin_sd) = (Some(origin.source), origin.sd);
    scan
}

/// The scan's points without origin, relative to a place near them.
pub fn without_origin(mut scan: RawScan) -> RawScan {
    scan.retain(|b| b.returned);
    let near = scan.content.beams.first().map_or(scan.anchor, |b| scan.anchor + b.offset.map(f64::round));
    move_anchor(&mut scan, near);
    scan.world_from_scan = None;
    (scan.origin_source, scan.origin_sd) = (None, None);
    scan
}

fn move_anchor(scan: &mut RawScan, to_world: Vec3) {
    let shift = scan.anchor - to_world;
    scan.content.beams.iter_mut().for_each(|b| b.offset += shift);
    scan.anchor = to_world;
}
