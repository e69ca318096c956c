//! Why the first three columns of rows without a title may not be coordinates.

use super::columns::Width;
use super::dialect::Dialect;

/// Two rows of different width.
pub fn ragged(rows: &[(u64, Vec<String>)]) -> Option<String> {
    let (first, words) = rows.first()?;
    let width = Width::of(words);
    let (number, other) = rows.iter().find(|(_, words)| !width.fits(Width::of(words)))?;
    Some(uneven((*first, width), (*number, Width::of(other))))
}

/// What is wrong with rows of different widths.
pub fn uneven(first: (u64, Width), other: (u64, Width)) -> String {
    format!(
        "line {} has {} words and line {} has {}: is a number missing, or parted by a blank within? Where the columns stand all the same say which hold what, e.g. --columns x,y,z or n,x,y,z",
        first.0, first.1.filled, other.0, other.1.filled
    )
}

/// Why the first three of several columns do not look like coordinates; a file that states the count of its points
/// (`counts`) is a PTS.
pub fn doubt(rows: &[Vec<String>], dialect: &Dialect, counts: bool) -> Option<String> {
    let columns = rows.iter().map(Vec::len).min().unwrap_or(0);
    if columns < 4 {
        return None;
    }
    let first = &rows[0][0];
    if counts_up(rows, dialect) {
        return Some(format!(
            "its first column counts up from {first}: if that is the points' number say --columns n,x,y,z, if it is a coordinate --columns x,y,z"
        ));
    }
    if leads(rows, dialect, columns) {
        return Some(
            "its first column is whole, three behind it have decimals: if it is a number, row or colour say which columns hold what, e.g. --columns n,x,y,z, if it is a coordinate --columns x,y,z".into(),
        );
    }
    let three = |row: &Vec<String>| groups(row).is_some_and(|n| (3..=4).contains(&n));
    if columns >= 5 && rows.iter().all(three) {
        return Some(
            "its numbers look as if blanks or commas parted their thousands: write them without, or say with --columns which columns hold x, y, z".into(),
        );
    }
    (!counts && all_whole(rows, columns)).then(|| {
        "all its columns are whole: coordinates, the points' number first, or numbers parted within? Say which columns hold what, e.g. --columns x,y,z or n,x,y,z".into()
    })
}

fn is_whole<W: AsRef<str>>(word: W) -> bool {
    let word = word.as_ref();
    !word.is_empty() && word.bytes().all(|b| b.is_ascii_digit())
}

fn counts_up(rows: &[Vec<String>], dialect: &Dialect) -> bool {
    let first: Vec<f64> = rows.iter().filter(|r| is_whole(&r[0])).filter_map(|r| dialect.value(&r[0])).collect();
    let counts = rows.len() > 1 && first.len() == rows.len() && first.windows(2).all(|w| w[1] > w[0]);
    let steps = first.windows(2).all(|w| w[1] - w[0] == 1.0);
    counts && (steps || rows.iter().any(|r| !r[1..4].iter().all(is_whole)))
}

/// Whether the first column holds whole numbers in every row, and three others do not.
fn leads(rows: &[Vec<String>], dialect: &Dialect, columns: usize) -> bool {
    let is_integer = |word: &str| is_whole(word.trim_start_matches(['+', '-']));
    let has_fraction = |word: &str| dialect.value(word).is_some_and(|v| v.is_finite() && v.fract() != 0.0);
    // Where the first is written 1.0, decimals that are zero say nothing of the others.
    let are_integers = rows.iter().all(|r| is_integer(&r[0]));
    let has_decimals =
        |word: &str| if are_integers { dialect.value(word).is_some() && !is_integer(word) } else { has_fraction(word) };
    let others = || (1..columns).filter(|&c| rows.iter().any(|r| has_decimals(&r[c]))).count();
    let is_number = |word: &str| dialect.value(word).is_some_and(|v| v.is_finite() && v.fract() == 0.0);
    // A wall at x = 5.0000: a number or a row that stands still would be written 5.
    let stands_still = rows.len() > 1 && rows.iter().all(|r| r[0] == rows[0][0]);
    rows.iter().all(|r| is_number(&r[0])) && others() >= 3 && (are_integers || !stands_still)
}

