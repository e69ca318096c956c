//! Input and output, the same for all four types.

use asbuilt_core::uncertain::{Line, Plane, Point, Pose, Stored};
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
    fn ab_point_in(text: TextInput) { read::<Point, 9>(&text) }
    fn ab_point_out(point: Point) { shown(&point) }
    fn ab_point_recv(message: Message) { received::<Point, 9>(&message) }
    fn ab_point_send(point: Numbers<Point, 9>) { sent(&point) }
    fn ab_point_numbers(point: Numbers<Point, 9>) { listed(&point) }
    fn ab_point_from_numbers(numbers: F64Array) { from_list::<Point, 9>(&numbers) }

    fn ab_line_in(text: TextInput) { read::<Line, 27>(&text) }
    fn ab_line_out(line: Line) { shown(&line) }
    fn ab_line_recv(message: Message) { received::<Line, 27>(&message) }
    fn ab_line_send(line: Numbers<Line, 27>) { sent(&line) }
    fn ab_line_numbers(line: Numbers<Line, 27>) { listed(&line) }
    fn ab_line_from_numbers(numbers: F64Array) { from_list::<Line, 27>(&numbers) }

    fn ab_plane_in(text: TextInput) { read::<Plane, 16>(&text) }
    fn ab_plane_out(plane: Plane) { shown(&plane) }
    fn ab_plane_recv(message: Message) { received::<Plane, 16>(&message) }
    fn ab_plane_send(plane: Numbers<Plane, 16>) { sent(&plane) }
    fn ab_plane_numbers(plane: Numbers<Plane, 16>) { listed(&plane) }
    fn ab_plane_from_numbers(numbers: F64Array) { from_list::<Plane, 16>(&numbers) }

    fn ab_pose_in(text: TextInput) { read::<Pose, 36>(&text) }
    fn ab_pose_out(pose: Pose) { shown(&pose) }
    fn ab_pose_recv(message: Message) { received::<Pose, 36>(&message) }
    fn ab_pose_send(pose: Numbers<Pose, 36>) { sent(&pose) }
    fn ab_pose_numbers(pose: Numbers<Pose, 36>) { listed(&pose) }
    fn ab_pose_from_numbers(numbers: F64Array) { from_list::<Pose, 36>(&numbers) }
}
