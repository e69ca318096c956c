//! What a title says of the columns: which holds what, and in which unit.

use super::columns::{ColumnRole, Columns, Width};
use super::dialect::unquoted;
use crate::unit::Unit;

/// What a title tells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Title {
    pub columns: Columns,
    pub unit: Option<Unit>,
    /// Whether it names every column of a row.
    pub is_whole: bool,
}

/// What a word of a title means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Meaning {
    Is(ColumnRole),
    East,
    North,
    /// North if an east stands beside it, otherwise a number.
    N,
    /// Degrees.
    Angle,
    /// Known, and skipped.
    Aside,
    Unknown,
}

use Meaning::{Angle, Aside, East, Is, N, North, Unknown};

/// What a line says about rows as wide as `row`; `None` where it is no title of columns, an error where it is one that
/// does not name x, y and z.
pub fn of(line: &str, row: Width) -> Option<Result<Title, String>> {
    let cells = cells(line, row);
    let mut meanings: Vec<Meaning> = cells.iter().map(|c| meaning(&name_and_unit(c).0)).collect();
    let fits = cells.len() == row.all || cells.len() == row.filled;
    let known = meanings.iter().filter(|m| **m != Unknown).count();
    let is_table = !is_comment(line) && line.contains([';', '|', ',', '\t']);
    let is_title = known >= 2 && known * 2 >= cells.len() || known >= 1 && fits && is_table;
    if !is_title {
        return None;
    }
    resolve_n(&mut meanings);
    Some(judged(&cells, &meanings, fits, row))
}

pub fn is_comment(line: &str) -> bool {
    line.starts_with(['#', '/', '%', '!'])
}

/// Whether a line consists only of units other than metres: `[mm] [mm] [mm]`.
pub fn are_units(line: &str) -> bool {
    let bare = line.trim_start_matches(['/', '#', '!', '%', ' ', '\t']);
    let words = || bare.split([' ', '\t', ',', ';', '|']).map(|w| w.trim_matches(['[', ']', '(', ')', '"']));
    let units: Vec<_> = words().filter(|w| !w.is_empty()).map(unit_named).collect();
    units.len() >= 3 && units.iter().all(|u| u.is_some() && *u != Some(Some(Unit::M)))
}

fn judged(cells: &[String], meanings: &[Meaning], fits: bool, row: Width) -> Result<Title, String> {
    let columns = Columns::of(meanings.iter().map(|m| column(*m)).collect());
    let Some(places) = once(meanings).then(|| columns.coordinates()).flatten() else {
        return Err(if meanings.contains(&Angle) {
            "its title names latitude or longitude: degrees are no metres; project them first, or say with --columns which columns hold x, y, z".into()
        } else {
            "its title names columns, but not each of x, y and z once: say which is which with --columns, e.g. --columns n,x,y,z".into()
        });
    };
    // East and north say where they go, letters do not.
    let is_certain = meanings.contains(&East) && meanings.contains(&North);
    if columns.are_turned() && !is_certain {
        return Err(format!(
            "its title names the columns {columns}: does x go north there? Say which is which with --columns, e.g. --columns {columns} or x,y,z"
        ));
    }
    let unit = unit_of(&places.map(|place| cells[place].as_str()))?;
    let in_order = places[1] == places[0] + 1 && places[2] == places[0] + 2;
    match fits {
        true => Ok(Title { columns, unit, is_whole: true }),
        false if in_order && (places[0] == 0 || row.filled == 3) => {
            Ok(Title { columns: Columns::plain(), unit, is_whole: false })
        }
        false => Err(format!(
            "its title names {} columns and its rows have {}: say which is which with --columns, e.g. --columns n,x,y,z",
            cells.len(),
            row.filled
        )),
    }
}

/// Whether x, y and z are named once each.
fn once(meanings: &[Meaning]) -> bool {
    let count = |c: ColumnRole| meanings.iter().filter(|m| column(**m) == c).count();
    [ColumnRole::X, ColumnRole::Y, ColumnRole::Z].into_iter().all(|c| count(c) == 1)
}

fn column(meaning: Meaning) -> ColumnRole {
    match meaning {
        Is(column) => column,
        East => ColumnRole::X,
        North => ColumnRole::Y,
        _ => ColumnRole::Skip,
    }
}

fn resolve_n(meanings: &mut [Meaning]) {
    let is_north = meanings.contains(&East) && !meanings.iter().any(|m| matches!(m, North | Is(ColumnRole::Y)));
    let resolved = if is_north { North } else { Aside };
    meanings.iter_mut().filter(|m| **m == N).for_each(|m| *m = resolved);
    // What is named twice beside the coordinates is not told.
    for twice in [ColumnRole::Intensity, ColumnRole::Red, ColumnRole::Green, ColumnRole::Blue] {
        if meanings.iter().filter(|m| **m == Is(twice)).count() > 1 {
            meanings.iter_mut().filter(|m| **m == Is(twice)).for_each(|m| *m = Aside);
        }
    }
}

