//! `ab_solid`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::{Closedness, Solid, SolidHeader, Vec3};
use asbuilt_core::num::text::{from_hex, to_hex};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use crate::pg::{Args, Ret, interrupt, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_solid:1:";

fn header(args: &Args) -> Result<SolidHeader> {
    Solid::header(args.prefix(0, Solid::HEADER_LEN))
}

/// Rows of three from an array of n x 3.
fn triples<T: Copy>(what: &'static str, dims: &[i32], values: &[T]) -> Result<Vec<[T; 3]>> {
    if dims.len() != 2 || dims[1] != 3 {
        let shape = dims.iter().map(i32::to_string).collect::<Vec<_>>().join(" x ");
        return Err(Error::argument(
            what,
            "an array of n x 3 numbers",
            if shape.is_empty() { "empty".into() } else { shape },
        ));
    }
    Ok(values.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect())
}

fn from_arrays(args: &Args) -> Result<Solid> {
    let (dims, values) = args.f64_array(0, "the solid's vertices")?;
    let vertices: Vec<Vec3> = triples("the solid's vertices", &dims, &values)?.into_iter().map(Vec3::from).collect();
    let (dims, values) = args.i32_array(1, "the solid's triangles")?;
    let triangles = triples("the solid's triangles", &dims, &values)?;
    for (t, tri) in triangles.iter().enumerate() {
        if let Some(&i) = tri.iter().find(|&&i| i < 0) {
            return Err(Error::TriangleIndex { triangle: t, index: i64::from(i), vertices: vertices.len() });
        }
    }
    Solid::interruptible(vertices, triangles.into_iter().map(|t| t.map(|i| i as u32)).collect(), &interrupt)
}

sql_functions! {
    fn ab_solid_in(args) {
        let bytes = from_hex("ab_solid", PREFIX, &args.cstring(0))?;
        Ok(Ret::Bytes(Solid::from_bytes(&bytes, &interrupt)?.to_bytes()))
    }

    fn ab_solid_out(args) {
        Ok(Ret::CString(to_hex(PREFIX, args.bytes(0))))
    }

    fn ab_solid_recv(args) {
        Ok(Ret::Bytes(Solid::from_bytes(args.message(0), &interrupt)?.to_bytes()))
    }

    fn ab_solid_send(args) {
        Ok(Ret::Bytes(args.bytes(0).to_vec()))
    }

    /// ab_solid(vertices float8[][], triangles int[][])
    fn ab_solid_make(args) {
        Ok(Ret::Bytes(from_arrays(args)?.to_bytes()))
    }

    /// ab_solid(ab_box): a cuboid.
    fn ab_solid_from_box(args) {
        let b = super::box_from(&args.fixed(0));
        Ok(Ret::Bytes(Solid::cuboid(b.min, b.max)?.to_bytes()))
    }

    fn ab_solid_box(args) {
        Ok(Ret::Fixed(box_bytes(&header(args)?.bounds)))
    }

    fn ab_solid_area(args) {
        Ok(Ret::F64(header(args)?.area))
    }

    fn ab_solid_volume(args) {
        let h = header(args)?;
        if h.closedness == Closedness::Open { Err(Error::OpenSurface) } else { Ok(Ret::F64(h.volume)) }
    }

    fn ab_solid_closedness(args) {
        Ok(Ret::text(header(args)?.closedness.label()))
    }

    fn ab_solid_vertices(args) {
        let s = Solid::from_stored(args.bytes(0))?;
        let flat = s.vertices().iter().flat_map(|v| [v.x, v.y, v.z]).collect();
        Ok(Ret::F64Array(flat, vec![s.vertices().len() as i32, 3]))
    }

    fn ab_solid_triangles(args) {
        let s = Solid::from_stored(args.bytes(0))?;
        let flat = s.triangles().iter().flatten().map(|&i| i as i32).collect();
        Ok(Ret::I32Array(flat, vec![s.triangles().len() as i32, 3]))
    }
}
