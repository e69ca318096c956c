//! XYZ, PTS and their kin: a point a line. PTS puts the number of points before them, once or cloud by cloud.

use std::path::Path;

use anyhow::{Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Beam;
use indicatif::ProgressBar;

use super::planes::Planes;
use super::text::columns::doubt;
use super::text::dialect::{Comma, hint};
use super::text::{Columns, Dialect, Lines};
use super::{Facts, ReadOptions, Sink, scan_of_content};

/// Lines before the first point that are taken for titles.
const MOST_TITLES: usize = 50;
/// Lines by which separators, commas and columns are judged.
const SAMPLE: usize = 1000;

/// Reads points; titles and comments are passed over, a count is held against the points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?;
    let head = Head::read(&mut lines, options)?;
    let dialect = head.dialect(options)?;
    let columns = head.columns(dialect, options)?;
    let mut cloud = Cloud::new(dialect, &columns, options)?;
    cloud.promised = head.promised;
    for (number, line) in &head.rows {
        cloud.add(line, *number)?;
    }
    loop {
        let number = lines.number() + 1;
        let Some(line) = lines.next()? else { break };
        cloud.add(line, number)?;
    }
    let mut notes = head.said(&columns, options);
    notes.extend(cloud.held_against_promise()?);
    let mut scan = scan_of_content(path, cloud.planes.content(cloud.points), options)?;
    scan.notes.splice(0..0, notes);
    scan.facts = Facts::from([
        ("columns".into(), columns.to_string()),
        ("numbers".into(), dialect.to_string()),
        ("unit".into(), "not told".into()),
    ]);
    sink(scan)
}

/// The beginning of a file: titles, then the first lines of points.
#[derive(Default)]
struct Head {
    titles: Vec<String>,
    /// Comment or title that may name the columns.
    naming: Vec<String>,
    promised: Option<u64>,
    /// With the numbers of their lines.
    rows: Vec<(u64, String)>,
}

impl Head {
    fn read(lines: &mut Lines, options: &ReadOptions) -> Result<Self> {
        let mut head = Self::default();
        while head.rows.len() < SAMPLE {
            let Some(line) = lines.next()? else { break };
            let line = line.to_owned();
            if line.is_empty() {
                continue;
            }
            if is_comment(&line) {
                head.naming.push(line);
            } else if !head.rows.is_empty() || is_row(&line, options) {
                head.rows.push((lines.number(), line));
            } else if let Ok(count) = line.parse::<u64>() {
                head.promised = Some(head.promised.unwrap_or(0).saturating_add(count));
            } else {
                head.naming.push(line.clone());
                head.titles.push(line);
                if head.titles.len() > MOST_TITLES {
                    break;
                }
            }
        }
        if head.rows.is_empty() {
            return Err(head.no_points(options));
        }
        Ok(head)
    }

    fn no_points(&self, options: &ReadOptions) -> anyhow::Error {
        let Some(first) = self.titles.first() else { return anyhow!("it holds no points") };
        let wanted = options.columns.as_ref().map_or("three coordinates".into(), |c| format!("columns {c}"));
        let way = match hint(first) {
            "" if options.columns.is_none() => {
                "; where the coordinates do not stand first, say which columns hold what, e.g. --columns n,x,y,z"
            }
            other => other,
        };
        anyhow!("none of its first {} lines has {wanted}; the first is \"{}\"{way}", self.titles.len(), cut(first))
    }

    /// What the sample says about separators and commas, all lines together.
    fn dialect(&self, options: &ReadOptions) -> Result<Dialect> {
        let comma = options.decimal_comma.then_some(Comma::Decimal);
        let mut dialect = Dialect { comma, ..Dialect::default() };
        for (number, line) in &self.rows {
            let Some(learnt) = dialect.learn(line) else {
                bail!("line {number}: the commas of \"{}\" contradict one another", cut(line));
            };
            dialect = learnt;
        }
        Ok(dialect)
    }

    fn columns(&self, dialect: Dialect, options: &ReadOptions) -> Result<Columns> {
        if let Some(given) = &options.columns {
            return Ok(given.clone());
        }
        let words = |(_, line): &(u64, String)| {
            dialect.learn(line).unwrap_or(dialect).words(line).iter().map(|&w| w.to_owned()).collect()
        };
        let points: Vec<Vec<String>> =
            self.rows.iter().filter(|(_, line)| line.parse::<u64>().is_err()).map(words).collect();
        let width = points.first().map_or(0, Vec::len);
        if let Some(named) = self.naming.iter().rev().find_map(|t| Columns::of_title(t, width)) {
            if named.are_turned() {
                bail!(
                    "its title names the columns {named}: does x go north there? Say which is which with --columns, e.g. --columns {named} or x,y,z"
                );
            }
            return Ok(named);
        }
        match doubt(&points, &dialect) {
            Some(why) => bail!("line {}: \"{}\": {why}", self.rows[0].0, cut(&self.rows[0].1)),
            None => Ok(Columns::plain()),
        }
    }

