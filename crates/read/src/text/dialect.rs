//! How a file writes its numbers: what separates them, and what a comma within one means.

use super::columns::Width;
use super::number::{CommaReading, form, has_points, may_have_points, without_marks};

pub use super::number::Comma;

/// What stands between the numbers of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Separator {
    /// Blanks and tabs.
    #[default]
    Blank,
    Semicolon,
    Pipe,
    /// Commas, and blanks if there are any.
    Comma,
}

/// Separator and comma, as far as they are known yet.
#[derive(Debug, Clone, Copy, Default)]
pub struct Dialect {
    pub separator: Separator,
    pub comma: Option<Comma>,
    /// Beside decimal commas: points separate thousands.
    pub points: bool,
}

impl std::fmt::Display for Dialect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self.separator {
            Separator::Blank => "parted by blanks",
            Separator::Semicolon => "parted by semicolons",
            Separator::Pipe => "parted by bars",
            Separator::Comma => "parted by commas",
        })?;
        f.write_str(match self.comma {
            None => "",
            Some(Comma::Decimal) => ", decimal commas",
            Some(Comma::Thousands) => ", thousands by commas",
        })?;
        f.write_str(if self.points { ", thousands by points" } else { "" })
    }
}

impl Dialect {
    /// What is known before any line: whether the user calls commas decimal marks.
    pub fn told(are_decimal: bool) -> Self {
        Self { comma: are_decimal.then_some(Comma::Decimal), ..Self::default() }
    }

    /// The dialect of a single line; `None` where its commas contradict one another.
    pub fn of(line: &str) -> Option<Self> {
        Self::default().learn(line)
    }

    /// The separator of a line, and what its first words add to what is known about commas.
    pub fn learn(mut self, line: &str) -> Option<Self> {
        self.separator = separator(line);
        if line.contains(',') || self.comma == Some(Comma::Decimal) {
            for word in self.words(line).into_iter().take(3) {
                self.points |= has_points(word) && (word.contains(',') || self.comma == Some(Comma::Decimal));
                match (form(word), self.comma) {
                    (CommaReading::Certain(new), None) => self.comma = Some(new),
                    (CommaReading::Certain(new), Some(known)) if new != known => return None,
                    _ => {}
                }
            }
        }
        Some(self)
    }

    /// The words of a line, without quotes; a word that is missing between two marks is empty.
    pub fn words<'a>(&self, line: &'a str) -> Vec<&'a str> {
        let bare = |word: &'a str| word.trim_matches([' ', '\t', '"']);
        match self.separator {
            Separator::Blank if line.contains('"') => {
                unquoted(line, &[' ', '\t']).map(|w| bare(w).trim_end_matches(',')).filter(|w| !w.is_empty()).collect()
            }
            Separator::Blank => {
                line.split([' ', '\t']).map(|w| bare(w).trim_end_matches(',')).filter(|w| !w.is_empty()).collect()
            }
            Separator::Semicolon => unquoted(line, &[';']).map(bare).collect(),
            Separator::Pipe => unquoted(line, &['|']).map(bare).collect(),
            Separator::Comma if line.contains('"') => unquoted(line, &[',']).map(bare).collect(),
            Separator::Comma => line.split(',').flat_map(|cell| numbers_within(cell.trim())).collect(),
        }
    }

    /// The value of a word; `None` where it is no number, or the meaning of its comma is unknown.
    pub fn value(&self, word: &str) -> Option<f64> {
        if let Ok(value) = word.parse() {
            // Beside decimal commas 1.250 may be a thousand and more.
            let is_doubtful = self.comma == Some(Comma::Decimal) && (self.points || may_have_points(word));
            if !is_doubtful || !word.contains('.') {
                return Some(value);
            }
        }
        let mut word = without_marks(word)?;
        if self.comma == Some(Comma::Decimal) && word.contains('.') {
            let whole = &word[..word.find(',').unwrap_or(word.len())];
            if self.points && may_have_points(whole) {
                word = word.replace('.', "");
            } else if self.points || may_have_points(&word) {
                return None;
            }
        }
        match (form(&word), self.comma) {
            (CommaReading::Plain, _) => word.parse().ok(),
            (CommaReading::Ambiguous | CommaReading::Certain(Comma::Decimal), Some(Comma::Decimal)) => {
                word.replace(',', ".").parse().ok()
            }
            (CommaReading::Ambiguous | CommaReading::Certain(Comma::Thousands), Some(Comma::Thousands)) => {
                word.replace(',', "").parse().ok()
            }
            _ => None,
        }
    }

    /// The first three numbers of a line, if it has the required width.
    pub fn point(&self, line: &str, width: Option<Width>) -> Option<[f64; 3]> {
        let Some(width) = width else { return self.numbers(line) };
        if self.separator != Separator::Blank || line.contains([',', '"']) {
            return if width.fits(Width::of(&self.words(line))) { self.numbers(line) } else { None };
        }
        let mut words = line.split_ascii_whitespace();
        let mut next = || self.value(words.next()?);
        let point = [next()?, next()?, next()?];
        // Counted byte by byte, which is quicker than word by word.
        let count = 1 + line.as_bytes().windows(2).filter(|w| w[0] <= b' ' && w[1] > b' ').count();
        (count == width.filled || count == width.all).then_some(point)
    }

    /// The first `N` numbers of a line.
    pub fn numbers<const N: usize>(&self, line: &str) -> Option<[f64; N]> {
        let mut out = [0.0; N];
        if self.separator == Separator::Blank && !line.contains([',', '"']) {
            let mut words = line.split_ascii_whitespace();
            for slot in &mut out {
                *slot = self.value(words.next()?)?;
            }
            return Some(out);
        }
        let words = self.words(line);
        for (slot, word) in out.iter_mut().zip(words.get(..N)?) {
            *slot = self.value(word)?;
        }
        Some(out)
    }
}

