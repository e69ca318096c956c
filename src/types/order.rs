//! Equality, order and hash by the bytes of the current layout, for types that have no other, so that a column of them
//! has a replica identity, and DISTINCT and GROUP BY work.

use std::borrow::Cow;
use std::cmp::Ordering;

use asbuilt_core::geometry::Solid;
use asbuilt_core::scan::{Patch, PatchHeader};
use asbuilt_core::verify::Evidence;
use asbuilt_core::voxel::{Occupancy, VoxelChange};
use asbuilt_core::{Budget, Error, Result};

use crate::pg::{Backend, Compared, SqlValue, Varlena, sql_functions};

/// A value of any of these types.
type Any<'a> = Varlena<'a, Compared>;

/// Bytes compared or hashed between two looks at the interrupt.
const PIECE: usize = 1 << 24;

/// The bytes of a variable-length value in the current layout; its letter and version tell which it has.
fn current(bytes: &[u8]) -> Result<Cow<'_, [u8]>> {
    let (version, letter) = match bytes {
        [version, letter, ..] => (*version, *letter),
        _ => return Err(Error::corrupted("a value", "it is cut short")),
    };
    Ok(match letter {
        b'P' if version < PatchHeader::VERSION => Patch::from_bytes(bytes)?.to_bytes().into(),
        b'S' if version < Solid::VERSION => Solid::from_bytes(bytes, &Backend)?.to_bytes(&Backend)?.into(),
        b'E' if version < Evidence::VERSION => Evidence::from_bytes(bytes, &Backend)?.to_bytes(&Backend)?.into(),
        b'O' if version < Occupancy::VERSION => Occupancy::from_bytes(bytes, &Backend)?.to_bytes(&Backend)?.into(),
        b'C' if version < VoxelChange::VERSION => VoxelChange::from_bytes(bytes, &Backend)?.to_bytes(&Backend)?.into(),
        _ => bytes.into(),
    })
}

fn order(a: &Any, b: &Any) -> Result<Ordering> {
    let (a, b) = (current(a.bytes())?, current(b.bytes())?);
    for (a, b) in a.chunks(PIECE).zip(b.chunks(PIECE)) {
        Backend.poll()?;
        let order = a[..a.len().min(b.len())].cmp(&b[..a.len().min(b.len())]);
        if order.is_ne() {
            return Ok(order);
        }
    }
    Ok(a.len().cmp(&b.len()))
}

/// Hash indexes store these: after a change of layout they must be rebuilt.
fn hash(bytes: &[u8], start: u32) -> Result<u32> {
    let mut crc = crc32fast::Hasher::new_with_initial(start);
    for piece in bytes.chunks(PIECE) {
        Backend.poll()?;
        crc.update(piece);
    }
    Ok(crc.finalize())
}

fn plain(bytes: &[u8]) -> Result<SqlValue> {
    Ok(SqlValue::I32(hash(bytes, 0)? as i32))
}

/// With a seed, in 64 bits; without one the low half is the plain hash.
fn extended(bytes: &[u8], seed: i64) -> Result<SqlValue> {
    let wide = u64::from(hash(bytes, 0x9e37_79b9)?) << 32 | u64::from(hash(bytes, 0)?);
    Ok(SqlValue::I64((wide ^ (seed as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15)) as i64))
}

sql_functions! {
    fn ab_bytes_eq(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_eq())) }
    fn ab_bytes_ne(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_ne())) }
    fn ab_bytes_lt(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_lt())) }
    fn ab_bytes_le(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_le())) }
    fn ab_bytes_ge(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_ge())) }
    fn ab_bytes_gt(a: Any, b: Any) { Ok(SqlValue::Bool(order(&a, &b)?.is_gt())) }
    fn ab_bytes_compare(a: Any, b: Any) { Ok(SqlValue::I32(order(&a, &b)? as i32)) }
    fn ab_bytes_hash(a: Any) { plain(&current(a.bytes())?) }
    fn ab_bytes_hash_extended(a: Any, seed: i64) { extended(&current(a.bytes())?, seed) }
}
