//! XYZ, PTS and similar: one point per line. PTS puts the number of points before them, once or for each cloud.

use std::path::Path;

use anyhow::{Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Beam;
use indicatif::ProgressBar;

use super::planes::Planes;
use super::text::columns::Width;
use super::text::dialect::hint;
use super::text::doubt::uneven;
use super::text::head::{Layout, cut};
use super::text::title::is_comment;
use super::text::{Columns, Dialect, Head, Lines};
use super::unit::Unit;
use super::{Facts, ReadOptions, ScanSink, scan_of_content};

/// Reads points; titles and comments are skipped, a count is checked against the points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?;
    let head = Head::read(&mut lines, options)?;
    let dialect = head.dialect(options)?;
    let layout = head.layout(dialect, options)?;
    layout.check(options)?;
    let mut cloud = Cloud::new(dialect, &head, &layout, options)?;
    for (number, line) in &head.rows {
        cloud.add(line, *number)?;
    }
    loop {
        let number = lines.number() + 1;
        let Some(line) = lines.next()? else { break };
        cloud.add(line, number)?;
    }
    let mut notes = head.said(&layout, options);
    notes.extend(cloud.held_against_promise()?);
    // What the title says is done here, and not again by the option.
    let options = ReadOptions { file_unit: options.file_unit.filter(|_| layout.unit.is_none()), ..options.clone() };
    cloud.scale(layout.unit);
    let mut scan = scan_of_content(path, cloud.planes.content(cloud.points), &options)?;
    scan.notes.splice(0..0, notes);
    scan.facts = Facts::from([
        ("columns".into(), layout.columns.to_string()),
        ("numbers".into(), dialect.to_string()),
        ("unit".into(), layout.unit.map_or("not told", Unit::name).into()),
    ]);
    sink(scan)
}

/// Points as they are read.
struct Cloud<'a> {
    dialect: Dialect,
    head: &'a Head,
    columns: &'a Columns,
    /// Whether the coordinates come first, and nothing else is wanted.
    is_plain: bool,
    places: [usize; 3],
    /// Number and width of the first row.
    first: (u64, Width),
    /// The width every row must have where the user does not say which columns hold what.
    width: Option<Width>,
    points: Vec<Beam>,
    planes: Planes,
    promised: Option<u64>,
}

impl<'a> Cloud<'a> {
    fn new(dialect: Dialect, head: &'a Head, layout: &'a Layout, options: &ReadOptions) -> Result<Self> {
        let (columns, first) = (&layout.columns, layout.width);
        let places = columns.coordinates().ok_or_else(|| anyhow!("no columns of coordinates"))?;
        let (planes, is_plain) = (Planes::wanted(columns, options), *columns == Columns::plain());
        let width = options.columns.is_none().then_some(first.1);
        let (points, promised) = (Vec::new(), head.promised);
        Ok(Self { dialect, head, columns, is_plain, places, first, width, points, planes, promised })
    }

    fn add(&mut self, line: &str, number: u64) -> Result<()> {
        if line.is_empty() || is_comment(line) {
            return Ok(());
        }
        if self.is_plain
            && let Some(p) = self.plain(line)
        {
            self.points.push(Beam { offset: p.into(), returned: true });
            return Ok(());
        }
        if let (Some(before), Ok(count)) = (self.promised, line.parse::<u64>()) {
            self.promised = Some(before.saturating_add(count));
            return Ok(());
        }
        if self.head.repeats_title(line) {
            return Ok(());
        }
        let Some(dialect) = self.dialect.learn(line) else {
            bail!("line {number}: the commas of \"{}\" contradict those before", cut(line));
        };
        let words = dialect.words(line);
        let value = |place: usize| words.get(place).and_then(|w| dialect.value(w));
        let [Some(x), Some(y), Some(z)] = self.places.map(value) else {
            let way = hint(line, dialect.comma);
            bail!("line {number}: three coordinates expected, found \"{}\"{way}", cut(line));
        };
        let width = Width::of(&words);
        if self.must_be(line).is_some_and(|w| !w.fits(width)) {
            bail!("{}", uneven(self.first, (number, width)));
        }
        self.points.push(Beam { offset: Vec3::new(x, y, z), returned: true });
        self.planes.add(|column| self.columns.place(column).and_then(value));
        Ok(())
    }

    /// Checks the width that a line must have: with an empty cell between tabs its columns would have moved.
    fn must_be(&self, line: &str) -> Option<Width> {
        self.width.or_else(|| line.contains("\t\t").then_some(self.first.1))
    }

    /// The coordinates come first, separated as in the lines before.
    fn plain(&self, line: &str) -> Option<[f64; 3]> {
        let dialect = if line.contains(',') { self.dialect.learn(line)? } else { self.dialect };
        dialect.point(line, self.must_be(line))
    }

    fn scale(&mut self, unit: Option<Unit>) {
        let Some(unit) = unit.filter(|u| *u != Unit::M) else { return };
        self.points.iter_mut().for_each(|p| p.offset *= unit.metres());
    }

    /// A note where a PTS promises fewer points than it holds; an error where it promises more.
    fn held_against_promise(&self) -> Result<Vec<String>> {
        let held = self.points.len() as u64;
        match self.promised {
            Some(n) if n > held => bail!("it promises {n} points and holds {held}: cut short?"),
            Some(n) if n < held => Ok(vec![format!("it promises {n} points and holds {held}; all were read")]),
            _ => Ok(Vec::new()),
        }
    }
}
