//! PLY: the [`header`] normalised, binary rows through the `ply-rs-bw` crate. Without `--origin` the points have
//! none.

mod header;

use std::fs::File;
use std::io::{BufRead, BufReader, Seek};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};

use super::text::Lines;
use super::{Facts, ReadOptions, ScanSink, scan_of_points};

struct Vertex([f64; 3]);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self([f64::NAN; 3])
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let Some(axis) = ["x", "y", "z"].iter().position(|n| *n == name) else { return PropertyAccessResult::Ignored };
        self.0[axis] = match value {
            Property::Float(v) => f64::from(v),
            Property::Double(v) => v,
            Property::Int(v) => f64::from(v),
            Property::UInt(v) => f64::from(v),
            Property::Short(v) => f64::from(v),
            Property::UShort(v) => f64::from(v),
            _ => return PropertyAccessResult::Ignored,
        };
        PropertyAccessResult::Set
    }
}

/// An element that is skipped.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}

/// Reads the vertices.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let mut file = BufReader::with_capacity(1 << 20, File::open(path).context("cannot open it")?);
    let length = file.get_ref().metadata()?.len();
    let (header, lines) = header::read(&mut file)?;
    let room = length - file.stream_position()?;
    check(&header, room)?;
    let Some(element) = header.elements.get("vertex") else { bail!("it has no vertices") };
    let places = places(element)?;
    bar.set_length(element.count as u64);
    let is_last = header.elements.keys().last().is_some_and(|name| name == "vertex");
    let (points, has_more) = match header.encoding {
        Encoding::Ascii => {
            let lines = Lines::of(Box::new(file), lines, bar).with_decimal_commas(options.decimal_comma);
            ascii(lines, &header, places, bar)?
        }
        _ => binary(Reader::new(file), &header, bar)?,
    };
    let mut scan = scan_of_points(path, points, options)?;
    if has_more && is_last {
        scan.notes.push(format!("its header counts {} vertices; more follow, which were not read", element.count));
    }
    let names: Vec<&str> = element.properties.keys().map(String::as_str).collect();
    scan.facts = Facts::from([
        ("encoding".into(), format!("{:?}", header.encoding)),
        ("points".into(), element.count.to_string()),
        ("fields".into(), names.join(" ")),
        ("unit".into(), "not told".into()),
    ]);
    sink(scan)
}

/// Positions of x, y, z among the properties, which must be numbers.
fn places(element: &ElementDef) -> Result<[usize; 3]> {
    let at = |name: &str| {
        let names = || element.properties.keys().map(String::as_str).collect::<Vec<_>>().join(" ");
        let found = element.properties.get_full(name);
        let (place, _, property) =
            found.ok_or_else(|| anyhow!("its vertices have no {name}; they have {}", names()))?;
        match property.data_type {
            PropertyType::Scalar(_) => Ok(place),
            PropertyType::List(..) => bail!("{name} of its vertices is a list"),
        }
    };
    Ok([at("x")?, at("y")?, at("z")?])
}

/// Refuses counts that cannot fit into the file; the library would believe them.
fn check(header: &Header, room: u64) -> Result<()> {
    let mut needed = 0u128;
    for e in header.elements.values() {
        let row: u128 = e.properties.values().map(|p| least_size(&p.data_type, header.encoding)).sum();
        if row == 0 && e.count > 0 {
            bail!("element {} has {} rows and no properties", e.name, e.count);
        }
        needed += e.count as u128 * row;
    }
    if needed > u128::from(room) + header.elements.len() as u128 {
        bail!("its header promises more than the file holds ({needed} bytes at least, {room} there)");
    }
    Ok(())
}

fn least_size(data_type: &PropertyType, encoding: Encoding) -> u128 {
    match (data_type, encoding) {
        (_, Encoding::Ascii) => 2, // a digit and a blank
        (PropertyType::Scalar(s), _) | (PropertyType::List(s, _), _) => match s {
            ScalarType::Char | ScalarType::UChar => 1,
            ScalarType::Short | ScalarType::UShort => 2,
            ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
            ScalarType::Double => 8,
        },
    }
}

/// The points, and whether anything follows them.
fn binary(mut reader: Reader<BufReader<File>>, header: &Header, bar: &ProgressBar) -> Result<(Vec<Vec3>, bool)> {
    let parser = Parser::<Vertex>::new();
    for (name, element) in &header.elements {
        if name != "vertex" {
            Parser::<Skipped>::new()
                .read_payload_for_element(&mut reader, element, header)
                .with_context(|| format!("element {name} is damaged"))?;
            continue;
        }
        let mut points = Vec::new();
        for i in 0..element.count {
            let vertex = match header.encoding {
                Encoding::BinaryBigEndian => parser.read_big_endian_element(reader.get_mut(), element)?.0,
                _ => parser.read_little_endian_element(reader.get_mut(), element)?.0,
            };
            points.push(Vec3::from(vertex));
            if i % 65_536 == 0 {
                bar.set_position(i as u64);
            }
        }
        let has_more = !reader.get_mut().fill_buf()?.is_empty();
        return Ok((points, has_more));
    }
    bail!("it has no vertices")
}

/// Lines of words. The library's grammar refuses `nan`, `.5`, `1.` and decimal commas, which real files contain.
fn ascii(mut lines: Lines, header: &Header, places: [usize; 3], bar: &ProgressBar) -> Result<(Vec<Vec3>, bool)> {
    for (name, element) in &header.elements {
        if name != "vertex" {
            for _ in 0..element.count {
                lines.next_filled()?;
            }
            continue;
        }
        let mut points = Vec::new();
        while points.len() < element.count {
            let Some(point) = lines.chosen("a vertex", |words| words_of(element, places, words))? else {
                bail!("it ends after {} of {} vertices", points.len(), element.count);
            };
            points.push(point.into());
            if points.len() % 65_536 == 0 {
                bar.set_position(points.len() as u64);
            }
        }
        let has_more = lines.next_filled()?;
        return Ok((points, has_more));
    }
    bail!("it has no vertices")
}

/// The words of a line that hold the properties at `places`: a list takes its first word, and as many more as that
/// says.
fn words_of(element: &ElementDef, places: [usize; 3], words: &[&str]) -> Option<[usize; 3]> {
    let (mut out, mut word) = ([0; 3], 0usize);
    for (place, property) in element.properties.values().enumerate() {
        for (slot, wanted) in out.iter_mut().zip(places) {
            if wanted == place {
                *slot = word;
            }
        }
        word += match property.data_type {
            PropertyType::Scalar(_) => 1,
            PropertyType::List(..) => words.get(word)?.parse::<usize>().ok()?.checked_add(1)?,
        };
        if word > words.len() {
            return None;
        }
    }
    // More words than properties: some of them are not what they are taken for.
    (word == words.len()).then_some(out)
}
