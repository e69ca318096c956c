//! Running a query that the caller wrote, batch by batch, and reading its columns.

use std::ffi::CString;

use asbuilt_core::{Budget, Error, Result};
use pgrx::pg_sys;

use super::context::within;
use super::interrupt::serve;
use super::memory::Backend;
use super::{Args, own_type_name, toast};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultColumn {
    /// `bigint` or a smaller integer.
    Integer,
    /// One of our variable-length types, by name.
    Varlena(&'static str),
}

/// A value of a row; owned, so that it can be passed to other threads.
#[derive(Debug, Clone)]
pub enum ResultCell {
    /// NULL, or no such column.
    Null,
    /// An integer.
    Integer(i64),
    /// Content of a variable-length value.
    Bytes(Vec<u8>),
}

impl ResultCell {
    /// The content, unless NULL.
    pub fn bytes(&self) -> Option<&[u8]> {
        if let Self::Bytes(b) = self { Some(b) } else { None }
    }
}

/// A query as the caller wrote it, and what it is called in messages.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// `the query of objects`.
    pub what: &'static str,
    /// SQL.
    pub text: &'a str,
    /// Its columns; the last `optional` of them may be missing.
    pub columns: &'a [ResultColumn],
    /// How many.
    pub optional: usize,
    /// The columns in words, for the message when the query returns others.
    pub expected: &'static str,
}

/// Calls `visit` with batches of at most `batch` rows of a query, run read-only on the statement's own snapshot. `args`
/// is the function's call: it tells our own types from others of the same name.
pub fn for_each_batch(
    args: &Args,
    query: Query,
    batch: i64,
    mut visit: impl FnMut(Vec<Vec<ResultCell>>) -> Result<()>,
) -> Result<()> {
    let text = CString::new(query.text).map_err(|_| Error::argument(query.what, "without a zero byte", "one with"))?;
    within(query.what, || unsafe {
        connect();
        let plan = pg_sys::SPI_prepare(text.as_ptr(), 0, std::ptr::null_mut());
        if plan.is_null() || !pg_sys::SPI_is_cursor_plan(plan) {
            pg_sys::SPI_finish();
            return Err(Error::argument(query.what, "one SELECT", format!("\"{}\"", query.text)));
        }
        let (values, nulls) = (std::ptr::null_mut(), std::ptr::null());
        let portal = pg_sys::SPI_cursor_open(std::ptr::null(), plan, values, nulls, true);
        let outcome = fetch_all(args, &query, portal, batch, &mut visit);
        pg_sys::SPI_cursor_close(portal);
        pg_sys::SPI_finish();
        outcome
    })
}

unsafe fn connect() {
    let outcome = unsafe { pg_sys::SPI_connect() };
    assert!(outcome == pg_sys::SPI_OK_CONNECT as i32, "SPI_connect: {outcome}");
}

unsafe fn fetch_all(
    args: &Args,
    query: &Query,
    portal: pg_sys::Portal,
    batch: i64,
    visit: &mut impl FnMut(Vec<Vec<ResultCell>>) -> Result<()>,
) -> Result<()> {
    unsafe {
        let readers = readers(args, query, (*portal).tupDesc)?;
        loop {
            serve();
            pg_sys::SPI_cursor_fetch(portal, true, batch);
            let (table, count) = (pg_sys::SPI_tuptable, pg_sys::SPI_processed as usize);
            if count == 0 {
                pg_sys::SPI_freetuptable(table);
                return Ok(());
            }
            let rows: Result<Vec<_>> =
                (0..count).map(|i| row(*(*table).vals.add(i), (*table).tupdesc, &readers)).collect();
            pg_sys::SPI_freetuptable(table);
            visit(rows?)?;
        }
    }
}

#[derive(Clone, Copy)]
enum ColumnReader {
    Int16,
    Int32,
    Int64,
    Varlena,
}

/// How to read each column that is there.
unsafe fn readers(args: &Args, query: &Query, desc: pg_sys::TupleDesc) -> Result<Vec<ColumnReader>> {
    let (least, most) = (query.columns.len() - query.optional, query.columns.len());
    let found = if desc.is_null() { 0 } else { unsafe { (*desc).natts as usize } };
    let wrong = |found: String| Error::argument(query.what, query.expected, found);
    if !(least..=most).contains(&found) {
        return Err(wrong(format!("{found} columns")));
    }
    let reader = |i: usize| {
        let oid = unsafe { (*(*desc).attrs.as_ptr().add(i)).atttypid };
        let own = own_type_name(args, oid);
        match query.columns[i] {
            ResultColumn::Integer if oid == pg_sys::INT2OID => Ok(ColumnReader::Int16),
            ResultColumn::Integer if oid == pg_sys::INT4OID => Ok(ColumnReader::Int32),
            ResultColumn::Integer if oid == pg_sys::INT8OID => Ok(ColumnReader::Int64),
            ResultColumn::Varlena(name) if own.as_deref() == Some(name) => Ok(ColumnReader::Varlena),
            _ => {
                let name = unsafe { std::ffi::CStr::from_ptr(pg_sys::format_type_be(oid)) };
                Err(wrong(format!("{} in column {}", name.to_string_lossy(), i + 1)))
            }
        }
    };
    (0..found).map(reader).collect()
}

unsafe fn row(tuple: pg_sys::HeapTuple, desc: pg_sys::TupleDesc, readers: &[ColumnReader]) -> Result<Vec<ResultCell>> {
    let cell = |(i, reader): (usize, &ColumnReader)| unsafe {
        let mut is_null = false;
        let datum = pg_sys::SPI_getbinval(tuple, desc, i as i32 + 1, &mut is_null);
        if is_null {
            return Ok(ResultCell::Null);
        }
        Ok(match *reader {
            ColumnReader::Int16 => ResultCell::Integer(i64::from(datum.value() as i16)),
            ColumnReader::Int32 => ResultCell::Integer(i64::from(datum.value() as i32)),
            ColumnReader::Int64 => ResultCell::Integer(datum.value() as i64),
            ColumnReader::Varlena => {
                let stored: *mut pg_sys::varlena = datum.cast_mut_ptr();
                let fetched = toast::fetch(stored);
                let bytes = pgrx::varlena::varlena_to_byte_slice(fetched);
                Backend.room(bytes.len())?;
                let bytes = bytes.to_vec();
                if fetched != stored {
                    pg_sys::pfree(fetched.cast());
                }
                ResultCell::Bytes(bytes)
            }
        })
    };
    readers.iter().enumerate().map(cell).collect()
}
