//! Equality, order and hash of the stored numbers. Zero is zero whatever its sign, as in float8.

use std::cmp::Ordering;

use asbuilt_core::evidence::Mass;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::uncertain::{Line, Plane, Point, Pose};

use crate::pg::{Numbers, SqlValue, sql_functions};

fn order<T, const N: usize>(a: &Numbers<T, N>, b: &Numbers<T, N>) -> Ordering {
    // Stored numbers are finite.
    a.numbers
        .iter()
        .zip(&b.numbers)
        .map(|(x, y)| x.partial_cmp(y).unwrap_or(Ordering::Equal))
        .find(|o| o.is_ne())
        .unwrap_or(Ordering::Equal)
}

fn hash<T, const N: usize>(a: &Numbers<T, N>) -> SqlValue {
    SqlValue::I32(checksum(&a.numbers, 0) as i32)
}

/// The same with a seed, in 64 bits; without one its low half is the plain hash.
fn hash_extended<T, const N: usize>(a: &Numbers<T, N>, seed: i64) -> SqlValue {
    let wide = u64::from(checksum(&a.numbers, 0x9e37_79b9)) << 32 | u64::from(checksum(&a.numbers, 0));
    SqlValue::I64((wide ^ (seed as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)) as i64)
}

/// Stored in hash indexes and hash partitions: it must never change.
fn checksum(numbers: &[f64], start: u32) -> u32 {
    let mut crc = crc32fast::Hasher::new_with_initial(start);
    numbers.iter().for_each(|x| crc.update(&(x + 0.0).to_le_bytes()));
    crc.finalize()
}

sql_functions! {
    fn ab_point_eq(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_point_ne(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_point_lt(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_point_le(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_point_ge(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_point_gt(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_point_compare(a: Numbers<Point, 9>, b: Numbers<Point, 9>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_point_hash(a: Numbers<Point, 9>) { Ok(hash(&a)) }
    fn ab_point_hash_extended(a: Numbers<Point, 9>, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_line_eq(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_line_ne(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_line_lt(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_line_le(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_line_ge(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_line_gt(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_line_compare(a: Numbers<Line, 27>, b: Numbers<Line, 27>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_line_hash(a: Numbers<Line, 27>) { Ok(hash(&a)) }
    fn ab_line_hash_extended(a: Numbers<Line, 27>, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_plane_eq(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_plane_ne(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_plane_lt(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_plane_le(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_plane_ge(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_plane_gt(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_plane_compare(a: Numbers<Plane, 16>, b: Numbers<Plane, 16>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_plane_hash(a: Numbers<Plane, 16>) { Ok(hash(&a)) }
    fn ab_plane_hash_extended(a: Numbers<Plane, 16>, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_pose_eq(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_pose_ne(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_pose_lt(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_pose_le(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_pose_ge(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_pose_gt(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_pose_compare(a: Numbers<Pose, 36>, b: Numbers<Pose, 36>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_pose_hash(a: Numbers<Pose, 36>) { Ok(hash(&a)) }
    fn ab_pose_hash_extended(a: Numbers<Pose, 36>, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_mass_ne(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_mass_lt(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_mass_le(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_mass_ge(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_mass_gt(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_mass_compare(a: Numbers<Mass, 3>, b: Numbers<Mass, 3>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_mass_hash(a: Numbers<Mass, 3>) { Ok(hash(&a)) }
    fn ab_mass_hash_extended(a: Numbers<Mass, 3>, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_box_ne(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_box_lt(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_box_le(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_box_ge(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_box_gt(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_box_compare(a: Numbers<Aabb, 6>, b: Numbers<Aabb, 6>) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_box_hash(a: Numbers<Aabb, 6>) { Ok(hash(&a)) }
    fn ab_box_hash_extended(a: Numbers<Aabb, 6>, seed: i64) { Ok(hash_extended(&a, seed)) }
}
