//! PostgreSQL arrays of plain numbers.

use asbuilt_core::{Budget, Error, Result};
use pgrx::pg_sys;

use super::memory::Backend;

/// `3` or `4×2`, for messages.
pub fn shape(dims: &[i32]) -> String {
    let words: Vec<String> = dims.iter().map(i32::to_string).collect();
    if words.is_empty() { "an empty array".into() } else { format!("an array of {} elements", words.join(" x ")) }
}

/// Dimensions of an array.
///
/// # Safety
/// `datum` must be an array.
pub unsafe fn dims(datum: pg_sys::Datum) -> Vec<i32> {
    unsafe { dims_of(pg_sys::pg_detoast_datum(datum.cast_mut_ptr()).cast()) }
}

unsafe fn dims_of(array: *const pg_sys::ArrayType) -> Vec<i32> {
    unsafe { std::slice::from_raw_parts(array.add(1).cast::<i32>(), (*array).ndim as usize).to_vec() }
}

/// Dimensions and elements of an array of fixed-length plain numbers, in storage order.
///
/// # Safety
/// `datum` must be an array whose element type is stored as `T`.
pub unsafe fn read<T: Copy>(datum: pg_sys::Datum, what: &'static str) -> Result<(Vec<i32>, Vec<T>)> {
    unsafe {
        let array = pg_sys::pg_detoast_datum(datum.cast_mut_ptr()).cast::<pg_sys::ArrayType>();
        let dims = dims_of(array);
        let ndim = dims.len();
        let count = if ndim == 0 { 0 } else { dims.iter().map(|&d| d as usize).product() };
        if (*array).dataoffset != 0 && pg_sys::array_contains_nulls(array) {
            return Err(Error::argument(what, "without NULL elements", "an array with NULL"));
        }
        let header = size_of::<pg_sys::ArrayType>() + 2 * ndim * size_of::<i32>();
        let offset = match (*array).dataoffset {
            0 => header.next_multiple_of(8),
            o => o as usize,
        };
        Backend.room(count * size_of::<T>())?;
        let data = array.cast::<u8>().add(offset).cast::<T>();
        Ok((dims, (0..count).map(|i| data.add(i).read_unaligned()).collect()))
    }
}

/// The elements of an array of a variable-length type aligned to four bytes, fetched; `None` for NULL.
///
/// # Safety
/// `datum` must be such an array, and live as long as the slices.
pub unsafe fn read_varlenas<'a>(datum: pg_sys::Datum, what: &'static str) -> Result<Vec<Option<&'a [u8]>>> {
    unsafe {
        let array = pg_sys::pg_detoast_datum(datum.cast_mut_ptr()).cast::<pg_sys::ArrayType>();
        if (*array).ndim > 1 {
            return Err(Error::argument(what, "an array of one dimension", format!("one of {}", (*array).ndim)));
        }
        let (mut elements, mut nulls, mut count) = (std::ptr::null_mut(), std::ptr::null_mut(), 0);
        let align = b'i' as std::ffi::c_char;
        pg_sys::deconstruct_array(array, (*array).elemtype, -1, false, align, &mut elements, &mut nulls, &mut count);
        let is_present = |k: &usize| !*nulls.add(*k);
        let value = |k: usize| super::toast::fetch((*elements.add(k)).cast_mut_ptr());
        let bytes = |k: usize| pgrx::varlena::varlena_to_byte_slice(value(k));
        Ok((0..count as usize).map(|k| Some(k).filter(is_present).map(bytes)).collect())
    }
}

/// Rows of three; an array without elements has none.
pub fn triples<T: Copy>(dims: &[i32], values: &[T], what: &'static str) -> Result<Vec<[T; 3]>> {
    match dims {
        [] | [_, 3] => {
            Backend.room(size_of_val(values))?;
            Ok(values.as_chunks().0.to_vec())
        }
        _ => Err(Error::argument(what, "an array of n x 3 numbers", shape(dims))),
    }
}

/// A new array; `dims` multiply to the number of elements, and so do `nulls`, where some are NULL.
///
/// # Safety
/// `element` must be the type of elements of length `len` passed by value in `datums`.
pub unsafe fn write(
    datums: &mut [pg_sys::Datum],
    nulls: Option<&mut [bool]>,
    dims: &[i32],
    element: pg_sys::Oid,
    len: i32,
    align: u8,
) -> pg_sys::Datum {
    let mut dims = dims.to_vec();
    let mut lower = vec![1; dims.len()];
    let nulls = nulls.map_or(std::ptr::null_mut(), |n| n.as_mut_ptr());
    unsafe {
        pg_sys::construct_md_array(
            datums.as_mut_ptr(),
            nulls,
            dims.len() as i32,
            dims.as_mut_ptr(),
            lower.as_mut_ptr(),
            element,
            len,
            true,
            align as std::ffi::c_char,
        )
        .into()
    }
}

/// An array of the variable-length type that the call returns an array of; NULL when empty.
///
/// # Safety
/// `fcinfo` must be the pointer PostgreSQL called the function with; the element type must be aligned to four bytes.
pub unsafe fn of_varlenas(fcinfo: pg_sys::FunctionCallInfo, elements: &[Vec<u8>]) -> pg_sys::Datum {
    if elements.is_empty() {
        unsafe { (*fcinfo).isnull = true };
        return pg_sys::Datum::from(0usize);
    }
    let mut datums: Vec<_> = elements.iter().map(|e| super::sql_value::varlena(e)).collect();
    unsafe {
        let element = pg_sys::get_element_type(pg_sys::get_fn_expr_rettype((*fcinfo).flinfo));
        assert!(element != pg_sys::InvalidOid, "the function returns no array");
        let align = b'i' as std::ffi::c_char;
        pg_sys::construct_array(datums.as_mut_ptr(), datums.len() as i32, element, -1, false, align).into()
    }
}

/// A `float8[]`.
pub fn of_f64(values: &[f64], dims: &[i32]) -> pg_sys::Datum {
    let mut datums: Vec<_> = values.iter().map(|v| pg_sys::Datum::from(v.to_bits() as usize)).collect();
    unsafe { write(&mut datums, None, dims, pg_sys::FLOAT8OID, 8, b'd') }
}

/// An `int4[]`.
pub fn of_i32(values: &[i32], dims: &[i32]) -> pg_sys::Datum {
    let mut datums: Vec<_> = values.iter().map(|&v| pg_sys::Datum::from(v)).collect();
    unsafe { write(&mut datums, None, dims, pg_sys::INT4OID, 4, b'i') }
}

/// A `float8[]` of three elements, NULL for `None`.
pub fn of_axes(values: &[Option<f64>; 3]) -> pg_sys::Datum {
    let mut datums = values.map(|v| pg_sys::Datum::from(v.unwrap_or_default().to_bits() as usize));
    let mut nulls = values.map(|v| v.is_none());
    unsafe { write(&mut datums, Some(&mut nulls), &[3], pg_sys::FLOAT8OID, 8, b'd') }
}