fn meaning(name: &str) -> Meaning {
    match name {
        "x" => Is(ColumnRole::X),
        "y" => Is(ColumnRole::Y),
        "z" | "elevation" | "elev" | "height" | "altitude" | "alt" | "h" | "hoehe" | "höhe" => Is(ColumnRole::Z),
        "easting" | "east" | "e" | "rechtswert" | "rechts" | "ost" | "ostwert" => East,
        "northing" | "north" | "hochwert" | "hoch" | "nord" | "nordwert" => North,
        "n" => N,
        "i" | "intensity" | "reflectance" => Is(ColumnRole::Intensity),
        "r" | "red" => Is(ColumnRole::Red),
        "g" | "green" => Is(ColumnRole::Green),
        "b" | "blue" => Is(ColumnRole::Blue),
        "lat" | "latitude" | "lon" | "lng" | "long" | "longitude" => Angle,
        "id" | "nr" | "no" | "num" | "number" | "p" | "pt" | "pnt" | "point" | "pointid" | "pointno" | "pointnr"
        | "pointnumber" | "pointname" | "pid" | "punkt" | "punktnummer" | "punktnr" | "punktname" | "name" | "row"
        | "col" | "column" | "time" | "gpstime" | "timestamp" | "date" | "code" | "class" | "classification" => Aside,
        _ => Unknown,
    }
}

/// The cells of a title: separated as fits the rows, by marks or otherwise by blanks.
fn cells(line: &str, row: Width) -> Vec<String> {
    let bare = line.trim_start_matches(['/', '#', '!', '%', ' ', '\t']);
    // "Columns: x y z"
    let labelled = bare.split_once(':').map(|(_, rest)| rest.trim());
    let mut by_blanks = None;
    for text in [Some(bare), labelled].into_iter().flatten() {
        for cells in [by_marks(text), by_anything(text)] {
            if cells.len() == row.all || cells.len() == row.filled {
                return cells;
            }
            by_blanks.get_or_insert(cells);
        }
    }
    if line.contains([';', '|', ',', '\t']) { by_blanks.unwrap_or_default() } else { by_anything(bare) }
}

fn by_marks(text: &str) -> Vec<String> {
    let mark = [';', '|', ',', '\t'].into_iter().find(|m| text.contains(*m)).unwrap_or(' ');
    let mut cells: Vec<String> = unquoted(text, &[mark]).map(|c| c.trim_matches([' ', '\t', '"']).to_owned()).collect();
    while cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    cells
}

/// Splits at blanks and marks; a unit in brackets belongs to what precedes it.
fn by_anything(text: &str) -> Vec<String> {
    let mut cells: Vec<String> = Vec::new();
    for word in unquoted(text, &[' ', '\t', ',', ';', '|']).map(|w| w.trim_matches('"')).filter(|w| !w.is_empty()) {
        let is_unit = word.starts_with(['[', '(']) && meaning(&name_and_unit(word).0) == Unknown;
        let is_number = |l: &String| {
            l.eq_ignore_ascii_case("point") && ["id", "no", "no.", "nr", "nr."].contains(&&*word.to_lowercase())
        };
        match cells.last_mut() {
            Some(last) if is_unit || is_number(last) => last.extend([" ", word]),
            _ => cells.push(word.to_owned()),
        }
    }
    cells
}

/// The bare name of a cell, and its unit if it has one: `X [m]`, `x(m)`, `coord_x`, `x_m`.
fn name_and_unit(cell: &str) -> (String, Option<&str>) {
    let (name, unit) = match cell.find(['[', '(']) {
        Some(at) if at > 0 => (&cell[..at], Some(cell[at..].trim_matches(['[', ']', '(', ')', ' ']))),
        Some(_) => (cell.trim_matches(['[', ']', '(', ')', ' ']), None),
        None => match cell.rsplit_once(['_', '/', ' ']) {
            Some((name, unit)) if unit_named(unit).is_some() => (name, Some(unit)),
            _ => (cell, None),
        },
    };
    let mut bare = name.to_lowercase().replace([' ', '_', '-', '.', ':', '"'], "");
    for extra in ["coordinate", "koordinate", "coord", "pos"] {
        let short = bare.strip_prefix(extra).or_else(|| bare.strip_suffix(extra));
        if let Some(short) = short.filter(|s| !s.is_empty()) {
            bare = short.to_owned();
        }
    }
    (bare, unit)
}