    fn said(&self, columns: &Columns, options: &ReadOptions) -> Vec<String> {
        let mut out = Vec::new();
        if !self.titles.is_empty() {
            out.push(format!("{} title lines passed over, the first \"{}\"", self.titles.len(), cut(&self.titles[0])));
        }
        if options.columns.is_none() && *columns != Columns::plain() {
            out.push(format!("columns as its title names them: {columns}"));
        }
        out
    }
}

fn is_comment(line: &str) -> bool {
    line.starts_with(['#', '/', '%', '!'])
}

/// Whether a line can be a point: numbers where the coordinates stand.
fn is_row(line: &str, options: &ReadOptions) -> bool {
    let plain = Columns::plain();
    let columns = options.columns.as_ref().unwrap_or(&plain);
    let comma = options.decimal_comma.then_some(Comma::Decimal);
    let Some(dialect) = (Dialect { comma, ..Dialect::default() }).learn(line) else { return false };
    let words = dialect.words(line);
    let is_number = |place: usize| {
        words.get(place).is_some_and(|w| dialect.value(w).is_some() || super::text::dialect::is_ambiguous(w))
    };
    columns.coordinates().is_some_and(|places| places.into_iter().all(is_number))
}

/// A line to quote.
fn cut(line: &str) -> String {
    const LONGEST: usize = 80;
    if line.chars().count() <= LONGEST { line.into() } else { line.chars().take(LONGEST).chain(['…']).collect() }
}

/// Points as they are read.
struct Cloud<'a> {
    dialect: Dialect,
    columns: &'a Columns,
    /// Coordinates first, and nothing else that is wanted.
    is_plain: bool,
    places: [usize; 3],
    points: Vec<Beam>,
    planes: Planes,
    promised: Option<u64>,
}

impl<'a> Cloud<'a> {
    fn new(dialect: Dialect, columns: &'a Columns, options: &ReadOptions) -> Result<Self> {
        let places = columns.coordinates().ok_or_else(|| anyhow!("no columns of coordinates"))?;
        let (planes, is_plain) = (Planes::wanted(columns, options), *columns == Columns::plain());
        Ok(Self { dialect, columns, is_plain, places, points: Vec::new(), planes, promised: None })
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
        let Some(dialect) = self.dialect.learn(line) else {
            bail!("line {number}: the commas of \"{}\" contradict those before", cut(line));
        };
        let words = dialect.words(line);
        let value = |place: usize| words.get(place).and_then(|w| dialect.value(w));
        let [Some(x), Some(y), Some(z)] = self.places.map(value) else {
            bail!("line {number}: three coordinates expected, found \"{}\"{}", cut(line), hint(line));
        };
        self.points.push(Beam { offset: Vec3::new(x, y, z), returned: true });
        self.planes.add(|column| self.columns.place(column).and_then(value));
        Ok(())
    }

    /// Coordinates first, parted as the lines before.
    fn plain(&self, line: &str) -> Option<[f64; 3]> {
        let dialect = if line.contains(',') { self.dialect.learn(line)? } else { self.dialect };
        dialect.numbers::<3>(line)
    }

    /// A word where a PTS promises less than it holds; an error where it promises more.
    fn held_against_promise(&self) -> Result<Vec<String>> {
        let held = self.points.len() as u64;
        match self.promised {
            Some(n) if n > held => bail!("it promises {n} points and holds {held}: cut short?"),
            Some(n) if n < held => Ok(vec![format!("it promises {n} points and holds {held}; all were read")]),
            _ => Ok(Vec::new()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_to_quote_are_cut() {
        assert_eq!(cut("1 2 3"), "1 2 3");
        assert_eq!(cut(&"ä".repeat(100)).chars().count(), 81);
    }

    #[test]
    fn rows_are_told_from_titles() {
        let is = |line| is_row(line, &ReadOptions::default());
        assert!(is("1 2 3") && is("1,5;2,5;3,5") && is("1,234 2,345 3,456"));
        assert!(!is("Project: hall") && !is("12") && !is("P1 1 2 3"));
        let named = ReadOptions { columns: Some("n,x,y,z".parse().unwrap()), ..ReadOptions::default() };
        assert!(is_row("P1 1 2 3", &named) && !is_row("1 2 3", &named));
    }
}
