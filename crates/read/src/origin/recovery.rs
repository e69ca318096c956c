//! The origin of a scan from the order of its points.

use asbuilt_core::origin::recover;

use super::place::{KnownOrigin, OriginSource, placed};
use crate::RawScan;

/// The scan with its origin, where its points prove it; else why they do not.
pub fn recovered(mut scan: RawScan) -> RawScan {
    match recover(&scan.anchor, &scan.content.beams) {
        Ok(found) => {
            let p = found.position_world;
            scan.notes.push(format!(
                "its scanner's position {:.3} {:.3} {:.3} was recovered from the order of its points, to {:.3} m",
                p.x, p.y, p.z, found.sd
            ));
            let (source, sd) = (OriginSource::Recovered, Some(found.sd));
            placed(scan, KnownOrigin { source, position_world: p, sd })
        }
        Err(why) => {
            scan.notes.push(format!("its scanner's position was not recovered: {why}; loaded as points without origin"));
            scan
        }
    }
}
