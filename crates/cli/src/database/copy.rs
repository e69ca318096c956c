//! COPY … FROM STDIN (FORMAT binary).

use anyhow::Result;
use postgres::Transaction;
use postgres::binary_copy::BinaryCopyInWriter;
use postgres::types::Type;

use super::connect::explain;

/// Starts a copy into columns, each with the type by which its values are written: the extension's own as the bytes
/// that its receive functions read ([`Type::BYTEA`]). Without `finish`, PostgreSQL discards the rows.
pub fn start<'a>(tx: &'a mut Transaction<'_>, table: &str, columns: &[(&str, Type)]) -> Result<BinaryCopyInWriter<'a>> {
    let names: Vec<&str> = columns.iter().map(|c| c.0).collect();
    let types: Vec<Type> = columns.iter().map(|c| c.1.clone()).collect();
    let sql = format!("COPY {table} ({}) FROM STDIN (FORMAT binary)", names.join(", "));
    Ok(BinaryCopyInWriter::new(tx.copy_in(&sql).map_err(explain)?, &types))
}
