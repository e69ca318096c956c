//! A listing of scanner positions: `station,x,y,z[,sd]`, one a line.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use rustc_hash::FxHashMap;

/// A listing is written by people: what is longer is another file, given by mistake. Bytes.
const MAX_BYTES: u64 = 1 << 20;
/// No coordinate is larger, metres.
const MAX_COORDINATE_M: f64 = 1e9;

/// A line of the listing.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedStation {
    pub name: String,
    /// World metres.
    pub position_world: Vec3,
    /// Standard deviation an axis, metres.
    pub sd: Option<f64>,
}

impl ListedStation {
    /// The station as a point source id or the number of a scan.
    pub fn number(&self) -> Option<u64> {
        self.name.parse().ok()
    }
}

/// The stations in their order; at least one, each once.
#[derive(Debug, Clone, PartialEq)]
pub struct Listing {
    pub stations: Vec<ListedStation>,
}

impl Listing {
    pub fn read(path: &Path) -> Result<Self> {
        Self::read_text(path)
            .and_then(|text| Self::parse(&text))
            .with_context(|| format!("--origins {}", path.display()))
    }

    fn read_text(path: &Path) -> Result<String> {
        let file = File::open(path).context(
            "cannot open it; it must be a listing of scanner positions, or none, or recover (a file of that name: ./none)",
        )?;
        let mut bytes = Vec::new();
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes).context("cannot read it")?;
        if bytes.len() as u64 > MAX_BYTES {
            bail!("it is longer than 1 MB: a listing has a line station,x,y,z a scanner position");
        }
        match String::from_utf8(bytes) {
            Ok(text) if !text.contains('\0') => Ok(text),
            _ => bail!("it is no text in UTF-8: a listing has a line station,x,y,z a scanner position"),
        }
    }

    fn parse(text: &str) -> Result<Self> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (mut stations, mut seen) = (Vec::new(), FxHashMap::default());
        let mut may_be_title = true;
        for (i, line) in text.lines().enumerate() {
            let content = line.split('#').next().unwrap_or_default().trim();
            if content.is_empty() {
                continue;
            }
            let cells = cells(content);
            if std::mem::take(&mut may_be_title) && is_title(&cells) {
                check_title(&cells).with_context(|| format!("line {}", i + 1))?;
                continue;
            }
            let station = station(&cells).with_context(|| format!("line {}: \"{}\"", i + 1, shown(content)))?;
            if let Some(first) = seen.insert(station.name.to_lowercase(), i + 1) {
                bail!("line {}: station \"{}\" is listed in line {first} already", i + 1, station.name);
            }
            stations.push(station);
        }
        if stations.is_empty() {
            bail!("it lists no station: a line station,x,y,z is wanted for each scanner position");
        }
        Ok(Self { stations })
    }

    /// The stations' names, for a message.
    pub fn shown(&self) -> String {
        some(self.stations.iter().map(|s| s.name.clone()))
    }
}

/// The beginning of a list of names.
pub fn some(names: impl Iterator<Item = String>) -> String {
    const SHOWN: usize = 10;
    let names: Vec<String> = names.collect();
    let more = names.len().saturating_sub(SHOWN);
    let first = names.iter().take(SHOWN).map(|n| shown(n)).collect::<Vec<_>>().join(", ");
    if more > 0 { format!("{first} … and {more} more") } else { first }
}

/// A text cut to a length that a message can bear.
fn shown(text: &str) -> String {
    const SHOWN: usize = 60;
    if text.chars().count() <= SHOWN { text.into() } else { text.chars().take(SHOWN).chain(['…']).collect() }
}

/// Separated by semicolons, else by commas, else by blanks.
fn cells(line: &str) -> Vec<&str> {
    let mark = [';', ','].into_iter().find(|mark| line.contains(*mark));
    let cells: Vec<&str> = match mark {
        Some(mark) => line.split(mark).collect(),
        None => line.split_whitespace().collect(),
    };
    cells.into_iter().map(|cell| cell.trim().trim_matches('"').trim()).collect()
}

/// A first line without any number where coordinates should be.
fn is_title(cells: &[&str]) -> bool {
    let has_digit = |cell: &&str| cell.contains(|c: char| c.is_ascii_digit());
    cells.len() > 1 && !cells[1..].iter().any(has_digit) && cells[1..].iter().all(|c| c.parse::<f64>().is_err())
}

/// Columns in another order would put the scanners elsewhere.
fn check_title(cells: &[&str]) -> Result<()> {
    const WORDS: [(&str, &[&str]); 3] = [
        ("x", &["x", "e", "east", "easting", "rechtswert"]),
        ("y", &["y", "n", "north", "northing", "hochwert"]),
        ("z", &["z", "h", "u", "up", "height", "elevation", "höhe"]),
    ];
    for (k, (axis, words)) in WORDS.iter().enumerate() {
        let cell = cells.get(k + 1).copied().unwrap_or_default().to_lowercase();
        let word = cell.split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
        if !words.contains(&word) {
            bail!("its title has \"{cell}\" where {axis} is wanted: the columns must be station,x,y,z[,sd], metres");
        }
    }
    Ok(())
}

