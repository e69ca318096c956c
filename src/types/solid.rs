//! `ab_solid`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::{Closedness, Solid, SolidHeader, SurfaceKind, Vec3};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::hex::{hex_in, hex_out};
use crate::pg::{Args, Backend, SqlValue, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_solid:1:";

fn header(args: &Args) -> Result<SolidHeader> {
    Solid::header(args.prefix(0, Solid::HEADER_LEN))
}

fn from_arrays(args: &Args) -> Result<Solid> {
    let vertices: Vec<Vec3> = args.f64_triples(0, "the solid's vertices")?.into_iter().map(Vec3::from).collect();
    let triangles = args.i32_triples(1, "the solid's triangles")?;
    for (t, tri) in triangles.iter().enumerate() {
        if let Some(&i) = tri.iter().find(|&&i| i < 0) {
            return Err(Error::TriangleIndex { triangle: t, index: i64::from(i), vertices: vertices.len() });
        }
    }
    Solid::interruptible(vertices, triangles.into_iter().map(|t| t.map(|i| i as u32)).collect(), &Backend)
}

sql_functions! {
    fn ab_solid_in(args) {
        let bytes = hex_in(args, "ab_solid", PREFIX)?;
        Ok(SqlValue::Bytes(Solid::from_bytes(&bytes, &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_solid_out(args) {
        hex_out(args, PREFIX)
    }

    fn ab_solid_recv(args) {
        Ok(SqlValue::Bytes(Solid::from_bytes(args.message(0), &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_solid_send(args) {
        Ok(args.copied(0))
    }

    /// ab_solid(vertices float8[][], triangles int[][])
    fn ab_solid_make(args) {
        Ok(SqlValue::Bytes(from_arrays(args)?.to_bytes(&Backend)?))
    }

    /// ab_solid(ab_box): a cuboid.
    fn ab_solid_from_box(args) {
        let b = super::box_from(&args.fixed(0));
        Ok(SqlValue::Bytes(Solid::cuboid(b.min, b.max)?.to_bytes(&Backend)?))
    }

    fn ab_solid_box(args) {
        Ok(SqlValue::Fixed(box_bytes(&header(args)?.bounds)))
    }

    fn ab_solid_area(args) {
        Ok(SqlValue::F64(header(args)?.area))
    }

    fn ab_solid_volume(args) {
        let h = header(args)?;
        if h.closedness == Closedness::Open { Err(Error::OpenSurface) } else { Ok(SqlValue::F64(h.volume)) }
    }

    fn ab_solid_closedness(args) {
        Ok(SqlValue::text(header(args)?.closedness.label()))
    }

    fn ab_solid_vertices(args) {
        let s = Solid::from_stored(args.bytes(0), &Backend)?;
        let flat = s.vertices().iter().flat_map(|v| [v.x, v.y, v.z]).collect();
        Ok(SqlValue::F64Array(flat, vec![s.vertices().len() as i32, 3]))
    }

    fn ab_solid_triangles(args) {
        let s = Solid::from_stored(args.bytes(0), &Backend)?;
        let flat = s.triangles().iter().flatten().map(|&i| i as i32).collect();
        Ok(SqlValue::I32Array(flat, vec![s.triangles().len() as i32, 3]))
    }

    fn ab_solid_from_ewkb(args) {
        Ok(SqlValue::Bytes(Solid::from_ewkb(args.bytes(0), &Backend)?.to_bytes(&Backend)?))
    }

    /// ab_as_ewkb(solid, tin)
    fn ab_solid_as_ewkb(args) {
        let kind = if args.bool(1) { SurfaceKind::Tin } else { SurfaceKind::Polyhedral };
        Ok(SqlValue::Bytes(Solid::from_stored(args.bytes(0), &Backend)?.to_ewkb(kind, &Backend)?))
    }
}
