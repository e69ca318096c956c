//! The beginning of a text of points: its titles, and what they and the first rows say about everything that follows.

use anyhow::{Result, anyhow, bail};

use super::columns::Width;
use super::dialect::{Dialect, Separator, hint, is_ambiguous};
use super::doubt::{doubt, ragged};
use super::title::{self, Title, is_comment};
use super::{Columns, Lines};
use crate::ReadOptions;
use crate::unit::{Unit, check};

/// Lines before the first point that are taken for titles.
const MAX_TITLES: usize = 50;
/// Lines by which separators, commas and columns are judged.
const SAMPLE: usize = 1000;

/// Titles, then the first lines of points.
#[derive(Default)]
pub struct Head {
    pub titles: Vec<String>,
    /// Comment or title that may name the columns.
    naming: Vec<String>,
    pub promised: Option<u64>,
    /// Lines with their numbers.
    pub rows: Vec<(u64, String)>,
}

/// What a head says about the rows.
pub struct Layout {
    pub columns: Columns,
    /// Line number and width of the first row; all others have the same width.
    pub width: (u64, Width),
    /// As the title names it.
    pub unit: Option<Unit>,
}

impl Head {
    pub fn read(lines: &mut Lines, options: &ReadOptions) -> Result<Self> {
        let mut head = Self::default();
        while head.rows.len() < SAMPLE {
            let Some(line) = lines.next()? else { break };
            let line = line.to_owned();
            if line.is_empty() || head.repeats_title(&line) {
                continue;
            }
            if is_comment(&line) {
                head.naming.push(line);
            } else if !head.rows.is_empty() || head.is_row(&line, options) {
                head.rows.push((lines.number(), line));
            } else if let Ok(count) = line.parse::<u64>() {
                head.promised = Some(head.promised.unwrap_or(0).saturating_add(count));
            } else {
                head.naming.push(line.clone());
                head.titles.push(line);
                if head.titles.len() > MAX_TITLES {
                    break;
                }
            }
        }
        head.refuse_grid()?;
        head.refuse_units(options)?;
        if head.rows.is_empty() {
            return Err(head.no_points(options));
        }
        Ok(head)
    }

    /// Joined files repeat their title.
    pub fn repeats_title(&self, line: &str) -> bool {
        !self.rows.is_empty() && self.titles.iter().any(|t| t == line)
    }

    fn is_row(&self, line: &str, options: &ReadOptions) -> bool {
        if let Some(columns) = &options.columns {
            return is_row(line, columns, options);
        }
        // A name or time before the coordinates is no number.
        is_row(line, &Columns::plain(), options)
            || Dialect::of(line)
                .and_then(|d| self.title(Width::of(&d.words(line))))
                .is_some_and(|t| t.is_ok_and(|t| is_row(line, &t.columns, options)))
    }

    /// What the title nearest to the rows says.
    fn title(&self, row: Width) -> Option<Result<Title, String>> {
        self.naming.iter().rev().find_map(|line| title::of(line, row))
    }

    fn refuse_grid(&self) -> Result<()> {
        let has = |word: &str| {
            let begins = |t: &String| t.split_ascii_whitespace().next().is_some_and(|w| w.eq_ignore_ascii_case(word));
            self.titles.iter().any(begins)
        };
        if has("ncols") && has("nrows") {
            bail!("it is an ESRI ASCII grid, heights in rows and columns and no points; write it as lines of x y z");
        }
        Ok(())
    }

    /// A line of units below the title is not read; if it does not say metres, the option must give the unit.
    fn refuse_units(&self, options: &ReadOptions) -> Result<()> {
        match self.naming.iter().find(|line| title::are_units(line)) {
            Some(line) if options.file_unit.is_none() => {
                bail!("its title holds a line of units, \"{}\": say which with --file-unit", cut(line))
            }
            _ => Ok(()),
        }
    }

    fn no_points(&self, options: &ReadOptions) -> anyhow::Error {
        let Some(first) = self.titles.first() else { return anyhow!("it holds no points") };
        let wanted = options.columns.as_ref().map_or("three coordinates".into(), |c| format!("columns {c}"));
        let way = match hint(first, Dialect::told(options.decimal_comma).comma) {
            "" if options.columns.is_none() && self.titles.iter().any(|t| stand_later(t)) => {
                "; where the coordinates do not stand first, say which columns hold what, e.g. --columns n,x,y,z"
            }
            "" => "; numbers parted by blanks, tabs, semicolons, bars or commas are read",
            other => other,
        };
        anyhow!("none of its first {} lines has {wanted}; the first is \"{}\"{way}", self.titles.len(), cut(first))
    }