/// The pieces of a line between marks that are not within quotes.
pub fn unquoted<'a>(line: &'a str, marks: &[char]) -> impl Iterator<Item = &'a str> {
    let mut within = false;
    line.split(move |c: char| {
        within ^= c == '"';
        marks.contains(&c) && !within
    })
}

/// A cell between commas is several words where blanks separate numbers; a name or time with blanks stays one word.
fn numbers_within(cell: &str) -> impl Iterator<Item = &str> {
    let has_blanks = cell.contains([' ', '\t']);
    let is_one = !has_blanks || !cell.split_ascii_whitespace().all(|w| w.parse::<f64>().is_ok());
    let pieces = if is_one { None } else { Some(cell.split_ascii_whitespace()) };
    is_one.then_some(cell).into_iter().chain(pieces.into_iter().flatten())
}

/// The first `N` numbers of a line by itself.
pub fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    Dialect::of(line)?.numbers(line)
}

/// Whether a word's commas, if it has any, can be read in two ways.
pub fn is_ambiguous(word: &str) -> bool {
    form(word) == CommaReading::Ambiguous
}

/// The message about a line whose commas or points are not understood.
pub fn hint(line: &str, comma: Option<Comma>) -> &'static str {
    let Some(dialect) = Dialect::of(line) else { return "" };
    let words = dialect.words(line);
    if comma.or(dialect.comma) == Some(Comma::Decimal) && words.iter().any(|w| may_have_points(w)) {
        return "; beside decimal commas its points may part thousands or decimals: write the numbers with one mark";
    }
    if dialect.separator != Separator::Comma && words.iter().any(|w| is_ambiguous(w)) {
        "; does a comma part thousands or decimals? Say --decimal-comma, or write the numbers with points alone"
    } else if words.iter().any(|w| has_points(w)) {
        "; if its points part thousands say --decimal-comma, or write the numbers without"
    } else {
        ""
    }
}

