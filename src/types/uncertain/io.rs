//! Input and output, the same for all four types.

use asbuilt_core::uncertain::{Stored, UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};
use asbuilt_core::{Error, Result};

use crate::pg::{F64Array, Message, Numbers, SqlValue, TextInput, sql_functions};

/// Returns a value after checking that its numbers are in range: whatever is stored can be read again.
pub fn ret<T: Stored<N> + Copy, const N: usize>(x: &T) -> Result<SqlValue> {
    // Zero has no sign: the text form does not always show it.
    Ok(SqlValue::Fixed(x.in_range()?.to_numbers().iter().flat_map(|c| (c + 0.0).to_ne_bytes()).collect()))
}

fn read<T: Stored<N> + Copy, const N: usize>(text: &TextInput) -> Result<SqlValue> {
    ret(&T::from_text(&text.text())?)
}

fn shown<T: Stored<N>, const N: usize>(value: &T) -> Result<SqlValue> {
    Ok(SqlValue::CString(value.to_text()))
}

fn received<T: Stored<N> + Copy, const N: usize>(message: &Message) -> Result<SqlValue> {
    let bytes = message.rest();
    let (words, rest) = bytes.as_chunks::<8>();
    match <&[[u8; 8]; N]>::try_from(words) {
        Ok(words) if rest.is_empty() => {
            let value = T::from_numbers(&words.map(f64::from_be_bytes));
            ret(&value.map_err(|e| Error::binary(T::NAME, e.to_string()))?)
        }
        _ => Err(Error::binary(T::NAME, format!("{} bytes expected, not {}", 8 * N, bytes.len()))),
    }
}

fn sent<T, const N: usize>(value: &Numbers<T, N>) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(value.numbers.iter().flat_map(|c| c.to_be_bytes()).collect()))
}

fn listed<T, const N: usize>(value: &Numbers<T, N>) -> Result<SqlValue> {
    Ok(SqlValue::F64Array(value.numbers.to_vec(), vec![N as i32]))
}

/// From the coordinates alone, which are then exact, or from coordinates and covariance.
fn from_list<T: Stored<N> + Copy, const N: usize>(array: &F64Array) -> Result<SqlValue> {
    let list = array.list("the numbers of the value")?;
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
    fn ab_point_in(text: TextInput) { read::<UncertainPoint, 9>(&text) }
    fn ab_point_out(point: UncertainPoint) { shown(&point) }
    fn ab_point_recv(message: Message) { received::<UncertainPoint, 9>(&message) }
    fn ab_point_send(point: Numbers<UncertainPoint, 9>) { sent(&point) }
    fn ab_point_numbers(point: Numbers<UncertainPoint, 9>) { listed(&point) }
    fn ab_point_from_numbers(numbers: F64Array) { from_list::<UncertainPoint, 9>(&numbers) }

    fn ab_line_in(text: TextInput) { read::<UncertainLine, 27>(&text) }
    fn ab_line_out(line: UncertainLine) { shown(&line) }
    fn ab_line_recv(message: Message) { received::<UncertainLine, 27>(&message) }
    fn ab_line_send(line: Numbers<UncertainLine, 27>) { sent(&line) }
    fn ab_line_numbers(line: Numbers<UncertainLine, 27>) { listed(&line) }
    fn ab_line_from_numbers(numbers: F64Array) { from_list::<UncertainLine, 27>(&numbers) }

    fn ab_plane_in(text: TextInput) { read::<UncertainPlane, 16>(&text) }
    fn ab_plane_out(plane: UncertainPlane) { shown(&plane) }
    fn ab_plane_recv(message: Message) { received::<UncertainPlane, 16>(&message) }
    fn ab_plane_send(plane: Numbers<UncertainPlane, 16>) { sent(&plane) }
    fn ab_plane_numbers(plane: Numbers<UncertainPlane, 16>) { listed(&plane) }
    fn ab_plane_from_numbers(numbers: F64Array) { from_list::<UncertainPlane, 16>(&numbers) }

    fn ab_pose_in(text: TextInput) { read::<UncertainPose, 36>(&text) }
    fn ab_pose_out(pose: UncertainPose) { shown(&pose) }
    fn ab_pose_recv(message: Message) { received::<UncertainPose, 36>(&message) }
    fn ab_pose_send(pose: Numbers<UncertainPose, 36>) { sent(&pose) }
    fn ab_pose_numbers(pose: Numbers<UncertainPose, 36>) { listed(&pose) }
    fn ab_pose_from_numbers(numbers: F64Array) { from_list::<UncertainPose, 36>(&numbers) }
}
