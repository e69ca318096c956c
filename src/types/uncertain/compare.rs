//! Equality, order and hash of the stored numbers. Zero is zero whatever its sign, as in float8.

use std::cmp::Ordering;

use crate::pg::{Args, SqlValue, sql_functions};

fn order<const N: usize>(args: &Args) -> Ordering {
    let (a, b) = (args.numbers::<N>(0), args.numbers::<N>(1));
    // Stored numbers are finite.
    a.iter()
        .zip(&b)
        .map(|(x, y)| x.partial_cmp(y).unwrap_or(Ordering::Equal))
        .find(|o| o.is_ne())
        .unwrap_or(Ordering::Equal)
}

fn hash<const N: usize>(args: &Args) -> SqlValue {
    SqlValue::I32(checksum::<N>(args, 0) as i32)
}

/// The same with a seed, in 64 bits; without one its low half is the plain hash.
fn hash_extended<const N: usize>(args: &Args) -> SqlValue {
    let wide = u64::from(checksum::<N>(args, 0x9e37_79b9)) << 32 | u64::from(checksum::<N>(args, 0));
    SqlValue::I64((wide ^ (args.i64(1) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)) as i64)
}

/// Stored in hash indexes and hash partitions: it must never change.
fn checksum<const N: usize>(args: &Args, start: u32) -> u32 {
    let mut crc = crc32fast::Hasher::new_with_initial(start);
    args.numbers::<N>(0).iter().for_each(|x| crc.update(&(x + 0.0).to_le_bytes()));
    crc.finalize()
}

sql_functions! {
    fn ab_point_eq(args) { Ok(SqlValue::Bool(order::<9>(args).is_eq())) }
    fn ab_point_ne(args) { Ok(SqlValue::Bool(order::<9>(args).is_ne())) }
    fn ab_point_lt(args) { Ok(SqlValue::Bool(order::<9>(args).is_lt())) }
    fn ab_point_le(args) { Ok(SqlValue::Bool(order::<9>(args).is_le())) }
    fn ab_point_ge(args) { Ok(SqlValue::Bool(order::<9>(args).is_ge())) }
    fn ab_point_gt(args) { Ok(SqlValue::Bool(order::<9>(args).is_gt())) }
    fn ab_point_compare(args) { Ok(SqlValue::I32(order::<9>(args) as i32)) }
    fn ab_point_hash(args) { Ok(hash::<9>(args)) }
    fn ab_point_hash_extended(args) { Ok(hash_extended::<9>(args)) }

    fn ab_line_eq(args) { Ok(SqlValue::Bool(order::<27>(args).is_eq())) }
    fn ab_line_ne(args) { Ok(SqlValue::Bool(order::<27>(args).is_ne())) }
    fn ab_line_lt(args) { Ok(SqlValue::Bool(order::<27>(args).is_lt())) }
    fn ab_line_le(args) { Ok(SqlValue::Bool(order::<27>(args).is_le())) }
    fn ab_line_ge(args) { Ok(SqlValue::Bool(order::<27>(args).is_ge())) }
    fn ab_line_gt(args) { Ok(SqlValue::Bool(order::<27>(args).is_gt())) }
    fn ab_line_compare(args) { Ok(SqlValue::I32(order::<27>(args) as i32)) }
    fn ab_line_hash(args) { Ok(hash::<27>(args)) }
    fn ab_line_hash_extended(args) { Ok(hash_extended::<27>(args)) }

    fn ab_plane_eq(args) { Ok(SqlValue::Bool(order::<16>(args).is_eq())) }
    fn ab_plane_ne(args) { Ok(SqlValue::Bool(order::<16>(args).is_ne())) }
    fn ab_plane_lt(args) { Ok(SqlValue::Bool(order::<16>(args).is_lt())) }
    fn ab_plane_le(args) { Ok(SqlValue::Bool(order::<16>(args).is_le())) }
    fn ab_plane_ge(args) { Ok(SqlValue::Bool(order::<16>(args).is_ge())) }
    fn ab_plane_gt(args) { Ok(SqlValue::Bool(order::<16>(args).is_gt())) }
    fn ab_plane_compare(args) { Ok(SqlValue::I32(order::<16>(args) as i32)) }
    fn ab_plane_hash(args) { Ok(hash::<16>(args)) }
    fn ab_plane_hash_extended(args) { Ok(hash_extended::<16>(args)) }

    fn ab_pose_eq(args) { Ok(SqlValue::Bool(order::<36>(args).is_eq())) }
    fn ab_pose_ne(args) { Ok(SqlValue::Bool(order::<36>(args).is_ne())) }
    fn ab_pose_lt(args) { Ok(SqlValue::Bool(order::<36>(args).is_lt())) }
    fn ab_pose_le(args) { Ok(SqlValue::Bool(order::<36>(args).is_le())) }
    fn ab_pose_ge(args) { Ok(SqlValue::Bool(order::<36>(args).is_ge())) }
    fn ab_pose_gt(args) { Ok(SqlValue::Bool(order::<36>(args).is_gt())) }
    fn ab_pose_compare(args) { Ok(SqlValue::I32(order::<36>(args) as i32)) }
    fn ab_pose_hash(args) { Ok(hash::<36>(args)) }
    fn ab_pose_hash_extended(args) { Ok(hash_extended::<36>(args)) }

    fn ab_mass_ne(args) { Ok(SqlValue::Bool(order::<3>(args).is_ne())) }
    fn ab_mass_lt(args) { Ok(SqlValue::Bool(order::<3>(args).is_lt())) }
    fn ab_mass_le(args) { Ok(SqlValue::Bool(order::<3>(args).is_le())) }
    fn ab_mass_ge(args) { Ok(SqlValue::Bool(order::<3>(args).is_ge())) }
    fn ab_mass_gt(args) { Ok(SqlValue::Bool(order::<3>(args).is_gt())) }
    fn ab_mass_compare(args) { Ok(SqlValue::I32(order::<3>(args) as i32)) }
    fn ab_mass_hash(args) { Ok(hash::<3>(args)) }
    fn ab_mass_hash_extended(args) { Ok(hash_extended::<3>(args)) }

    fn ab_box_ne(args) { Ok(SqlValue::Bool(order::<6>(args).is_ne())) }
    fn ab_box_lt(args) { Ok(SqlValue::Bool(order::<6>(args).is_lt())) }
    fn ab_box_le(args) { Ok(SqlValue::Bool(order::<6>(args).is_le())) }
    fn ab_box_ge(args) { Ok(SqlValue::Bool(order::<6>(args).is_ge())) }
    fn ab_box_gt(args) { Ok(SqlValue::Bool(order::<6>(args).is_gt())) }
    fn ab_box_compare(args) { Ok(SqlValue::I32(order::<6>(args) as i32)) }
    fn ab_box_hash(args) { Ok(hash::<6>(args)) }
    fn ab_box_hash_extended(args) { Ok(hash_extended::<6>(args)) }
}
