//! Coloured voxels as PLY, LAS or LAZ: the colours of Meyer (2022), Fig. 7.2.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::voxel::ChangeClass;
use las::{Builder, Color, Point, Transform, Vector, Writer};
use ply_rs_bw::ply::{Addable, ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult};
use ply_rs_bw::ply::{PropertyDef, PropertyType, ScalarType};

use super::tiles::ChangeTile;

/// Red, green, blue.
fn colour(class: ChangeClass) -> [u8; 3] {
    match class {
        ChangeClass::Confirmed => [0, 160, 60],
        ChangeClass::New => [255, 210, 0],
        ChangeClass::Disappeared => [220, 30, 30],
        ChangeClass::Unknown => [40, 90, 220],
        ChangeClass::Ambiguous => [160, 160, 160],
    }
}

/// The formats, by the file's extension.
#[derive(Debug, Clone, Copy, PartialEq)]
enum VoxelFileFormat {
    Ply,
    Las,
}

fn kind(path: &Path) -> Result<VoxelFileFormat> {
    match path.extension().map(|e| e.to_string_lossy().to_lowercase()).as_deref() {
        Some("ply") => Ok(VoxelFileFormat::Ply),
        Some("las" | "laz") => Ok(VoxelFileFormat::Las),
        _ => bail!("{}: an export is .ply, .las or .laz", path.display()),
    }
}

/// Fails early where the name indicates no format.
pub fn check(path: &Path) -> Result<()> {
    kind(path).map(|_| ())
}

/// Writes the centres of all voxels of the comparison, whose number is given; returns how many were written.
pub fn write(tiles: &[ChangeTile], count: u64, path: &Path) -> Result<u64> {
    // A file that is cut short is not left behind under the name asked for.
    let part = PathBuf::from(format!("{}.part", path.display()));
    let written = write_all(tiles, kind(path)?, path, &part, count);
    match written {
        Ok(()) => std::fs::rename(&part, path).with_context(|| format!("cannot write {}", path.display()))?,
        Err(_) => drop(std::fs::remove_file(&part)),
    }
    written.map(|()| count)
}

fn write_all(tiles: &[ChangeTile], kind: VoxelFileFormat, path: &Path, part: &Path, count: u64) -> Result<()> {
    let file = File::create(part).with_context(|| format!("cannot write {}", part.display()))?;
    // LAS counts steps of 0.1 mm in 32 bits: from a round coordinate nearby.
    let corner = tiles.iter().fold(Aabb::EMPTY, |a, t| a.union(&t.bounds)).min;
    let offset = corner.map(|c| if c.is_finite() { c.floor() } else { 0.0 });
    let mut sink = VoxelWriter::new(kind, path, BufWriter::with_capacity(1 << 20, file), count, offset)?;
    for tile in tiles {
        let change = tile.change()?;
        let mut result = Ok(());
        change.for_each(NEVER, |voxel, class| {
            if result.is_ok() {
                result = sink.push(&change.grid().centre(voxel), class);
            }
        })?;
        result?;
    }
    sink.finish()
}

enum VoxelWriter {
    Ply { out: BufWriter<File>, writer: ply_rs_bw::writer::Writer<VoxelPoint>, vertex: ElementDef },
    Las(Writer<BufWriter<File>>),
}

impl VoxelWriter {
    fn new(kind: VoxelFileFormat, path: &Path, mut out: BufWriter<File>, count: u64, offset: [f64; 3]) -> Result<Self> {
        match kind {
            VoxelFileFormat::Ply => {
                let (writer, header) = (ply_rs_bw::writer::Writer::new(), header(count));
                writer.write_header(&mut out, &header)?;
                let vertex = header.elements["vertex"].clone();
                Ok(Self::Ply { out, writer, vertex })
            }
            VoxelFileFormat::Las => {
                let mut builder = Builder::from((1, 4));
                builder.point_format = las::point::Format::new(7)?;
                builder.point_format.is_compressed = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("laz"));
                let [x, y, z] = offset.map(|offset| Transform { scale: 1e-4, offset });
                builder.transforms = Vector { x, y, z };
                Ok(Self::Las(Writer::new(out, builder.into_header()?)?))
            }
        }
    }

    fn push(&mut self, at: &Vec3, class: ChangeClass) -> Result<()> {
        match self {
            Self::Ply { out, writer, vertex } => {
                writer.write_little_endian_element(out, &VoxelPoint { at: *at, class }, vertex)?;
            }
            Self::Las(writer) => {
                let [red, green, blue] = colour(class).map(|c| u16::from(c) * 257);
                let color = Some(Color { red, green, blue });
                let point = Point {
                    x: at.x,
                    y: at.y,
                    z: at.z,
                    color,
                    gps_time: Some(0.0),
                    user_data: class as u8,
                    ..Point::default()
                };
                writer.write_point(point)?;
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<()> {
        match self {
            Self::Ply { mut out, .. } => out.flush().context("cannot write the file to its end"),
            Self::Las(mut writer) => writer.close().context("cannot write the file to its end"),
        }
    }
}

/// The head of a PLY file of voxels.
fn header(count: u64) -> Header {
    let mut vertex = ElementDef::new("vertex".to_owned());
    vertex.count = count as usize;
    let mut property = |name: &str, scalar: ScalarType| {
        vertex.properties.add(PropertyDef::new(name.to_owned(), PropertyType::Scalar(scalar)));
    };
    ["x", "y", "z"].iter().for_each(|name| property(name, ScalarType::Double));
    ["red", "green", "blue", "class"].iter().for_each(|name| property(name, ScalarType::UChar));
    let mut header = Header::new();
    header.encoding = Encoding::BinaryLittleEndian;
    let classes: Vec<String> = ChangeClass::ALL.iter().map(|c| format!("{} {}", *c as u8, c.name())).collect();
    header.comments.push(format!("asbuilt change; class: {}", classes.join(", ")));
    header.elements.add(vertex);
    header
}

/// A voxel as the library asks for it.
struct VoxelPoint {
    at: Vec3,
    class: ChangeClass,
}

impl PropertyAccess for VoxelPoint {
    fn new() -> Self {
        Self { at: Vec3::zeros(), class: ChangeClass::Unknown }
    }

    fn set_property(&mut self, _: &str, _: Property) -> PropertyAccessResult {
        PropertyAccessResult::Ignored
    }

    fn get_double(&self, name: &str) -> Option<f64> {
        ["x", "y", "z"].iter().position(|n| *n == name).map(|i| self.at[i])
    }

    fn get_uchar(&self, name: &str) -> Option<u8> {
        let parts = colour(self.class);
        match name {
            "class" => Some(self.class as u8),
            _ => ["red", "green", "blue"].iter().position(|n| *n == name).map(|i| parts[i]),
        }
    }
}
