//! What becomes of the origin of every scan of a file.

use anyhow::Result;

use super::attribution::{Attribution, by_source};
use super::choice::OriginsChoice;
use super::judge::judged;
use super::listing::Listing;
use super::place::without_origin;
use super::recovery::recovered;
use crate::{RawScan, ReadOptions, ScanSink};

/// Settles the origins of the scans of one file, in their order.
pub struct Settler<'a> {
    options: &'a ReadOptions,
    listed: Option<Attribution>,
}

impl<'a> Settler<'a> {
    pub fn new(options: &'a ReadOptions) -> Result<Self> {
        let listed = match &options.origins {
            Some(OriginsChoice::Listed(file)) => Some(Attribution::new(Listing::read(file)?)),
            _ => None,
        };
        Ok(Self { options, listed })
    }

    /// Hands on the scan, or several where its points were measured from several places.
    pub fn settle(&mut self, scan: RawScan, sink: ScanSink) -> Result<()> {
        if self.options.origins == Some(OriginsChoice::None) {
            return sink(judged(told_to_have_none(scan), self.options));
        }
        let (options, scan) = (self.options, judged(scan, self.options));
        match &mut self.listed {
            Some(listed) if scan.world_from_scan.is_some() => sink(listed.keep(scan)),
            Some(listed) => listed.attribute(scan, &mut |scan| sink(judged(scan, options))),
            None if scan.world_from_scan.is_none() && options.origins == Some(OriginsChoice::Recover) => {
                by_source(scan, &mut |scan| sink(judged(recovered(scan), options)))
            }
            None => sink(scan),
        }
    }

    /// Fails where the listing was of no use.
    pub fn finish(&self) -> Result<()> {
        self.listed.as_ref().map_or(Ok(()), Attribution::finish)
    }
}

