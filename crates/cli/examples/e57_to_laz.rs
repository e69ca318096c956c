//! The points of an E57 file as LAZ at 0.1 mm, for comparing sizes: `e57_to_laz IN.e57 OUT.laz`.

use std::error::Error;

use e57::{CartesianCoordinate, E57Reader};
use las::{Builder, Point, Transform, Vector, Writer, point::Format};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().collect();
    let [_, input, output] = &args[..] else { return Err("usage: e57_to_laz IN.e57 OUT.laz".into()) };
    let mut builder = Builder::from((1, 4));
    builder.point_format = Format::new(0)?;
    builder.point_format.is_compressed = true;
    let axis = Transform { scale: 1e-4, offset: 0.0 };
    builder.transforms = Vector { x: axis, y: axis, z: axis };
    let mut writer = Writer::from_path(output, builder.into_header()?)?;
    let mut file = E57Reader::from_file(input)?;
    for cloud in file.pointclouds() {
        for point in file.pointcloud_simple(&cloud)? {
            if let CartesianCoordinate::Valid { x, y, z } = point?.cartesian {
                writer.write_point(Point { x, y, z, ..Point::default() })?;
            }
        }
    }
    writer.close()?;
    Ok(())
}
