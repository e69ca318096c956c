//! How a file writes its numbers: what parts them, and what a comma within one means.

/// What stands between the numbers of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Separator {
    /// Blanks and tabs.
    #[default]
    Blank,
    Semicolon,
    Pipe,
    /// Commas, and blanks where there are any.
    Comma,
}

/// What a comma within a number means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comma {
    Decimal,
    Thousands,
}

/// Separator and comma, as far as they are known yet.
#[derive(Debug, Clone, Copy, Default)]
pub struct Dialect {
    pub separator: Separator,
    pub comma: Option<Comma>,
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
        })
    }
}

/// What the commas of a word say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Plain,
    Certain(Comma),
    /// `1,234`: either.
    Ambiguous,
    NoNumber,
}

impl Dialect {
    /// The dialect of a line alone; `None` where its commas contradict one another.
    pub fn of(line: &str) -> Option<Self> {
        Self::default().learn(line)
    }

    /// The separator of a line, and what its first words add to what is known of commas.
    pub fn learn(mut self, line: &str) -> Option<Self> {
        self.separator = separator(line);
        if line.contains(',') {
            for word in self.words(line).into_iter().take(3) {
                match (form(word), self.comma) {
                    (Form::Certain(new), None) => self.comma = Some(new),
                    (Form::Certain(new), Some(known)) if new != known => return None,
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
            Separator::Blank => {
                line.split([' ', '\t']).map(|w| bare(w).trim_end_matches(',')).filter(|w| !w.is_empty()).collect()
            }
            Separator::Semicolon => unquoted(line, ';').map(bare).collect(),
            Separator::Pipe => unquoted(line, '|').map(bare).collect(),
            Separator::Comma if line.contains('"') => unquoted(line, ',').map(bare).collect(),
            Separator::Comma => line
                .split(',')
                .flat_map(|piece| piece.trim().split([' ', '\t']).enumerate().filter(|(i, w)| *i == 0 || !w.is_empty()))
                .map(|(_, word)| word)
                .collect(),
        }
    }

    /// The value of a word; `None` where it is no number, or its comma is not known.
    pub fn value(&self, word: &str) -> Option<f64> {
        if let Ok(value) = word.parse() {
            return Some(value);
        }
        let word = without_marks(word)?;
        match (form(&word), self.comma) {
            (Form::Plain, _) => word.parse().ok(),
            (Form::Ambiguous | Form::Certain(Comma::Decimal), Some(Comma::Decimal)) => {
                word.replace(',', ".").parse().ok()
            }
            (Form::Ambiguous | Form::Certain(Comma::Thousands), Some(Comma::Thousands)) => {
                word.replace(',', "").parse().ok()
            }
            _ => None,
        }
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

/// The pieces of a line between marks that do not stand within quotes.
fn unquoted(line: &str, mark: char) -> impl Iterator<Item = &str> {
    let mut within = false;
    line.split(move |c: char| {
        within ^= c == '"';
        c == mark && !within
    })
}

/// The first `N` numbers of a line by itself.
pub fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    Dialect::of(line)?.numbers(line)
}

/// Whether a word's commas, if it has any, can be read in two ways.
pub fn is_ambiguous(word: &str) -> bool {
    form(word) == Form::Ambiguous
}

/// What to say about a line whose commas are not understood.
pub fn hint(line: &str) -> &'static str {
    let Some(dialect) = Dialect::of(line) else { return "" };
    if dialect.separator != Separator::Comma && dialect.words(line).into_iter().any(is_ambiguous) {
        "; does a comma part thousands or decimals? Say --decimal-comma, or write the numbers with points alone"
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
    let blank = Dialect { separator: Separator::Blank, comma: None };
    let words = blank.words(line);
    let are_numbers = words.len() >= 3 && words[..3].iter().all(|w| form(w) != Form::NoNumber);
    if are_numbers { Separator::Blank } else { Separator::Comma }
}

fn form(word: &str) -> Form {
    let digits = word.trim_start_matches(['+', '-']);
    if !digits.contains(',') {
        return Form::Plain;
    }
    let (whole, decimals) = digits.split_once('.').map_or((digits, None), |(w, d)| (w, Some(d)));
    let all_digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let mut groups = whole.split(',');
    let first = groups.next().unwrap_or_default();
    let is_grouped = (1..=3).contains(&first.len())
        && all_digits(first)
        && !first.starts_with('0')
        && groups.clone().all(|g| g.len() == 3 && all_digits(g));
    match (groups.count(), is_grouped, decimals) {
        (1, true, None) => Form::Ambiguous,
        (_, true, d) if d.is_none_or(|d| d.replace(['e', 'E', '+', '-'], "").bytes().all(|b| b.is_ascii_digit())) => {
            Form::Certain(Comma::Thousands)
        }
        (1, _, None) if digits.replace(',', ".").parse::<f64>().is_ok() => Form::Certain(Comma::Decimal),
        _ => Form::NoNumber,
    }
}

/// The word without apostrophes and blanks between thousands, where they stand right.
fn without_marks(word: &str) -> Option<String> {
    const MARKS: [char; 5] = ['\'', '\u{2019}', ' ', '\u{a0}', '\u{202f}'];
    if !word.contains(MARKS) {
        return Some(word.to_owned());
    }
    let digits = word.trim_start_matches(['+', '-']);
    let whole = digits.find(['.', ',']).map_or(digits, |end| &digits[..end]);
    let mut groups = whole.split(MARKS);
    let starts = groups.next().is_some_and(|g| (1..=3).contains(&g.len()) && g.bytes().all(|b| b.is_ascii_digit()));
    let goes_on = groups.all(|g| g.len() == 3 && g.bytes().all(|b| b.is_ascii_digit()));
    (starts && goes_on).then(|| word.replace(MARKS, ""))
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
        assert!(hint("1,234 2,345 3,456").contains("--decimal-comma"));
        let known = Dialect { separator: Separator::Blank, comma: Some(Comma::Decimal) };
        assert_eq!(known.numbers::<3>("1,234 2,345 3,456"), Some([1.234, 2.345, 3.456]));
    }
}
