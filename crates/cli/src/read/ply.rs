//! PLY, through the `ply-rs-bw` crate. Without `--origin` the points have none.

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

use super::text::numbers;
use super::{ReadOptions, Sink, scan_of_points};

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

/// An element that is read over.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}

/// Reads the vertices.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let file = File::open(path).context("cannot open it")?;
    let length = file.metadata()?.len();
    let mut reader = Reader::new(BufReader::with_capacity(1 << 20, file));
    let header = Parser::<Vertex>::new().read_header(&mut reader).context("not a readable PLY file")?;
    let room = length - reader.get_mut().stream_position()?;
    check(&header, room)?;
    for (name, element) in &header.elements {
        if name == "vertex" {
            bar.set_length(element.count as u64);
            let points = vertices(&mut reader, element, header.encoding, bar)?;
            return sink(scan_of_points(path, points, options.origin)?);
        }
        Parser::<Skipped>::new()
            .read_payload_for_element(&mut reader, element, &header)
            .with_context(|| format!("element {name} is damaged"))?;
    }
    bail!("it has no vertices")
}

/// Refuses counts that the file cannot hold; the library would believe them.
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

fn vertices(
    reader: &mut Reader<BufReader<File>>,
    e: &ElementDef,
    encoding: Encoding,
    bar: &ProgressBar,
) -> Result<Vec<Vec3>> {
    let parser = Parser::<Vertex>::new();
    let at = |name: &str| e.properties.get_index_of(name).ok_or_else(|| anyhow!("its vertices have no {name}"));
    let places = [at("x")?, at("y")?, at("z")?];
    let mut points = Vec::new();
    for i in 0..e.count {
        let vertex = match encoding {
            Encoding::BinaryLittleEndian => parser.read_little_endian_element(reader.get_mut(), e)?.0,
            Encoding::BinaryBigEndian => parser.read_big_endian_element(reader.get_mut(), e)?.0,
            Encoding::Ascii => ascii(reader.get_mut(), places).with_context(|| format!("vertex {i}"))?,
        };
        points.push(Vec3::from(vertex));
        if i % 65_536 == 0 {
            bar.set_position(i as u64);
        }
    }
    Ok(points)
}

/// The library's grammar refuses `nan`, `.5` and `1.`, which real files hold.
fn ascii(reader: &mut impl BufRead, places: [usize; 3]) -> Result<[f64; 3]> {
    let mut line = String::new();
    if reader.read_line(&mut line)? == 0 {
        bail!("the file ends before it");
    }
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let mut out = [0.0; 3];
    for (slot, place) in out.iter_mut().zip(places) {
        let word = words.get(place).copied().unwrap_or("");
        [*slot] =
            numbers::<1>(word).ok_or_else(|| anyhow!("\"{}\" has no number at place {}", line.trim(), place + 1))?;
    }
    Ok(out)
}