fn separator(line: &str) -> Separator {
    if line.contains(';') {
        return Separator::Semicolon;
    }
    if line.contains('|') {
        return Separator::Pipe;
    }
    if !line.contains(',') {
        return Separator::Blank;
    }
    let blank = Dialect::default();
    let words = blank.words(line);
    let are_numbers = words.len() >= 3 && words[..3].iter().all(|w| form(w) != CommaReading::NoNumber);
    if are_numbers { Separator::Blank } else { Separator::Comma }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_and_decimal_marks() {
        for (line, expected) in [
            ("1.5 2.5 3.5 255 0 0", Some([1.5, 2.5, 3.5])),
            ("1.5,2.5,3.5", Some([1.5, 2.5, 3.5])),
            ("1.5, 2.5, 3.5, 9", Some([1.5, 2.5, 3.5])),
            ("1,5;2,5;3,5", Some([1.5, 2.5, 3.5])),
            ("1,5\t2,5\t3,5\t0,1", Some([1.5, 2.5, 3.5])),
            ("1,5, 2,5, 3,5", Some([1.5, 2.5, 3.5])),
            ("1.5,2.5,3.5 255", Some([1.5, 2.5, 3.5])),
            ("1.5,2.5,3.5 255 0 0", Some([1.5, 2.5, 3.5])),
            ("1.5|2.5|3.5", Some([1.5, 2.5, 3.5])),
            ("\"1.5\",\"2.5\",\"3.5\"", Some([1.5, 2.5, 3.5])),
            ("\"1,5\",\"2,5\",\"3,5\"", Some([1.5, 2.5, 3.5])),
            ("-1.5e-3 .5 3.", Some([-1.5e-3, 0.5, 3.0])),
            ("1,234 2,5 3,456", Some([1.234, 2.5, 3.456])),
            ("0,234 1,234 2,345", Some([0.234, 1.234, 2.345])),
            ("1.5;2.5", None),
            ("x y z", None),
            ("1.5;;3.5;4", None),
            ("1.5,,3.5,4", None),
        ] {
            assert_eq!(numbers::<3>(line), expected, "{line}");
        }
    }

    #[test]
    fn points_part_thousands_beside_decimal_commas() {
        let utm = Some([500_000.12, 5_400_000.45, 101.5]);
        for (line, expected) in [
            ("500.000,12 5.400.000,45 101,50", utm),
            ("500.000,12\t5.400.000,45\t101,50", utm),
            ("500.000,12;5.400.000,45;101,50", utm),
            ("500.000,12 5.400.000 1.250", Some([500_000.12, 5_400_000.0, 1250.0])),
            ("-1.250,5 2,5 0", Some([-1250.5, 2.5, 0.0])),
            // Points as both marks.
            ("1.250,5 2.25 3,5", None),
            // Is that 1.25 or 1250?
            ("1.250 2,5 3,5", None),
            ("1.25 2,5 3,5", Some([1.25, 2.5, 3.5])),
            ("1.25.0,5 2,5 3,5", None),
        ] {
            assert_eq!(numbers::<3>(line), expected, "{line}");
        }
        let known = Dialect { comma: Some(Comma::Decimal), ..Dialect::default() };
        let line = "500.000 5.400.000 101";
        assert_eq!(known.learn(line).unwrap().numbers::<3>(line), Some([500_000.0, 5_400_000.0, 101.0]));
        assert!(hint(line, None).contains("--decimal-comma"));
    }

    #[test]
    fn cells_keep_their_blanks() {
        let words = |line: &str| Dialect::of(line).unwrap().words(line).join("|");
        assert_eq!(words("Wall 12,1.25,2.5,0.75"), "Wall 12|1.25|2.5|0.75");
        assert_eq!(words("\"Point 1\" 1.25 2.5 0.75"), "Point 1|1.25|2.5|0.75");
        assert_eq!(words("1.5,2.5,3.5 255 0"), "1.5|2.5|3.5|255|0");
    }

    #[test]
    fn thousands_are_no_coordinates_of_their_own() {
        let utm = Some([500_000.12, 5_400_000.45, 101.5]);
        for (line, expected) in [
            ("500,000.12 5,400,000.45 101.5", utm),
            ("500'000.12 5'400'000.45 101.5", utm),
            ("500’000.12 5’400’000.45 101.5", utm),
            ("500\u{a0}000.12 5\u{a0}400\u{a0}000.45 101.5", utm),
            ("500 000,12;5 400 000,45;101,5", utm),
            ("\"500,000.12\",\"5,400,000.45\",\"101.5\"", utm),
            ("5'00.12 5'400'000.45 101.5", None),
            // Either 1.234 or 1234.
            ("1,234 2,345 3,456", None),
            ("1,234;2,345;3,456", None),
            // Both at once.
            ("1,5 5,400,000.45 101.5", None),
        ] {
            assert_eq!(numbers::<3>(line), expected, "{line}");
        }
        assert!(hint("1,234 2,345 3,456", None).contains("--decimal-comma"));
        let known = Dialect { comma: Some(Comma::Decimal), ..Dialect::default() };
        assert_eq!(known.numbers::<3>("1,234 2,345 3,456"), Some([1.234, 2.345, 3.456]));
    }
}
