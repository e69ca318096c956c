//! A number as it is written: its decimal mark, and what separates its thousands.

/// What a comma within a number means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comma {
    Decimal,
    Thousands,
}

/// What the commas of a word mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CommaReading {
    Plain,
    Certain(Comma),
    /// `1,234`: either.
    Ambiguous,
    NoNumber,
}

fn all_digits(text: &str) -> bool {
    text.bytes().all(|b| b.is_ascii_digit())
}

fn without_sign(word: &str) -> &str {
    word.trim_start_matches(['+', '-', '\u{2212}'])
}

/// Whether there are groups of three digits between the marks, and one to three digits before them.
fn is_grouped(whole: &str, mark: char) -> bool {
    let mut groups = whole.split(mark);
    let first = groups.next().unwrap_or_default();
    (1..=3).contains(&first.len())
        && all_digits(first)
        && !first.starts_with('0')
        && groups.all(|g| g.len() == 3 && all_digits(g))
}

/// `1.250` or `5.400.000`: beside decimal commas its points may separate thousands.
pub fn may_have_points(word: &str) -> bool {
    let digits = without_sign(word);
    digits.contains('.') && is_grouped(digits, '.')
}

/// `5.400.000` or `1.250,5`: its points can only separate thousands.
pub fn has_points(word: &str) -> bool {
    let digits = without_sign(word);
    match digits.split_once(',') {
        Some((whole, decimals)) => whole.contains('.') && is_grouped(whole, '.') && all_digits(decimals),
        None => may_have_points(word) && digits.matches('.').count() > 1,
    }
}

pub fn form(word: &str) -> CommaReading {
    let digits = without_sign(word);
    if !digits.contains(',') {
        return CommaReading::Plain;
    }
    if has_points(digits) {
        return CommaReading::Certain(Comma::Decimal);
    }
    let (whole, decimals) = digits.split_once('.').map_or((digits, None), |(w, d)| (w, Some(d)));
    let commas = whole.matches(',').count();
    match (commas, is_grouped(whole, ','), decimals) {
        (1, true, None) => CommaReading::Ambiguous,
        (_, true, d) if d.is_none_or(|d| all_digits(&d.replace(['e', 'E', '+', '-'], ""))) => {
            CommaReading::Certain(Comma::Thousands)
        }
        (1, _, None) if digits.replace(',', ".").parse::<f64>().is_ok() => CommaReading::Certain(Comma::Decimal),
        _ => CommaReading::NoNumber,
    }
}

/// The word with a plain minus and exponent, without apostrophes and blanks between thousands where they are well
/// placed.
pub fn without_marks(word: &str) -> Option<String> {
    const MARKS: [char; 6] = ['\'', '\u{2019}', ' ', '\u{a0}', '\u{2009}', '\u{202f}'];
    let word = word.trim_matches(['\u{a0}', '\u{2009}', '\u{202f}']).replace('\u{2212}', "-");
    // Fortran writes 1.5D+00.
    let is_fortran = word.bytes().all(|b| b.is_ascii_digit() || b"+-.dD".contains(&b));
    let word = if is_fortran { word.replace(['d', 'D'], "e") } else { word };
    if !word.contains(MARKS) {
        return Some(word);
    }
    let digits = without_sign(&word);
    let (whole, decimals) = digits.split_at(digits.find(['.', ',']).unwrap_or(digits.len()));
    let mut groups = whole.split(MARKS);
    let starts = groups.next().is_some_and(|g| (1..=3).contains(&g.len()) && all_digits(g));
    let goes_on = groups.all(|g| g.len() == 3 && all_digits(g));
    (starts && goes_on && !decimals.contains(MARKS)).then(|| word.replace(MARKS, ""))
}

#[cfg(test)]
mod tests {
    use crate::text::numbers;

    #[test]
    fn numbers_of_other_hands() {
        let point = Some([-1.25, 2.5, 0.75]);
        for line in ["-1.25D+00 2.5D+00 7.5d-01", "\u{2212}1.25 2.5 0.75", "-1.25\u{a0} 2.5\u{a0} 0.75"] {
            assert_eq!(numbers::<3>(line), point, "{line}");
        }
        let thin = "2\u{2009}600\u{2009}000.12 1\u{2009}200\u{2009}000.45 501.5";
        assert_eq!(numbers::<3>(thin), Some([2_600_000.12, 1_200_000.45, 501.5]));
        assert_eq!(numbers::<3>("1.25\u{a0}250 2 3"), None);
    }
}