/// The unit given with the names of the coordinates.
fn unit_of(cells: &[&str; 3]) -> Result<Option<Unit>, String> {
    let mut named = Vec::new();
    for cell in cells {
        let Some(word) = name_and_unit(cell).1 else {
            named.push(None);
            continue;
        };
        match unit_named(word) {
            Some(Some(unit)) => named.push(Some(unit)),
            Some(None) => {
                return Err(format!("its title names the unit {word}, which is none of m, cm, mm, ft, us-ft, in"));
            }
            None => named.push(None),
        }
    }
    let first = named.iter().flatten().next().copied();
    let is_one = named.iter().all(|n| *n == first || n.is_none() && first == Some(Unit::M));
    if is_one { Ok(first) } else { Err(format!("its title names different units: {}", cells.join(", "))) }
}

/// `Some(None)` is a unit that is not supported.
fn unit_named(word: &str) -> Option<Option<Unit>> {
    Some(match word.to_lowercase().as_str() {
        "m" | "metre" | "metres" | "meter" | "meters" => Some(Unit::M),
        "cm" | "centimetres" | "centimeters" => Some(Unit::Cm),
        "mm" | "millimetres" | "millimeters" => Some(Unit::Mm),
        "ft" | "feet" | "foot" => Some(Unit::Ft),
        "us-ft" | "usft" | "us ft" | "ftus" | "us survey feet" | "us survey foot" => Some(Unit::UsFt),
        "in" | "inch" | "inches" => Some(Unit::In),
        "km" | "dm" | "yd" | "µm" | "um" | "deg" | "degree" | "degrees" | "°" | "gon" | "rad" => None,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(title: &str, n: usize) -> Option<Result<String, String>> {
        of(title, Width { all: n, filled: n }).map(|t| t.map(|t| t.columns.to_string()))
    }

    #[test]
    fn titles_tell_columns() {
        for (title, n, expected) in [
            ("//X Y Z R G B", 6, "x,y,z,r,g,b"),
            ("\"id\";\"x\";\"y\";\"z\"", 4, "-,x,y,z"),
            ("X Y Z", 4, "x,y,z"),
            ("# Columns: x y z i", 4, "x,y,z,i"),
            ("ID,Easting,Northing,Elevation", 4, "-,x,y,z"),
            ("Nr;Rechtswert;Hochwert;Höhe", 4, "-,x,y,z"),
            ("P,N,E,Z,D", 5, "-,y,x,z,-"),
            ("n x y z", 4, "-,x,y,z"),
            ("Northing,Easting,Elevation", 3, "y,x,z"),
            ("Hochwert Rechtswert Hoehe", 3, "y,x,z"),
            ("Point ID;X;Y;Z", 4, "-,x,y,z"),
            ("Point ID X Y Z", 4, "-,x,y,z"),
            ("Intensity [0-1] X Y Z", 4, "i,x,y,z"),
            ("intensity;coord_x;coord_y;coord_z", 4, "i,x,y,z"),
            ("i intensity x y z", 5, "-,-,x,y,z"),
        ] {
            assert_eq!(told(title, n), Some(Ok(expected.into())), "{title}");
        }
    }

    #[test]
    fn titles_that_do_not_tell_are_refused() {
        for (title, n, words) in [
            ("Y X Z", 3, "does x go north"),
            ("lat,lon,h", 3, "degrees"),
            ("x;y;i;r", 4, "--columns"),
            ("x,y,z,easting", 4, "--columns"),
            ("id x y z", 5, "--columns"),
            ("X[mm] Y[mm] Z[m]", 3, "different units"),
            ("X[km] Y[km] Z[km]", 3, "none of"),
        ] {
            assert!(told(title, n).unwrap().unwrap_err().contains(words), "{title}");
        }
        for (title, n) in [("Project: hall", 2), ("Halle Nord 3", 3), ("# height of the tripod 1.5", 3)] {
            assert_eq!(told(title, n), None, "{title}");
        }
    }

    #[test]
    fn titles_tell_units() {
        let unit = |title: &str, n| of(title, Width { all: n, filled: n }).unwrap().unwrap().unit;
        assert_eq!(unit("X[mm] Y[mm] Z[mm]", 3), Some(Unit::Mm));
        assert_eq!(unit("X (ft),Y (ft),Z (ft)", 3), Some(Unit::Ft));
        assert_eq!(unit("GpsTime[s] X[m] Y[m] Z[m]", 4), Some(Unit::M));
        assert_eq!(unit("x_cm;y_cm;z_cm;i", 4), Some(Unit::Cm));
        assert_eq!(unit("Rechtswert Hochwert Höhe [m]", 3), Some(Unit::M));
        assert_eq!(unit("x y z", 3), None);
    }
}
