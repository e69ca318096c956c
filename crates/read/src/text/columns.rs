//! What each column of a text of points holds: as the user says, as the title says, or judging by the numbers.

use std::str::FromStr;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnRole {
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

const LETTERS: [(&str, ColumnRole); 9] = [
    ("-", ColumnRole::Skip),
    ("n", ColumnRole::Number),
    ("x", ColumnRole::X),
    ("y", ColumnRole::Y),
    ("z", ColumnRole::Z),
    ("i", ColumnRole::Intensity),
    ("r", ColumnRole::Red),
    ("g", ColumnRole::Green),
    ("b", ColumnRole::Blue),
];

/// The columns in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns(Vec<ColumnRole>);

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
        let letter = |c: &ColumnRole| LETTERS.iter().find(|(_, other)| other == c).map_or("-", |(letter, _)| *letter);
        f.write_str(&self.0.iter().map(letter).collect::<Vec<_>>().join(","))
    }
}

impl Columns {
    /// Coordinates first, the rest skipped.
    pub fn plain() -> Self {
        Self(vec![ColumnRole::X, ColumnRole::Y, ColumnRole::Z])
    }

    /// The position of a column.
    pub fn place(&self, column: ColumnRole) -> Option<usize> {
        self.0.iter().position(|c| *c == column)
    }

    /// Positions of x, y, z.
    pub fn coordinates(&self) -> Option<[usize; 3]> {
        Some([self.place(ColumnRole::X)?, self.place(ColumnRole::Y)?, self.place(ColumnRole::Z)?])
    }

    /// Columns as a title names them.
    pub fn of(columns: Vec<ColumnRole>) -> Self {
        Self(columns)
    }

    /// Whether y comes before x, as with surveyors whose x points north.
    pub fn are_turned(&self) -> bool {
        self.coordinates().is_some_and(|[x, y, z]| !(x < y && y < z))
    }
}

/// How many words a line has, with and without empty ones at its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Width {
    pub all: usize,
    pub filled: usize,
}

impl Width {
    pub fn of<W: AsRef<str>>(words: &[W]) -> Self {
        let filled = words.iter().rposition(|w| !w.as_ref().is_empty()).map_or(0, |last| last + 1);
        Self { all: words.len(), filled }
    }

    /// Whether lines of both widths can belong to one table: a mark at the end may be left out.
    pub fn fits(self, other: Self) -> bool {
        self.all == other.all || self.filled == other.filled
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_named_once() {
        assert_eq!("n,x,y,z,i,r,g,b".parse::<Columns>().unwrap().coordinates(), Some([1, 2, 3]));
        assert_eq!("-, Y ,X,z".parse::<Columns>().unwrap().to_string(), "-,y,x,z");
        for wrong in ["", "x,y", "x,y,z,x", "a,x,y,z"] {
            assert!(wrong.parse::<Columns>().is_err(), "{wrong}");
        }
    }
}
