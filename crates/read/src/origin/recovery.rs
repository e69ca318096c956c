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
            scan.notes
                .push(format!("its scanner's position was not recovered: {why}; loaded as points without origin"));
            scan
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use asbuilt_core::geometry::Vec3;
    use asbuilt_core::scan::Beam;
    use indicatif::ProgressBar;

    use super::*;
    use crate::{ReadOptions, read_scans};

    /// Scans whose files tell the place: without it, it is recovered rightly, or not.
    #[test]
    fn places_of_the_field_are_recovered_rightly_or_not() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
        let mut scans = Vec::new();
        for file in ["real-room/scans.e57", "hall/epoch1.e57", "field/e57_two_stations_ok.e57"] {
            let file = folder.join(file);
            if !file.exists() {
                eprintln!("SKIPPED: {} is not there", file.display());
                continue;
            }
            read_scans(&file, &ReadOptions::default(), &ProgressBar::hidden(), &mut |scan| {
                scans.push(scan);
                Ok(())
            })
            .unwrap();
        }
        for scan in scans.iter().filter(|scan| scan.world_from_scan.is_some()) {
            let away = Vec3::new(3.0, -2.0, 1.0);
            let moved = |b: &Beam| Beam { offset: b.offset - away, ..*b };
            let beams: Vec<Beam> = scan.content.beams.iter().filter(|b| b.returned).map(moved).collect();
            let found = recover(&(scan.anchor + away), &beams);
            eprintln!("{}: {} points, {found:?}", scan.name, beams.len());
            if let Ok(found) = found {
                let off = (found.position_world - scan.anchor).amax();
                assert!(off <= 3.0 * found.sd, "{}: {off} m off, sd {} m", scan.name, found.sd);
            }
        }
    }
}
