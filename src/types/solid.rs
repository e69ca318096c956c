//! `ab_solid`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::{Aabb, Closedness, Solid, SolidHeader, SurfaceKind, Vec3};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::hex::{hex_in, hex_out};
use crate::pg::{Backend, Bytea, F64Array, I32Array, Message, SqlValue, TextInput, Varlena, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_solid:1:";

/// A solid.
pub type SolidArg<'a> = Varlena<'a, Solid>;

impl SolidArg<'_> {
    /// Its header alone.
    pub fn header(&self) -> Result<SolidHeader> {
        Solid::header(self.prefix(Solid::HEADER_LEN))
    }

    /// The whole of it.
    pub fn read(&self) -> Result<Solid> {
        Solid::from_stored(self.bytes(), &Backend)
    }
}

/// A solid of arrays, without parts.
pub fn from_arrays(vertices: &F64Array, triangles: &I32Array) -> Result<Solid> {
    let vertices: Vec<Vec3> = vertices.triples("the solid's vertices")?.into_iter().map(Vec3::from).collect();
    let triangles = triangles.triples("the solid's triangles")?;
    for (t, tri) in triangles.iter().enumerate() {
        if let Some(&i) = tri.iter().find(|&&i| i < 0) {
            return Err(Error::TriangleIndex { triangle: t, index: i64::from(i), vertices: vertices.len() });
        }
    }
    Solid::interruptible(vertices, triangles.into_iter().map(|t| t.map(|i| i as u32)).collect(), &Backend)
}

sql_functions! {
    fn ab_solid_in(text: TextInput) {
        let bytes = hex_in(&text, "ab_solid", PREFIX)?;
        Ok(SqlValue::Bytes(Solid::from_bytes(&bytes, &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_solid_out(solid: SolidArg) {
        hex_out(&solid, PREFIX)
    }

    fn ab_solid_recv(message: Message) {
        Ok(SqlValue::Bytes(Solid::from_bytes(message.rest(), &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_solid_send(solid: SolidArg) {
        Ok(solid.copied())
    }

    fn ab_solid_make(vertices: F64Array, triangles: I32Array) {
        Ok(SqlValue::Bytes(from_arrays(&vertices, &triangles)?.to_bytes(&Backend)?))
    }

    /// A cuboid.
    fn ab_solid_from_box(bounds: Aabb) {
        Ok(SqlValue::Bytes(Solid::cuboid(bounds.min, bounds.max)?.to_bytes(&Backend)?))
    }

    fn ab_solid_box(solid: SolidArg) {
        Ok(SqlValue::Fixed(box_bytes(&solid.header()?.bounds)))
    }

    fn ab_solid_area(solid: SolidArg) {
        Ok(SqlValue::F64(solid.header()?.area))
    }

    fn ab_solid_volume(solid: SolidArg) {
        let h = solid.header()?;
        // NULL, not an error: one open surface is no reason to end a query over all.
        Ok(if h.closedness == Closedness::Open { SqlValue::Null } else { SqlValue::F64(h.volume) })
    }

    fn ab_solid_closedness(solid: SolidArg) {
        Ok(SqlValue::text(solid.header()?.closedness.label()))
    }

    fn ab_solid_vertices(solid: SolidArg) {
        let s = solid.read()?;
        let flat = s.vertices().iter().flat_map(|v| [v.x, v.y, v.z]).collect();
        Ok(SqlValue::F64Array(flat, vec![s.vertices().len() as i32, 3]))
    }

    fn ab_solid_triangles(solid: SolidArg) {
        let s = solid.read()?;
        let flat = s.triangles().iter().flatten().map(|&i| i as i32).collect();
        Ok(SqlValue::I32Array(flat, vec![s.triangles().len() as i32, 3]))
    }

    fn ab_solid_from_ewkb(ewkb: Varlena<Bytea>) {
        Ok(SqlValue::Bytes(Solid::from_ewkb(ewkb.bytes(), &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_solid_as_ewkb(solid: SolidArg, tin: bool) {
        let kind = if tin { SurfaceKind::Tin } else { SurfaceKind::Polyhedral };
        Ok(SqlValue::Bytes(solid.read()?.to_ewkb(kind, &Backend)?))
    }
}