/// Whether all numbers are whole, and the columns are not a place and a colour, which would be six.
fn all_whole(rows: &[Vec<String>], columns: usize) -> bool {
    let is_colour = |word: &String| word.parse::<u32>().is_ok_and(|c| c <= 255);
    let are_colours = columns == 6 && rows.iter().all(|r| r[3..6].iter().all(is_colour));
    rows.iter().all(|r| r[..columns].iter().all(is_whole)) && (!are_colours || are_decimals(rows))
}

/// `1,25,2,50,0,75`: every second column has the same length in all rows, as decimals have, and fewer than three
/// digits.
fn are_decimals(rows: &[Vec<String>]) -> bool {
    [1, 3, 5].iter().all(|&c| rows.iter().all(|r| r[c].len() == 2)) && rows.len() > 1
}

/// How many numbers a line has if groups of three digits belong to what precedes them; `None` where none does.
fn groups(row: &[String]) -> Option<usize> {
    let whole = |word: &str| word.split('.').next().unwrap_or_default().to_owned();
    let digits = |s: &str| !s.is_empty() && s.bytes().all(|b| b.is_ascii_digit());
    let (mut count, mut joined, mut open) = (0, 0u32, false);
    for word in row {
        let group = whole(word);
        if open && group.len() == 3 && digits(&group) {
            // Behind the coordinates stand colours.
            joined += u32::from(count <= 3);
        } else {
            count += 1;
        }
        // Behind decimals nothing goes on.
        open = digits(word) && word.len() <= 3;
    }
    (joined > 0).then_some(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_across_the_first_axis_is_no_number() {
        assert!(doubts(&["5.0000 0.12 0.51 0.3", "5.0000 0.14 0.53 0.3"]).is_none());
        assert!(doubts(&["1.0 0.12 0.51 0.3", "7.0 0.14 0.53 0.3"]).is_some());
        assert!(doubts(&["5 0.12 0.51 0.3", "5 0.14 0.53 0.3"]).is_some());
    }

    fn doubts(lines: &[&str]) -> Option<String> {
        let dialect = Dialect::of(lines[0]).unwrap();
        let rows: Vec<Vec<String>> =
            lines.iter().map(|l| dialect.words(l).into_iter().map(ToOwned::to_owned).collect()).collect();
        doubt(&rows, &dialect, false)
    }

    #[test]
    fn numbers_of_points_are_noticed() {
        for (lines, is_doubtful) in [
            (&["1 1.25 2.5 0.75", "2 1.5 2.5 0.75"][..], true),
            (&["1001 1.25 2.5 0.75", "1007 1.5 2.5 0.75"], true),
            (&["1 5 7 9", "2 5 7 9", "3 5 7 9"], true),
            (&["1.25 2.5 0.75 7", "1.5 2.5 0.75 8"], false),
            (&["5 2.5 0.75 7", "5 2.6 0.75 8"], false),
            (&["17 1.25 2.5 0.75", "3 1.5 2.5 0.75"], true),
            (&["1 1.25 2.5 0.75", "1 1.5 2.5 1"], true),
            (&["1.0 1.25 2.5 0.75", "2.0 1.5 2.5 0.75"], true),
            (&["1.0 2.0 3.0 0.5", "2.0 2.0 3.0 0.5"], false),
            (&["255 0 0 1.25 2.5 0.75", "255 9 0 1.5 2.5 0.75"], true),
            (&["17 100 200 300", "3 101 200 300"], true),
            (&["1250 500 750 255 128 101", "1250 501 750 255 128 101"], false),
            (&["1,25,2,50,0,75", "1,50,2,50,0,75"], true),
            (&["1 2.5 0.75", "2 2.6 0.75"], false),
        ] {
            assert_eq!(doubts(lines).is_some(), is_doubtful, "{lines:?}");
        }
    }

    #[test]
    fn thousands_between_blanks_are_noticed() {
        for (lines, is_doubtful) in [
            (&["512 345.67 5 412 345.45 101.5", "512 346.67 5 412 345.45 101.6"][..], true),
            (&["500,000.12,5,400,000.45,101.5", "500,000.13,5,400,000.46,101.6"], true),
            (&["12 345 6 789 250", "12 346 6 789 251"], true),
            (&["1 234.50 567.25 12.00", "1 235.50 567.25 12.00"], true),
            (&["513 345.67 5 255 128 101", "512 345.67 5 255 128 7"], false),
            (&["1.5 345.67 5.2 255 128 101", "1.6 345.67 5.2 255 128 101"], false),
        ] {
            assert_eq!(doubts(lines).is_some(), is_doubtful, "{lines:?}");
        }
    }
}
