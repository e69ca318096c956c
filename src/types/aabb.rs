//! `ab_box`: six float8, native byte order on disk, network order on the wire.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::{Error, Result};

use crate::pg::{Message, SqlValue, TextInput, sql_functions};

/// Bytes of an `ab_box`.
pub const BOX_LEN: usize = 48;

/// The stored form.
pub fn box_bytes(b: &Aabb) -> Vec<u8> {
    // Zero has no sign: text and binary forms say the same.
    b.min.iter().chain(&b.max).flat_map(|c| (c + 0.0).to_ne_bytes()).collect()
}

/// Reads the stored form.
pub fn box_from(bytes: &[u8; BOX_LEN]) -> Aabb {
    let at = |i: usize| f64::from_ne_bytes(std::array::from_fn(|k| bytes[8 * i + k]));
    Aabb { min: [at(0), at(1), at(2)], max: [at(3), at(4), at(5)] }
}

fn received(bytes: &[u8]) -> Result<Aabb> {
    let bad = |reason: &str| Error::binary("ab_box", reason);
    let all: &[u8; BOX_LEN] = bytes.try_into().map_err(|_| bad("48 bytes expected"))?;
    let at = |i: usize| f64::from_be_bytes(std::array::from_fn(|k| all[8 * i + k]));
    let b = Aabb { min: [at(0), at(1), at(2)], max: [at(3), at(4), at(5)] };
    match Aabb::new(b.min, b.max) {
        Ok(checked) if checked == b => Ok(b),
        _ => Err(bad("its corners are not finite or not in order")),
    }
}

sql_functions! {
    fn ab_box_in(text: TextInput) {
        Ok(SqlValue::Fixed(box_bytes(&Aabb::from_text(&text.text())?)))
    }

    fn ab_box_out(bounds: Aabb) {
        Ok(SqlValue::CString(bounds.to_text()))
    }

    fn ab_box_recv(message: Message) {
        Ok(SqlValue::Fixed(box_bytes(&received(message.rest())?)))
    }

    fn ab_box_send(bounds: Aabb) {
        Ok(SqlValue::Bytes(bounds.min.iter().chain(&bounds.max).flat_map(|c| c.to_be_bytes()).collect()))
    }

    /// Corners in any order.
    fn ab_box_make(xmin: f64, ymin: f64, zmin: f64, xmax: f64, ymax: f64, zmax: f64) {
        Ok(SqlValue::Fixed(box_bytes(&Aabb::new([xmin, ymin, zmin], [xmax, ymax, zmax])?)))
    }

    fn ab_box_min(bounds: Aabb) {
        Ok(SqlValue::vector(bounds.min))
    }

    fn ab_box_max(bounds: Aabb) {
        Ok(SqlValue::vector(bounds.max))
    }

    fn ab_box_expand(bounds: Aabb, margin: f64) {
        if !margin.is_finite() {
            return Err(Error::argument("the margin", "finite", margin));
        }
        let grown = bounds.expanded(margin);
        if (0..3).any(|i| grown.min[i] > grown.max[i]) {
            return Err(Error::argument("the margin", "no more negative than half the box's shortest side", margin));
        }
        Ok(SqlValue::Fixed(box_bytes(&Aabb::new(grown.min, grown.max)?)))
    }

    fn ab_box_volume(bounds: Aabb) {
        Ok(SqlValue::F64(bounds.volume()))
    }

    fn ab_box_equal(a: Aabb, b: Aabb) {
        Ok(SqlValue::Bool(a == b))
    }
}
