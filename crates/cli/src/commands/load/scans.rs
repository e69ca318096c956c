//! Scans into `station` and `scan`, as the reading process sends them.

use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Aabb;
use indicatif::ProgressBar;
use postgres::Transaction;
use postgres::types::{ToSql, Type};

use super::{LoadArgs, shown, source};
use crate::database::connect::explain;
use crate::database::copy;
use crate::database::names::Names;
use crate::output::{count, progress, say};
use asbuilt_read::child::{Event, ReadingProcess, ScanHead};
use asbuilt_read::packing::Packed;
use asbuilt_read::{OriginSource, OriginsChoice};

pub fn load(args: &LoadArgs, file: &Path, names: &Names, tx: &mut Transaction) -> Result<()> {
    let source = source(file);
    let delete = names.sql("DELETE FROM @station WHERE source = $1::text AND epoch = $2::int4");
    let replaced = tx.execute(&delete, &[&source, &args.epoch]).map_err(explain)?;
    if replaced > 0 {
        say!("{source}: replaces {replaced} stations of epoch {} loaded before from a file of that name", args.epoch);
    }
    let bar = progress(&format!("reading {source}"), "points");
    let mut total = Total::default();
    let mut reader = ReadingProcess::start(args.reading.job(file))?;
    while let Some(event) = reader.next(&bar)? {
        let Event::Scan(head) = event else { bail!("{}: its reader sent no scan", file.display()) };
        head.notes.iter().for_each(|note| say!("  {}: {note}", head.name));
        if head.is_empty {
            say!("  {}: empty, passed over", head.name);
            continue;
        }
        let packed = StationLoader { args, source: &source, head: &head }.store(&mut reader, &bar, names, tx)?;
        if packed.beams == packed.no_returns {
            say!("  warning: {}: no return of it is left", head.name);
        }
        if let (Some(_), Some(given)) = (head.world_from_scan, args.reading.options.origin)
            && head.anchor != <[f64; 3]>::from(given)
        {
            say!("  {}: the file tells the scanner's position, which goes before --origin", head.name);
        }
        total.add(&head, &packed);
    }
    bar.finish_and_clear();
    total.report(args, file, &source)
}

/// A scanner position whose patches follow.
struct StationLoader<'a> {
    args: &'a LoadArgs,
    source: &'a str,
    head: &'a ScanHead,
}

impl StationLoader<'_> {
    fn store(
        self,
        reader: &mut ReadingProcess,
        bar: &ProgressBar,
        names: &Names,
        tx: &mut Transaction,
    ) -> Result<Packed> {
        let (station, epoch) = (self.insert(names, tx)?, self.args.epoch);
        reader.answer(station)?;
        let columns = [("station_id", Type::INT8), ("epoch", Type::INT4), ("patch", Type::BYTEA)];
        let mut copy = copy::start(tx, &names.table("scan"), &columns)?;
        loop {
            match reader.next(bar)?.context("its reader ended within a scan")? {
                Event::Patch(patch) => {
                    copy.write(&[&station, &epoch, &patch]).map_err(explain)?;
                }
                Event::Packed(packed) => return copy.finish().map(|_| packed).map_err(explain),
                Event::Scan(_) => bail!("its reader sent a scan within another"),
            }
        }
    }

    /// Inserts the row of the position; returns its number.
    fn insert(&self, names: &Names, tx: &mut Transaction) -> Result<i64> {
        let head = self.head;
        let translation = head.world_from_scan.map(|_| head.anchor.to_vec());
        let rotation = head.world_from_scan.map(|q| q.to_vec());
        let insert = names.sql(
            "INSERT INTO @station (epoch, name, pose, sensor, source, origin_source, origin_sd)
             VALUES ($1::int4, $2::text, @ext.ab_pose($3::float8[], $4::float8[], 1::float8, 0::float8, 0::float8,
                     0::float8, NULL::float8[]), $5::text, $6::text, $7::text, $8::float8) RETURNING id",
        );
        let text = |s: &str| s.replace('\0', "");
        let (name, sensor) = (text(&head.name), head.sensor.as_deref().map(text));
        let (origin_source, origin_sd) = (head.origin_source.map(OriginSource::name), head.origin_sd);
        let parameters: [&(dyn ToSql + Sync); 8] =
            [&self.args.epoch, &name, &translation, &rotation, &sensor, &self.source, &origin_source, &origin_sd];
        let row = tx.query_one(&insert, &parameters).map_err(explain)?;
        Ok(row.get(0))
    }
}

#[derive(Debug)]
struct Total {
    stations: u64,
    without_origin: u64,
    beams: u64,
    no_returns: u64,
    too_near: u64,
    unusable: u64,
    points: Aabb,
}

impl Default for Total {
    fn default() -> Self {
        Self { stations: 0, without_origin: 0, beams: 0, no_returns: 0, too_near: 0, unusable: 0, points: Aabb::EMPTY }
    }
}

impl Total {
    fn returns(&self) -> u64 {
        self.beams - self.no_returns
    }

    fn add(&mut self, scan: &ScanHead, packed: &Packed) {
        self.stations += 1;
        self.without_origin += u64::from(scan.world_from_scan.is_none());
        self.beams += packed.beams;
        self.no_returns += packed.no_returns;
        self.too_near += packed.too_near;
        self.unusable += scan.unusable;
        self.points = self.points.union(&packed.points);
    }

    /// Reports what was loaded; loading nothing is an error.
    fn report(&self, args: &LoadArgs, file: &Path, source: &str) -> Result<()> {
        if self.returns() == 0 {
            let why = match self.too_near {
                0 => "no beam of it returned".into(),
                n => format!("its {n} returns are all nearer than --min-range {} m", args.reading.min_range),
            };
            bail!("{}: nothing to load: {why}", file.display());
        }
        say!(
            "{source}: epoch {}, {} stations, {} beams, {} without return, {} too near (< {} m) dropped",
            args.epoch,
            self.stations,
            count(self.beams),
            count(self.no_returns),
            count(self.too_near),
            args.reading.min_range
        );
        say!("  box {}", shown(&self.points));
        if self.unusable > 0 {
            say!("  warning: {} points are not finite or impossibly far, and were dropped", self.unusable);
        }
        if self.without_origin > 0 {
            let way = match args.reading.options.origins {
                Some(OriginsChoice::None) => "",
                _ => "; give --origin x,y,z if they were scanned from one place, --origins FILE if from several",
            };
            say!(
                "  warning: {} of them without scanner position: their points say where something is, but never that a place is \
                 empty{way}",
                self.without_origin
            );
        }
        Ok(())
    }
}
