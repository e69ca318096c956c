//! Which beams count at a sample, and with what weight.
//!
//! The weight at a sample Q of a beam that tells of a place X is 2^(−ρ²/s²), with ρ the distance of X from the sight
//! line to Q and s the local spacing of the beams: exp(−κρ²) with κ = ln 2/s², as published. As ρ is measured across
//! the sight line, the kernel is stretched along a slope as the beams are.
//!
//! [`BEAMS_IN_KERNEL`] and [`MEAN_WEIGHT`] follow from its shape. Points without a beam have the same curve
//! (`collect/point_index.rs`).

use std::sync::LazyLock;

use crate::geometry::{BLUNT_EDGE_COS, Vec3};

/// Fixed-point unit of a weight.
pub const WEIGHT: f64 = 65_536.0;
/// Beyond this many spacings the kernel (1/16 there) is cut off.
pub const KERNEL_SPACINGS: f64 = 2.0;
/// Effective number of beams (Σw)²/Σw² of a full kernel: 2π/ln 2.
pub const BEAMS_IN_KERNEL: f64 = 9.064_720_283_654_387;
/// Mean weight of the beams within the kernel: (1 − 2⁻⁴)/(4 ln 2).
pub const MEAN_WEIGHT: f64 = 0.338_132_187_4;
/// A crossing may lie this far off the sample's plane, relative to its distance across the sight line: a
/// neighbouring facet of a curve, whose normal may turn by 30°.
const MAX_RISE: f64 = 0.35;
/// Off the plane by no more than this it is the same surface, however near, metres.
const MIN_RISE_M: f64 = 0.002;

/// The kernel 2^(−ρ²/s²) by ρ²/s², in fixed point; the steps are a thousandth of its height.
static KERNEL: LazyLock<[u16; KERNEL_STEPS + 1]> = LazyLock::new(|| {
    std::array::from_fn(|i| ((-(i as f64) / STEPS_PER_UNIT).exp2() * WEIGHT).round().min(65_535.0) as u16)
});
const STEPS_PER_UNIT: f64 = 1024.0;
const KERNEL_STEPS: usize = 4096;

/// Whether a beam is within the kernel, by ρ²/s². Without unit.
#[inline(always)]
pub fn is_within(across_squared: f32) -> bool {
    across_squared < (KERNEL_SPACINGS * KERNEL_SPACINGS) as f32
}

/// Weight of a beam within the kernel by ρ²/s², in fixed point. Without unit.
#[inline(always)]
pub fn weight(across_squared: f32) -> i64 {
    i64::from(KERNEL[(across_squared * STEPS_PER_UNIT as f32 + 0.5) as usize])
}

/// Whether a place `rise` metres off the sample's plane lies on the sample's own surface, not on a parallel one
/// behind it, and where their normals have this scalar product.
#[inline(always)]
pub fn goes_on(rise: f32, lateral_squared: f32, turn_cos: f32) -> bool {
    turn_cos >= BLUNT_EDGE_COS as f32
        && (rise <= MIN_RISE_M as f32 || rise * rise <= (MAX_RISE * MAX_RISE) as f32 * lateral_squared)
}

/// Whether a place at `offset` from the sample lies on the sample's own surface, not on a parallel one behind it.
/// Local metres.
pub fn same_surface(offset: &Vec3, lateral: f64, normal_there: &Vec3, normal_here: &Vec3) -> bool {
    let rise = offset.dot(normal_here).abs();
    normal_there.dot(normal_here) >= BLUNT_EDGE_COS && (rise <= MIN_RISE_M || rise <= MAX_RISE * lateral)
}