    /// What all lines of the sample together say about separators and commas.
    pub fn dialect(&self, options: &ReadOptions) -> Result<Dialect> {
        let mut dialect = Dialect::told(options.decimal_comma);
        for (number, line) in &self.rows {
            let Some(learnt) = dialect.learn(line) else {
                bail!("line {number}: the commas of \"{}\" contradict one another", cut(line));
            };
            dialect = learnt;
            if options.decimal_comma && dialect.separator == Separator::Comma && !line.contains('"') {
                bail!("line {number}: --decimal-comma is given, and the commas of \"{}\" part its columns", cut(line));
            }
        }
        Ok(dialect)
    }

    /// The columns as the user says, as the title says, or judging by the numbers.
    pub fn layout(&self, dialect: Dialect, options: &ReadOptions) -> Result<Layout> {
        let words = |(number, line): &(u64, String)| {
            let words = dialect.learn(line).unwrap_or(dialect).words(line).iter().map(|&w| w.to_owned()).collect();
            (*number, words)
        };
        let rows: Vec<(u64, Vec<String>)> =
            self.rows.iter().filter(|(_, line)| line.parse::<u64>().is_err()).map(words).collect();
        let width = rows.first().map_or((0, Width::of::<String>(&[])), |(n, words)| (*n, Width::of(words)));
        let title = self.title(width.1);
        if let Some(given) = &options.columns {
            // A title that does not tell is what the user's word is for.
            let unit = title.and_then(Result::ok).and_then(|t| t.unit);
            return Ok(Layout { columns: given.clone(), width, unit });
        }
        if let Some(why) = ragged(&rows) {
            bail!("{why}");
        }
        let title = title.transpose().map_err(|why| anyhow!("{why}"))?;
        let unit = title.as_ref().and_then(|t| t.unit);
        if let Some(Title { columns, is_whole: true, .. }) = title {
            return Ok(Layout { columns, width, unit });
        }
        let words: Vec<Vec<String>> = rows.into_iter().map(|(_, words)| words).collect();
        match doubt(&words, &dialect, self.promised.is_some()) {
            Some(why) => bail!("line {}: \"{}\": {why}", self.rows[0].0, cut(&self.rows[0].1)),
            None => Ok(Layout { columns: Columns::plain(), width, unit }),
        }
    }

    pub fn said(&self, layout: &Layout, options: &ReadOptions) -> Vec<String> {
        let mut out = Vec::new();
        if !self.titles.is_empty() {
            out.push(format!("{} title lines passed over, the first \"{}\"", self.titles.len(), cut(&self.titles[0])));
        }
        if options.columns.is_none() && layout.columns != Columns::plain() {
            out.push(format!("columns as its title names them: {}", layout.columns));
        }
        if let Some(unit) = layout.unit {
            out.push(format!("its title says that its numbers are {}", unit.name()));
        }
        out
    }
}

impl Layout {
    /// Checks that the unit named by the title is the user's.
    pub fn check(&self, options: &ReadOptions) -> Result<()> {
        self.unit.map_or(Ok(()), |unit| check(unit.metres(), options.file_unit))
    }
}

/// Whether a line can be a point: there are numbers in the places of the coordinates.
fn is_row(line: &str, columns: &Columns, options: &ReadOptions) -> bool {
    let Some(dialect) = Dialect::told(options.decimal_comma).learn(line) else { return false };
    let words = dialect.words(line);
    let is_number = |place: usize| words.get(place).is_some_and(|w| dialect.value(w).is_some() || is_ambiguous(w));
    columns.coordinates().is_some_and(|places| places.into_iter().all(is_number))
}

/// Whether three numbers follow a word that is not a number.
fn stand_later(line: &str) -> bool {
    let Some(dialect) = Dialect::of(line) else { return false };
    let words = dialect.words(line);
    let is_number = |w: &&&str| dialect.value(w).is_some();
    words.iter().skip_while(is_number).skip(1).filter(is_number).count() >= 3
}

/// A line to quote.
pub fn cut(line: &str) -> String {
    const LONGEST: usize = 80;
    if line.chars().count() <= LONGEST { line.into() } else { line.chars().take(LONGEST).chain(['…']).collect() }
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
        let options = ReadOptions::default();
        let is = |line| is_row(line, &Columns::plain(), &options);
        assert!(is("1 2 3") && is("1,5;2,5;3,5") && is("1,234 2,345 3,456"));
        assert!(!is("Project: hall") && !is("12") && !is("P1 1 2 3"));
        let named = "n,x,y,z".parse().unwrap();
        assert!(is_row("P1 1 2 3", &named, &options) && !is_row("1 2 3", &named, &options));
    }
}
