//! LAS and LAZ, through the `las` crate. Without `--origin` or `--origins` the points have none.

mod check;
mod crs;
mod mend;
mod wkt;

use std::fs::File;
use std::io::Seek;
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams};
use indicatif::ProgressBar;
use las::{Header, PointData, PointDataBuilder, Reader, ReaderOptions};

use super::{Facts, OriginsChoice, ReadOptions, ScanSink, scan_of_sources};

/// Points read at a time: several LAZ chunks, so that they decompress in parallel; fewer if records are long.
const AT_ONCE: u64 = 500_000;
const BYTES_AT_ONCE: u64 = 64 << 20;

/// Reads all points except those withheld and, unless they are wanted, noise.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let (mut file, mut notes) = mend::open(File::open(path).context("cannot open it")?)?;
    let check::Checked { count, parallelism, more } = check::check(&mut file)?;
    file.rewind()?;
    bar.set_length(count);
    let serial = ReaderOptions::default().with_laz_parallelism(parallelism);
    let mut reader = Reader::with_options(file, serial).context("not a readable LAS file")?;
    let (factors, said) = crs::factors(crs::units(reader.header())?, options.file_unit)?;
    notes.extend(said);
    let facts = facts(reader.header());
    let mut points = Points::new(reader.header().point_format().is_extended, factors, options);
    let mut data = PointDataBuilder::new().for_header(reader.header()).build();
    let at_once = AT_ONCE.min(BYTES_AT_ONCE / u64::from(reader.header().point_format().len()).max(1));
    while points.read < count {
        let got = reader.fill_points(at_once, &mut data).context("its points are damaged")?;
        if got == 0 {
            bail!("it ends after {} of {count} points", points.read);
        }
        points.add(&data, options);
        bar.inc(got);
    }
    if more > 0 {
        notes.push(format!("its head counts {count} points; the file has room for {more} more, which were not read"));
    }
    notes.extend(points.said());
    if points.dropped.len() as u64 == count && count > 0 {
        bail!("it holds no points but {}", points.said().join(" and "));
    }
    // Its units are known by now.
    let options = ReadOptions { file_unit: None, ..options.clone() };
    let (content, point_sources) = points.content();
    let mut scan = scan_of_sources(path, content, point_sources, &options)?;
    scan.notes.splice(0..0, notes);
    scan.facts = facts;
    sink(scan)
}

/// Version, format, units, attributes and day.
fn facts(header: &Header) -> Facts {
    let format = header.point_format();
    let attributes = [
        ("gps time", format.has_gps_time),
        ("colour", format.has_color),
        ("near infrared", format.has_nir),
        ("waveform", format.has_waveform),
    ];
    let attributes: Vec<&str> = attributes.iter().filter(|(_, has)| *has).map(|(name, _)| *name).collect();
    let mut out = Facts::from([
        ("version".into(), header.version().to_string()),
        ("points".into(), header.number_of_points().to_string()),
        ("attributes".into(), attributes.join(", ")),
        ("software".into(), header.generating_software().trim().to_owned()),
        ("compressed".into(), format.is_compressed.to_string()),
    ]);
    if let Ok(units) = crs::units(header) {
        let named = |metres: Option<f64>| metres.map_or("not told".into(), super::unit::called);
        out.insert("unit".into(), named(units.across));
        out.insert("unit of heights".into(), named(units.up));
    }
    if let Some(date) = header.date() {
        out.insert("created".into(), date.to_string());
    }
    out.retain(|_, text| !text.is_empty());
    out
}

/// Points as they are read.
struct Points {
    is_extended: bool,
    factors: [f64; 3],
    content: Beams,
    colours: Vec<[u16; 3]>,
    /// Point source ids, where origins are sought by them.
    sources: Option<Vec<u16>>,
    read: u64,
    /// Indices of points to leave out, and how many of them are withheld.
    dropped: Vec<u32>,
    withheld: u64,
    noise: u64,
    keep_noise: bool,
}

