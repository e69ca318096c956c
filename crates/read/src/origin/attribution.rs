//! Which points were measured from which listed position: by the point source ids of LAS, else by the name of the scan,
//! else by its number in the file.
//!
//! What cannot be told is an error: a position for points that were measured from elsewhere would prove away what stands.

use std::collections::BTreeMap;

use anyhow::{Result, bail};

use super::listing::{ListedStation, Listing, some};
use super::place::{KnownOrigin, OriginSource, placed};
use crate::{RawScan, ScanSink};

/// The scans of a file and the positions of a listing.
pub struct Attribution {
    listing: Listing,
    /// Number of scans so far.
    scans: u64,
    has_matched: bool,
    unmatched: Vec<String>,
}

/// Indices of a scan's points by point source id.
type PointsById = BTreeMap<u16, Vec<u32>>;

impl Attribution {
    pub fn new(listing: Listing) -> Self {
        Self { listing, scans: 0, has_matched: false, unmatched: Vec::new() }
    }

    /// A scan that the file itself gives an origin counts, and keeps it.
    pub fn keep(&mut self, mut scan: RawScan) -> RawScan {
        self.scans += 1;
        if self.named(&scan.name).is_some() {
            self.has_matched = true;
            scan.notes.push("the file tells the scanner's position, which goes before --origins".into());
        }
        scan
    }

    /// Hands on points without origin with the origins that are listed for them: as one scan or, by their ids, as several.
    pub fn attribute(&mut self, mut scan: RawScan, sink: ScanSink) -> Result<()> {
        self.scans += 1;
        let by_id = points_by_id(&mut scan);
        if self.listing.stations.iter().any(|s| id(s).is_some_and(|id| by_id.contains_key(&id))) {
            self.has_matched = true;
            return self.split(scan, by_id, sink);
        }
        if let Some(station) = self.station_of(&mut scan, &by_id)? {
            self.has_matched = true;
            return sink(placed(scan, known(&station)));
        }
        self.unmatched.push(scan.name.clone());
        scan.notes.push("not in the listing of --origins; loaded as points without origin".into());
        sink(scan)
    }

    /// Fails where nothing was found in the listing.
    pub fn finish(&self) -> Result<()> {
        if self.has_matched || self.unmatched.is_empty() {
            return Ok(());
        }
        bail!(
            "its scans are called {}; --origins lists the stations {}: none is the same; name the stations as the scans",
            some(self.unmatched.iter().cloned()),
            self.listing.shown()
        )
    }

    /// A scan a listed station, and one of all points whose ids are not listed.
    fn split(&self, scan: RawScan, mut by_id: PointsById, sink: ScanSink) -> Result<()> {
        let mut notes = scan.notes.clone();
        for station in &self.listing.stations {
            let Some(points) = id(station).and_then(|id| by_id.remove(&id)) else { continue };
            let mut part = part(&scan, &points, format!("{} {}", scan.name, station.name));
            part.notes.append(&mut notes);
            sink(placed(part, known(station)))?;
        }
        if by_id.is_empty() {
            return Ok(());
        }
        let mut rest: Vec<u32> = by_id.values().flatten().copied().collect();
        rest.sort_unstable();
        let mut left = part(&scan, &rest, scan.name.clone());
        left.notes.push(format!(
            "{} points have the point source ids {}, which --origins does not list; loaded as points without origin",
            rest.len(),
            ids(&by_id)
        ));
        sink(left)
    }

    fn station_of(&self, scan: &mut RawScan, by_id: &PointsById) -> Result<Option<ListedStation>> {
        if let Some(station) = self.named(&scan.name) {
            return Ok(Some(station.clone()));
        }
        match (scan.scans_in_file, &self.listing.stations[..]) {
            (Some(1), [only]) if by_id.len() <= 1 && id(only).is_none_or(|_| is_unset(by_id)) => {
                scan.notes.push(format!("taken for scanned from the one station that --origins lists, {}", only.name));
                Ok(Some(only.clone()))
            }
            (Some(1), _) => bail!("{}", self.indistinct(by_id)),
            // A scan that is called 2 is not the station 1 because it comes first.
            (Some(_), stations) if scan.name.trim().parse::<u64>().is_err() => {
                Ok(stations.iter().find(|s| s.number() == Some(self.scans)).cloned())
            }
            _ => Ok(None),
        }
    }

    fn named(&self, name: &str) -> Option<&ListedStation> {
        self.listing.stations.iter().find(|s| s.name.to_lowercase() == name.trim().to_lowercase())
    }

    /// Why the points of a single scan cannot be given to the stations, and the way out.
    fn indistinct(&self, by_id: &PointsById) -> String {
        let listed = self.listing.shown();
        if is_unset(by_id) {
            return format!(
                "its points cannot be told apart (they carry no point source ids), and --origins lists {} stations: {listed}; \
                 give a file a station, named as in the listing, or LAS with the stations as point source ids, or load it \
                 with --origins none",
                self.listing.stations.len()
            );
        }
        format!(
            "its points have the point source ids {}; --origins lists the stations {listed}: none is the same; list the \
             ids as stations",
            ids(by_id)
        )
    }
}

/// Hands on the scan, or one for each point source id where it has several.
pub fn by_source(mut scan: RawScan, sink: ScanSink) -> Result<()> {
    let by_id = points_by_id(&mut scan);
    if by_id.len() < 2 {
        return sink(scan);
    }
    let mut notes = std::mem::take(&mut scan.notes);
    for (id, points) in by_id {
        let mut part = part(&scan, &points, format!("{} {id}", scan.name));
        part.notes.append(&mut notes);
        sink(part)?;
    }
    Ok(())
}

fn known(station: &ListedStation) -> KnownOrigin {
    KnownOrigin { source: OriginSource::Given, position_world: station.position_world, sd: station.sd }
}

/// A station as a point source id; 0 is that of points which have none.
fn id(station: &ListedStation) -> Option<u16> {
    station.number().and_then(|n| u16::try_from(n).ok()).filter(|id| *id != 0)
}

fn ids(by_id: &PointsById) -> String {
    some(by_id.keys().map(u16::to_string))
}

/// Whether no point has an id.
fn is_unset(by_id: &PointsById) -> bool {
    by_id.keys().all(|id| *id == 0)
}

fn points_by_id(scan: &mut RawScan) -> PointsById {
    let mut out = PointsById::new();
    for (i, id) in scan.point_sources.take().unwrap_or_default().into_iter().enumerate() {
        out.entry(id).or_default().push(i as u32);
    }
    out
}

/// Some points of a scan under a name of their own.
fn part(scan: &RawScan, points: &[u32], name: String) -> RawScan {
    let (content, notes) = (scan.content.select(points), Vec::new());
    let (sensor, facts) = (scan.sensor.clone(), scan.facts.clone());
    RawScan { name, sensor, content, notes, facts, point_sources: None, unusable: 0, ..*scan }
}