fn told_to_have_none(scan: RawScan) -> RawScan {
    if scan.world_from_scan.is_none() {
        return scan;
    }
    let mut scan = without_origin(scan);
    scan.notes.push("the scanner's position that the file tells was left out (--origins none)".into());
    scan
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use asbuilt_core::geometry::Vec3;
    use asbuilt_core::scan::{Beam, Beams};
    use indicatif::ProgressBar;

    use super::*;
    use crate::{OriginSource, read_scans};

    /// A file in a folder of its own, with a listing beside it.
    struct Delivery(PathBuf);

    impl Delivery {
        fn new(name: &str, listing: &str) -> Self {
            let folder = std::env::temp_dir().join(format!("asbuilt-settle-{name}-{}", std::process::id()));
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(folder.join("stations.csv"), listing).unwrap();
            Self(folder)
        }

        fn options(&self) -> ReadOptions {
            ReadOptions { origins: Some(OriginsChoice::Listed(self.0.join("stations.csv"))), ..ReadOptions::default() }
        }

        fn read(&self, file: &str) -> Result<Vec<RawScan>> {
            let mut scans = Vec::new();
            read_scans(&self.0.join(file), &self.options(), &ProgressBar::hidden(), &mut |scan| {
                scans.push(scan);
                Ok(())
            })?;
            Ok(scans)
        }

        /// LAS of five points a source, each at x = its source.
        fn las(&self, sources: &[u16], format: u8) -> PathBuf {
            let mut builder = las::Builder::from((1, 4));
            builder.point_format = las::point::Format::new(format).unwrap();
            let file = self.0.join("tripods.las");
            let mut writer = las::Writer::from_path(&file, builder.into_header().unwrap()).unwrap();
            for (y, source) in (0..5).flat_map(|y| sources.iter().map(move |s| (y, *s))) {
                let gps_time = (format > 5).then_some(0.0);
                let (x, y, z) = (f64::from(source), f64::from(y), 1.0);
                writer
                    .write_point(las::Point { x, y, z, point_source_id: source, gps_time, ..Default::default() })
                    .unwrap();
            }
            writer.close().unwrap();
            file
        }
    }

    impl Drop for Delivery {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    fn said(result: Result<Vec<RawScan>>) -> String {
        result.map_or_else(|e| format!("{e:#}"), |scans| format!("read: {scans:?}"))
    }

    #[test]
    fn points_of_las_go_to_the_stations_of_their_ids() {
        let delivery = Delivery::new("las", "station,x,y,z,sd\n2,20,0,1.5,0.004\n7,70,0,1.5\n99,0,0,0\n");
        for format in [0, 6] {
            delivery.las(&[7, 2, 5], format);
            let scans = delivery.read("tripods.las").unwrap();
            let named: Vec<&str> = scans.iter().map(|s| s.name.as_str()).collect();
            assert_eq!(named, ["tripods 2", "tripods 7", "tripods"]);
            for (scan, x) in scans.iter().zip([2.0, 7.0, 5.0]) {
                assert_eq!(scan.content.len(), 5);
                assert!(scan.content.beams.iter().all(|b| (scan.anchor.x + b.offset.x - x).abs() < 1e-6), "{scan:?}");
            }
            assert_eq!((scans[0].anchor, scans[0].origin_sd), (Vec3::new(20.0, 0.0, 1.5), Some(0.004)));
            assert_eq!((scans[1].origin_source, scans[1].origin_sd), (Some(OriginSource::Given), None));
            assert!(scans[2].world_from_scan.is_none() && scans[2].notes[0].contains("point source ids 5"));
            // Only other ids.
            delivery.las(&[3, 4], format);
            let said = said(delivery.read("tripods.las"));
            assert!(said.contains("ids 3, 4") && said.contains("stations 2, 7, 99"), "{said}");
            // None at all.
            delivery.las(&[0], format);
            assert!(self::said(delivery.read("tripods.las")).contains("cannot be told apart"));
        }
    }

    #[test]
    fn single_clouds_go_by_their_file_or_to_the_one_station() {
        let delivery = Delivery::new("single", "north,1,2,3\nsouth,4,5,6\n");
        std::fs::write(delivery.0.join("South.xyz"), "1 2 3\n1.5 2 3\n").unwrap();
        std::fs::write(delivery.0.join("all.xyz"), "1 2 3\n1.5 2 3\n").unwrap();
        assert_eq!(delivery.read("South.xyz").unwrap()[0].anchor, Vec3::new(4.0, 5.0, 6.0));
        let said = said(delivery.read("all.xyz"));
        assert!(said.contains("cannot be told apart") && said.contains("north, south"), "{said}");
        std::fs::write(delivery.0.join("stations.csv"), "north 1 2 3\n").unwrap();
        let scans = delivery.read("all.xyz").unwrap();
        assert_eq!(scans[0].anchor, Vec3::new(1.0, 2.0, 3.0));
        assert!(scans[0].notes[0].contains("the one station"), "{:?}", scans[0].notes);
        // An origin at zero is as good as any; one that is hardly known is none.
        std::fs::write(delivery.0.join("stations.csv"), "north 0 0 0\n").unwrap();
        assert!(delivery.read("all.xyz").unwrap()[0].world_from_scan.is_some());
        std::fs::write(delivery.0.join("stations.csv"), "north 1 2 3 0.1\n").unwrap();
        let scans = delivery.read("all.xyz").unwrap();
        assert!(scans[0].world_from_scan.is_none() && scans[0].origin_source.is_none());
        assert!(scans[0].notes[1].contains("0.10 m"), "{:?}", scans[0].notes);
        let first = scans[0].anchor + scans[0].content.beams[0].offset;
        assert!((first - Vec3::new(1.0, 2.0, 3.0)).norm() < 1e-9);
    }

    /// Scans of one file as its format would give them.
    fn settled(listing: &str, scans: &[(&str, bool)]) -> Result<Vec<RawScan>> {
        let delivery = Delivery::new(&format!("scans{}", listing.len()), listing);
        let options = delivery.options();
        let (mut settler, mut out) = (Settler::new(&options)?, Vec::new());
        for (name, has_origin) in scans {
            let content = Beams::of(vec![Beam { offset: Vec3::new(3.0, 0.0, 0.0), returned: true }]);
            let scan = RawScan {
                name: (*name).into(),
                world_from_scan: has_origin.then_some(crate::NO_ROTATION),
                origin_source: has_origin.then_some(OriginSource::File),
                anchor: Vec3::new(9.0, 9.0, 9.0),
                content,
                scans_in_file: Some(scans.len() as u64),
                ..RawScan::default()
            };
            settler.settle(scan, &mut |scan| {
                out.push(scan);
                Ok(())
            })?;
        }
        settler.finish().map(|()| out)
    }

    #[test]
    fn scans_of_one_file_go_by_name_or_number() {
        let places =
            |scans: Vec<RawScan>| scans.iter().map(|s| s.origin_source.map(|_| s.anchor.x)).collect::<Vec<_>>();
        let named =
            settled("hall,1,0,0\ncellar,2,0,0\n", &[("Cellar", false), ("roof", false), ("hall", true)]).unwrap();
        assert!(named[1].notes[0].contains("not in the listing"), "{:?}", named[1].notes);
        assert!(named[2].notes[0].contains("goes before --origins"), "{:?}", named[2].notes);
        assert_eq!(places(named), [Some(2.0), None, Some(9.0)]);
        let numbered = settled("1,1,0,0\n2,2,0,0\n", &[("file #1", false), ("file #2", false)]).unwrap();
        assert_eq!(places(numbered), [Some(1.0), Some(2.0)]);
        // A scan that is called 2 is the second, wherever it stands.
        let turned = settled("2,2,0,0\n1,1,0,0 #\n", &[("2", false), ("1", false)]).unwrap();
        assert_eq!(places(turned), [Some(2.0), Some(1.0)]);
        let said = said(settled("x,1,0,0\ny,2,0,0\n", &[("a", false), ("b", false)]));
        assert!(said.contains("called a, b") && said.contains("stations x, y"), "{said}");
    }

    #[test]
    fn none_is_none() {
        let options = ReadOptions { origins: Some(OriginsChoice::None), ..ReadOptions::default() };
        let beams = [(2.5, true), (1.0, false)].map(|(x, returned)| Beam { offset: Vec3::new(x, 0.0, 0.0), returned });
        let scan = RawScan {
            world_from_scan: Some(crate::NO_ROTATION),
            origin_source: Some(OriginSource::File),
            anchor: Vec3::new(10.0, 0.0, 0.0),
            content: Beams::of(beams.to_vec()),
            ..RawScan::default()
        };
        let mut out = Vec::new();
        let mut settler = Settler::new(&options).unwrap();
        settler
            .settle(scan, &mut |scan| {
                out.push(scan);
                Ok(())
            })
            .unwrap();
        assert!(out[0].world_from_scan.is_none() && out[0].origin_source.is_none() && out[0].content.len() == 1);
        assert!((out[0].anchor + out[0].content.beams[0].offset - Vec3::new(12.5, 0.0, 0.0)).norm() < 1e-12);
        assert!(out[0].notes[0].contains("--origins none"), "{:?}", out[0].notes);
    }
}
