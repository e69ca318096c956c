//! Input and output, the same for all four types.

use asbuilt_core::uncertain::{Line, Plane, Point, Pose, Stored};
use asbuilt_core::{Error, Result};

use crate::pg::{Args, SqlValue, sql_functions};

/// The value in argument `i`.
pub fn value<T: Stored<N>, const N: usize>(args: &Args, i: usize) -> T {
    T::from_stored(&args.numbers::<N>(i))
}

/// Returns a value after checking that its numbers are in range: whatever is stored can be read again.
pub fn ret<T: Stored<N> + Copy, const N: usize>(x: &T) -> Result<SqlValue> {
    // Zero has no sign: the text form does not always show it.
    Ok(SqlValue::Fixed(x.in_range()?.to_numbers().iter().flat_map(|c| (c + 0.0).to_ne_bytes()).collect()))
}

fn read<T: Stored<N> + Copy, const N: usize>(args: &Args) -> Result<SqlValue> {
    ret(&T::from_text(&args.cstring(0))?)
}

fn shown<T: Stored<N>, const N: usize>(args: &Args) -> Result<SqlValue> {
    Ok(SqlValue::CString(value::<T, N>(args, 0).to_text()))
}

fn received<T: Stored<N> + Copy, const N: usize>(args: &Args) -> Result<SqlValue> {
    let bytes = args.message(0);
    let (words, rest) = bytes.as_chunks::<8>();
    match <&[[u8; 8]; N]>::try_from(words) {
        Ok(words) if rest.is_empty() => {
            let value = T::from_numbers(&words.map(f64::from_be_bytes));
            ret(&value.map_err(|e| Error::binary(T::NAME, e.to_string()))?)
        }
        _ => Err(Error::binary(T::NAME, format!("{} bytes expected, not {}", 8 * N, bytes.len()))),
    }
}

fn sent<const N: usize>(args: &Args) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(args.numbers::<N>(0).iter().flat_map(|c| c.to_be_bytes()).collect()))
}

fn listed<const N: usize>(args: &Args) -> Result<SqlValue> {
    Ok(SqlValue::F64Array(args.numbers::<N>(0).to_vec(), vec![N as i32]))
}

/// From the coordinates alone, which are then exact, or from coordinates and covariance.
fn from_list<T: Stored<N> + Copy, const N: usize>(args: &Args) -> Result<SqlValue> {
    let list = args.f64_list(0, "the numbers of the value")?;
    let mut numbers = [0.0; N];
    if list.len() != N && list.len() != T::COORDINATES {
        let found = format!("{} numbers for {}, which has {} coordinates", list.len(), T::NAME, T::COORDINATES);
        return Err(Error::argument(
            "an array for this type",
            "its coordinates, or all numbers of its text form",
            found,
        ));
    }
    numbers[..list.len()].copy_from_slice(&list);
    ret(&T::from_numbers(&numbers)?)
}

sql_functions! {
    fn ab_point_in(args) { read::<Point, 9>(args) }
    fn ab_point_out(args) { shown::<Point, 9>(args) }
    fn ab_point_recv(args) { received::<Point, 9>(args) }
    fn ab_point_send(args) { sent::<9>(args) }
    fn ab_point_numbers(args) { listed::<9>(args) }
    fn ab_point_from_numbers(args) { from_list::<Point, 9>(args) }

    fn ab_line_in(args) { read::<Line, 27>(args) }
    fn ab_line_out(args) { shown::<Line, 27>(args) }
    fn ab_line_recv(args) { received::<Line, 27>(args) }
    fn ab_line_send(args) { sent::<27>(args) }
    fn ab_line_numbers(args) { listed::<27>(args) }
    fn ab_line_from_numbers(args) { from_list::<Line, 27>(args) }

    fn ab_plane_in(args) { read::<Plane, 16>(args) }
    fn ab_plane_out(args) { shown::<Plane, 16>(args) }
    fn ab_plane_recv(args) { received::<Plane, 16>(args) }
    fn ab_plane_send(args) { sent::<16>(args) }
    fn ab_plane_numbers(args) { listed::<16>(args) }
    fn ab_plane_from_numbers(args) { from_list::<Plane, 16>(args) }

    fn ab_pose_in(args) { read::<Pose, 36>(args) }
    fn ab_pose_out(args) { shown::<Pose, 36>(args) }
    fn ab_pose_recv(args) { received::<Pose, 36>(args) }
    fn ab_pose_send(args) { sent::<36>(args) }
    fn ab_pose_numbers(args) { listed::<36>(args) }
    fn ab_pose_from_numbers(args) { from_list::<Pose, 36>(args) }
}