/// Low points (noise) and high noise.
const NOISE: [u8; 2] = [7, 18];

impl Points {
    fn new(is_extended: bool, factors: [f64; 3], options: &ReadOptions) -> Self {
        let content = Beams { intensity: options.intensity.then(Vec::new), ..Beams::default() };
        let (colours, dropped) = (Vec::new(), Vec::new());
        let sources = matches!(options.origins, Some(OriginsChoice::Listed(_) | OriginsChoice::Recover)).then(Vec::new);
        Self {
            is_extended,
            factors,
            content,
            colours,
            sources,
            read: 0,
            dropped,
            withheld: 0,
            noise: 0,
            keep_noise: options.keep_noise,
        }
    }

    fn add(&mut self, data: &PointData, options: &ReadOptions) {
        let (t, [fx, fy, fz]) = (*data.transforms(), self.factors);
        // In every point format a record starts with x, y, z as 32-bit integers.
        for record in data.raw_bytes().chunks_exact(data.record_len()) {
            let coordinate = |at: usize| i32::from_le_bytes(std::array::from_fn(|k| record[at + k]));
            let offset = Vec3::new(
                t.x.direct(coordinate(0)) * fx,
                t.y.direct(coordinate(4)) * fy,
                t.z.direct(coordinate(8)) * fz,
            );
            self.content.beams.push(Beam { offset, returned: true });
            let at = if self.is_extended { 20 } else { 18 };
            self.sources.iter_mut().for_each(|s| s.push(u16::from_le_bytes([record[at], record[at + 1]])));
            self.judge(record);
        }
        self.content.intensity.iter_mut().for_each(|plane| plane.extend(data.intensity()));
        if let (true, Some(some)) = (options.colour, data.rgb()) {
            self.colours.extend(some.map(|(r, g, b)| [r, g, b]));
        }
    }

    /// Records whether the point is to be left out.
    fn judge(&mut self, record: &[u8]) {
        // Class and flags share a byte in formats 0 to 5.
        let (is_withheld, class) =
            if self.is_extended { (record[15] & 4 != 0, record[16]) } else { (record[15] & 128 != 0, record[15] & 31) };
        let is_noise = NOISE.contains(&class);
        self.withheld += u64::from(is_withheld);
        self.noise += u64::from(is_noise && !is_withheld);
        if is_withheld || is_noise && !self.keep_noise {
            self.dropped.push(self.read as u32);
        }
        self.read += 1;
    }

    fn said(&self) -> Vec<String> {
        let mut out = Vec::new();
        if self.withheld > 0 {
            out.push(format!("{} withheld points dropped", self.withheld));
        }
        match (self.noise, self.keep_noise) {
            (0, _) => {}
            (n, true) => out.push(format!("{n} points classified as noise (7, 18) kept")),
            (n, false) => out.push(format!("{n} points classified as noise (7, 18) dropped; --keep-noise keeps them")),
        }
        out
    }

    /// What is not left out, with its point source ids.
    fn content(mut self) -> (Beams, Option<Vec<u16>>) {
        // The format wants sixteen bits a part; many writers fill eight.
        let shift = if self.colours.iter().flatten().any(|&part| part > 255) { 8 } else { 0 };
        let eight = |c: &[u16; 3]| c.map(|part| (part >> shift) as u8);
        self.content.colour = (!self.colours.is_empty()).then(|| self.colours.iter().map(eight).collect());
        if self.dropped.is_empty() {
            return (self.content, self.sources);
        }
        let mut dropped = self.dropped.iter().peekable();
        let kept: Vec<u32> = (0..self.content.len() as u32).filter(|i| dropped.next_if_eq(&i).is_none()).collect();
        let sources = self.sources.map(|all| kept.iter().map(|&i| all[i as usize]).collect());
        (self.content.select(&kept), sources)
    }
}
