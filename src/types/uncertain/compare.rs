//! Equality, order and hash of the stored numbers. Zero is zero whatever its sign, as in float8.

use std::cmp::Ordering;

use asbuilt_core::evidence::Mass;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::uncertain::{UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};

use crate::pg::{Numbers, SqlValue, sql_functions};

type PointNumbers = Numbers<UncertainPoint, 9>;
type LineNumbers = Numbers<UncertainLine, 27>;
type PlaneNumbers = Numbers<UncertainPlane, 16>;
type PoseNumbers = Numbers<UncertainPose, 36>;

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
    fn ab_point_eq(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_point_ne(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_point_lt(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_point_le(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_point_ge(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_point_gt(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_point_compare(a: PointNumbers, b: PointNumbers) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_point_hash(a: PointNumbers) { Ok(hash(&a)) }
    fn ab_point_hash_extended(a: PointNumbers, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_line_eq(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_line_ne(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_line_lt(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_line_le(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_line_ge(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_line_gt(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_line_compare(a: LineNumbers, b: LineNumbers) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_line_hash(a: LineNumbers) { Ok(hash(&a)) }
    fn ab_line_hash_extended(a: LineNumbers, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_plane_eq(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_plane_ne(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_plane_lt(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_plane_le(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_plane_ge(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_plane_gt(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_plane_compare(a: PlaneNumbers, b: PlaneNumbers) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_plane_hash(a: PlaneNumbers) { Ok(hash(&a)) }
    fn ab_plane_hash_extended(a: PlaneNumbers, seed: i64) { Ok(hash_extended(&a, seed)) }

    fn ab_pose_eq(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_eq())) }
    fn ab_pose_ne(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ne())) }
    fn ab_pose_lt(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_lt())) }
    fn ab_pose_le(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_le())) }
    fn ab_pose_ge(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_ge())) }
    fn ab_pose_gt(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::Bool(order(&a, &b).is_gt())) }
    fn ab_pose_compare(a: PoseNumbers, b: PoseNumbers) { Ok(SqlValue::I32(order(&a, &b) as i32)) }
    fn ab_pose_hash(a: PoseNumbers) { Ok(hash(&a)) }
    fn ab_pose_hash_extended(a: PoseNumbers, seed: i64) { Ok(hash_extended(&a, seed)) }

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