fn station(cells: &[&str]) -> Result<ListedStation> {
    if !(4..=5).contains(&cells.len()) {
        bail!("{} values where station,x,y,z or station,x,y,z,sd are wanted", cells.len());
    }
    let name = cells[0].to_owned();
    if name.is_empty() {
        bail!("the station has no name");
    }
    let position = [coordinate(cells[1], "x")?, coordinate(cells[2], "y")?, coordinate(cells[3], "z")?];
    let sd = cells.get(4).filter(|c| !c.is_empty()).map(|c| deviation(c)).transpose()?;
    Ok(ListedStation { name, position_world: position.into(), sd })
}

fn coordinate(text: &str, axis: &str) -> Result<f64> {
    match text.parse::<f64>() {
        Ok(v) if v.abs() <= MAX_COORDINATE_M => Ok(v),
        Ok(_) => bail!("{axis} is {text}, and must be finite and within 1e9 m"),
        Err(_) => bail!("{axis} is \"{text}\", which is no number; decimals are written with a point, in metres"),
    }
}

fn deviation(text: &str) -> Result<f64> {
    match text.parse::<f64>() {
        Ok(v) if v >= 0.0 && v.is_finite() => Ok(v),
        _ => bail!("sd is \"{text}\", and must be a standard deviation in metres, 0 or more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_listing_is_read_in_every_dress() {
        let want = |sd: Option<f64>| {
            let station =
                |name: &str, x: f64| ListedStation { name: name.into(), position_world: Vec3::new(x, -2.5, 1.6), sd };
            Listing { stations: vec![station("1", 1.0), station("2", 12.25)] }
        };
        for text in [
            "1,1,-2.5,1.6\n2,12.25,-2.5,1.6\n",
            "\u{feff}station,x,y,z\r\n1,1.0,-2.5,1.6\r\n2,12.25,-2.5,1.6\r\n",
            "# the tripods\n\n1 1 -2.5 1.6 # behind the door\n2\t12.25  -2.5\t1.6",
            "Station;East [m];North [m];Height [m]\n\"1\"; 1; -2.5; 1.6;\n2;12.25;-2.5;1.6;\n",
        ] {
            assert_eq!(Listing::parse(text).unwrap(), want(None), "{text}");
        }
        assert_eq!(
            Listing::parse("id x y z sd\n1 1 -2.5 1.6 0.002\n2 12.25 -2.5 1.6 2e-3").unwrap(),
            want(Some(0.002))
        );
        let named = Listing::parse("Scan 001, 1, 2, 3\nnone, 4, 5, 6").unwrap();
        assert_eq!(named.shown(), "Scan 001, none");
        assert_eq!(named.stations[0].number(), None);
    }

    #[test]
    fn errors_name_line_and_value() {
        for (text, words) in [
            ("", "lists no station"),
            ("# nothing\nstation,x,y,z\n", "lists no station"),
            ("1,2,3\n", "line 1: \"1,2,3\": 3 values where station,x,y,z"),
            ("1,2,3,4,0.1,9\n", "line 1: \"1,2,3,4,0.1,9\": 6 values"),
            ("a,1,2,3\nb,1,two,3\n", "line 2: \"b,1,two,3\": y is \"two\""),
            ("a;1,5;2,5;3\n", "x is \"1,5\", which is no number; decimals are written with a point"),
            ("a,1,2,inf\n", "z is inf"),
            ("a,NaN,2,3\n", "x is NaN"),
            ("a,1,-2e9,3\n", "y is -2e9"),
            ("a,1,2,3,-0.1\n", "sd is \"-0.1\""),
            ("a,1,2,3,NaN\n", "sd is \"NaN\""),
            (",1,2,3\n", "has no name"),
            ("3,1,2,3\n# again\n3,4,5,6\n", "line 3: station \"3\" is listed in line 1 already"),
            ("station,y,x,z\n1,1,2,3\n", "line 1: its title has \"y\" where x is wanted"),
            ("a,1,2,3\nstation,x,y,z\n", "line 2: \"station,x,y,z\": x is \"x\""),
        ] {
            let said = format!("{:#}", Listing::parse(text).unwrap_err());
            assert!(said.contains(words), "{text:?}: {said}");
        }
    }

    #[test]
    fn files_that_are_no_listing() {
        let file = std::env::temp_dir().join(format!("asbuilt-listing-{}.csv", std::process::id()));
        let said = |content: &[u8]| {
            std::fs::write(&file, content).unwrap();
            format!("{:#}", Listing::read(&file).unwrap_err())
        };
        assert!(said(&vec![b'1'; 1 << 20 | 1]).contains("longer than 1 MB"));
        assert!(said(b"LASF\0\0\x01\x02").contains("no text in UTF-8"));
        assert!(said(b"S\xfcd,1,2,3").contains("no text in UTF-8"));
        std::fs::remove_file(&file).unwrap();
        let said = format!("{:#}", Listing::read(&file).unwrap_err());
        assert!(said.contains("cannot open it") && said.contains("--origins"), "{said}");
    }
}
