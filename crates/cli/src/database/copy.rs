//! COPY … FROM STDIN (FORMAT binary).

use std::io::Write;

use anyhow::{Context, Result, bail};
use postgres::{CopyInWriter, Transaction};

use super::connect::explain;

/// Bytes gathered before they are sent.
const CHUNK: usize = 1 << 20;

/// Writes rows of PostgreSQL's binary copy format.
pub struct BinaryCopy<'a> {
    writer: CopyInWriter<'a>,
    buffer: Vec<u8>,
    columns: i16,
}

impl<'a> BinaryCopy<'a> {
    /// Starts `COPY table_and_columns FROM STDIN`.
    pub fn start(tx: &'a mut Transaction<'_>, table: &str, columns: &[&str]) -> Result<Self> {
        let sql = format!("COPY {table} ({}) FROM STDIN (FORMAT binary)", columns.join(", "));
        let writer = tx.copy_in(&sql).map_err(explain)?;
        let mut buffer = Vec::with_capacity(2 * CHUNK);
        buffer.extend_from_slice(b"PGCOPY\n\xff\r\n\0");
        buffer.extend_from_slice(&[0; 8]);
        Ok(Self { writer, buffer, columns: columns.len() as i16 })
    }

    /// Adds a row; `None` is NULL.
    pub fn row(&mut self, fields: &[Option<&[u8]>]) -> Result<()> {
        debug_assert_eq!(fields.len(), self.columns as usize);
        self.buffer.extend_from_slice(&self.columns.to_be_bytes());
        for field in fields {
            match field {
                None => self.buffer.extend_from_slice(&(-1i32).to_be_bytes()),
                Some(bytes) => {
                    let Ok(len) = i32::try_from(bytes.len()) else {
                        bail!("a value of {} bytes is larger than PostgreSQL's 1 GB", bytes.len());
                    };
                    self.buffer.extend_from_slice(&len.to_be_bytes());
                    self.buffer.extend_from_slice(bytes);
                }
            }
        }
        if self.buffer.len() >= CHUNK { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> Result<()> {
        self.writer.write_all(&self.buffer).context("the server stopped reading")?;
        self.buffer.clear();
        Ok(())
    }

    /// Ends the copy; without it PostgreSQL discards the rows. Returns their number.
    pub fn finish(mut self) -> Result<u64> {
        self.buffer.extend_from_slice(&(-1i16).to_be_bytes());
        self.flush()?;
        self.writer.finish().map_err(explain)
    }
}

/// `jsonb` on the wire: a version byte, then the text.
pub fn jsonb(value: &serde_json::Value) -> Vec<u8> {
    let mut out = vec![1];
    out.extend_from_slice(value.to_string().as_bytes());
    out
}
