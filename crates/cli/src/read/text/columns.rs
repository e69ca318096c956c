//! Which column of a text of points holds what: as the user says, as its title says, or as the numbers look.

use std::str::FromStr;

use super::dialect::Dialect;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    Skip,
    /// The point's number or name.
    Number,
    X,
    Y,
    Z,
    Intensity,
    Red,
    Green,
    Blue,
}

const LETTERS: [(&str, Column); 9] = [
    ("-", Column::Skip),
    ("n", Column::Number),
    ("x", Column::X),
    ("y", Column::Y),
    ("z", Column::Z),
    ("i", Column::Intensity),
    ("r", Column::Red),
    ("g", Column::Green),
    ("b", Column::Blue),
];

/// Columns in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns(Vec<Column>);

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let column = |word: &str| {
            let word = word.trim().to_lowercase();
            let found = LETTERS.iter().find(|(letter, _)| *letter == word);
            found.map(|(_, c)| *c).ok_or_else(|| {
                format!(
                    "\"{word}\" is no column; known are n (number), x, y, z, i (intensity), r, g, b and - (passed over)"
                )
            })
        };
        let columns = text.split(',').map(column).collect::<Result<Vec<_>, _>>()?;
        for (letter, column) in &LETTERS[1..] {
            let count = columns.iter().filter(|c| *c == column).count();
            if count > 1 {
                return Err(format!("column {letter} is named {count} times"));
            }
        }
        let all = Self(columns);
        if all.coordinates().is_none() {
            return Err(format!("\"{text}\" does not name all of x, y and z"));
        }
        Ok(all)
    }
}

impl std::fmt::Display for Columns {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let letter = |c: &Column| LETTERS.iter().find(|(_, other)| other == c).map_or("-", |(letter, _)| *letter);
        f.write_str(&self.0.iter().map(letter).collect::<Vec<_>>().join(","))
    }
}

impl Columns {
    /// Coordinates first, the rest passed over.
    pub fn plain() -> Self {
        Self(vec![Column::X, Column::Y, Column::Z])
    }

    /// The place of a column.
    pub fn place(&self, column: Column) -> Option<usize> {
        self.0.iter().position(|c| *c == column)
    }

    /// Places of x, y, z.
    pub fn coordinates(&self) -> Option<[usize; 3]> {
        Some([self.place(Column::X)?, self.place(Column::Y)?, self.place(Column::Z)?])
    }

    /// Columns by the words of a title: `None` unless it names x, y, z and as many columns as there are.
    pub fn of_title(title: &str, columns: usize) -> Option<Self> {
        let bare = title.trim_start_matches(['/', '#', '!', '%', ' ', '\t']).to_lowercase();
        let words: Vec<&str> = bare.split([' ', '\t', ',', ';', '|', '"']).filter(|w| !w.is_empty()).collect();
        let column = |word: &&str| match word.trim_matches(['[', ']', '(', ')']) {
            "x" => Column::X,
            "y" => Column::Y,
            "z" => Column::Z,
            "i" | "intensity" | "reflectance" => Column::Intensity,
            "r" | "red" => Column::Red,
            "g" | "green" => Column::Green,
            "b" | "blue" => Column::Blue,
            _ => Column::Skip,
        };
        let all = Self(words.iter().map(column).collect());
        let is_whole = words.len() == columns && all.coordinates().is_some();
        let once = LETTERS[2..].iter().all(|(_, c)| all.0.iter().filter(|o| *o == c).count() <= 1);
        (is_whole && once).then_some(all)
    }

    /// Whether y stands before x, as surveyors write whose x goes north.
    pub fn are_turned(&self) -> bool {
        self.coordinates().is_some_and(|[x, y, z]| !(x < y && y < z))
    }
}

/// Why the first three of several columns do not look like coordinates.
pub fn doubt(rows: &[Vec<String>], dialect: &Dialect) -> Option<String> {
    let columns = rows.iter().map(Vec::len).min().unwrap_or(0);
    if columns < 4 || rows.len() < 2 {
        return None;
    }
    let is_whole = |word: &String| word.bytes().all(|b| b.is_ascii_digit());
    let first: Vec<f64> = rows.iter().filter(|r| is_whole(&r[0])).filter_map(|r| dialect.value(&r[0])).collect();
    let counts = first.len() == rows.len() && first.windows(2).all(|w| w[1] > w[0]);
    let steps = first.windows(2).all(|w| w[1] - w[0] == 1.0);
    let others_have_decimals = rows.iter().any(|r| !r[1..4].iter().all(is_whole));
    if counts && (steps || others_have_decimals) {
        return Some(format!(
            "its first column counts up from {}: if that is the points' number say --columns n,x,y,z, if it is a coordinate --columns x,y,z",
            rows[0][0]
        ));
    }
    let three = |row: &Vec<String>| groups(row).is_some_and(|n| (3..=4).contains(&n));
    if columns >= 5 && rows.iter().all(three) {
        return Some(
            "its numbers look as if blanks or commas parted their thousands: write them without, or say with --columns which columns hold x, y, z".into(),
        );
    }
    None
}

/// How many numbers a line has if groups of three digits belong to what stands before; `None` where none does.
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

    fn doubts(lines: &[&str]) -> Option<String> {
        let dialect = Dialect::of(lines[0]).unwrap();
        let rows: Vec<Vec<String>> =
            lines.iter().map(|l| dialect.words(l).into_iter().map(ToOwned::to_owned).collect()).collect();
        doubt(&rows, &dialect)
    }

    #[test]
    fn columns_are_named_once() {
        assert_eq!("n,x,y,z,i,r,g,b".parse::<Columns>().unwrap().coordinates(), Some([1, 2, 3]));
        assert_eq!("-, Y ,X,z".parse::<Columns>().unwrap().to_string(), "-,y,x,z");
        for wrong in ["", "x,y", "x,y,z,x", "a,x,y,z"] {
            assert!(wrong.parse::<Columns>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn titles_tell_columns() {
        let of = |title, n| Columns::of_title(title, n).map(|c| c.to_string());
        assert_eq!(of("//X Y Z R G B", 6).unwrap(), "x,y,z,r,g,b");
        assert_eq!(of("\"id\";\"x\";\"y\";\"z\"", 4).unwrap(), "-,x,y,z");
        assert_eq!(of("X Y Z", 4), None);
        assert_eq!(of("Project: hall", 2), None);
        assert!(Columns::of_title("Y X Z", 3).unwrap().are_turned());
    }

    #[test]
    fn numbers_of_points_are_noticed() {
        for (lines, is_doubtful) in [
            (&["1 1.25 2.5 0.75", "2 1.5 2.5 0.75"][..], true),
            (&["1001 1.25 2.5 0.75", "1007 1.5 2.5 0.75"], true),
            (&["1 5 7 9", "2 5 7 9", "3 5 7 9"], true),
            (&["1.25 2.5 0.75 7", "1.5 2.5 0.75 8"], false),
            (&["5 2.5 0.75 7", "5 2.6 0.75 8"], false),
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
            (&["513 345.67 5 255 128 101", "512 345.67 5 255 128 7"], false),
            (&["1.5 345.67 5.2 255 128 101", "1.6 345.67 5.2 255 128 101"], false),
        ] {
            assert_eq!(doubts(lines).is_some(), is_doubtful, "{lines:?}");
        }
    }
}
