//! `ab_box`: six float8, native byte order on disk, network order on the wire.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::{Error, Result};

use crate::pg::{Args, SqlValue, sql_functions};

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

fn arg(args: &Args, i: usize) -> Aabb {
    box_from(&args.fixed(i))
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
    fn ab_box_in(args) {
        Ok(SqlValue::Fixed(box_bytes(&Aabb::from_text(&args.cstring(0))?)))
    }

    fn ab_box_out(args) {
        Ok(SqlValue::CString(arg(args, 0).to_text()))
    }

    fn ab_box_recv(args) {
        Ok(SqlValue::Fixed(box_bytes(&received(args.message(0))?)))
    }

    fn ab_box_send(args) {
        let b = arg(args, 0);
        Ok(SqlValue::Bytes(b.min.iter().chain(&b.max).flat_map(|c| c.to_be_bytes()).collect()))
    }

    /// ab_box(xmin, ymin, zmin, xmax, ymax, zmax): corners in any order.
    fn ab_box_make(args) {
        let corner = |k: usize| [0, 1, 2].map(|i| args.f64(k + i));
        Ok(SqlValue::Fixed(box_bytes(&Aabb::new(corner(0), corner(3))?)))
    }

    fn ab_box_min(args) {
        Ok(SqlValue::vector(arg(args, 0).min))
    }

    fn ab_box_max(args) {
        Ok(SqlValue::vector(arg(args, 0).max))
    }

    fn ab_box_expand(args) {
        let (b, margin) = (arg(args, 0), args.f64(1));
        if !margin.is_finite() {
            return Err(Error::argument("the margin", "finite", margin));
        }
        let grown = b.expanded(margin);
        if (0..3).any(|i| grown.min[i] > grown.max[i]) {
            return Err(Error::argument("the margin", "no more negative than half the box's shortest side", margin));
        }
        Ok(SqlValue::Fixed(box_bytes(&Aabb::new(grown.min, grown.max)?)))
    }

    fn ab_box_volume(args) {
        Ok(SqlValue::F64(arg(args, 0).volume()))
    }

    fn ab_box_equal(args) {
        Ok(SqlValue::Bool(arg(args, 0) == arg(args, 1)))
    }
}
