//! `ab_evidence`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::Result;
use asbuilt_core::verify::{Evidence, EvidenceHeader};

use super::box_bytes;
use super::evidence_model::Given;
use super::hex::{hex_in, hex_out};
use super::rollup::rolled_up;
use crate::pg::{Account, Args, Backend, SqlValue, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_evidence:1:";

/// The header of the evidence in argument 0.
pub fn header(args: &Args) -> Result<EvidenceHeader> {
    Evidence::header(args.prefix(0, Evidence::HEADER_LEN))
}

sql_functions! {
    on Account::Evidence;

    fn ab_evidence_in(args) {
        let bytes = hex_in(args, "ab_evidence", PREFIX)?;
        Ok(SqlValue::Bytes(Evidence::from_bytes(&bytes, &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_evidence_out(args) {
        hex_out(args, PREFIX)
    }

    fn ab_evidence_recv(args) {
        Ok(SqlValue::Bytes(Evidence::from_bytes(args.message(0), &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_evidence_send(args) {
        Ok(args.copied(0))
    }

    /// ab_rollup(e1, e2); a NULL adds nothing.
    fn ab_evidence_rollup(args) {
        rolled_up(args, || {
            let mut e = Evidence::from_bytes(args.bytes(0), &Backend)?;
            e.merge(&Evidence::from_bytes(args.bytes(1), &Backend)?, &Backend)?;
            Ok(SqlValue::Bytes(e.to_bytes(&Backend)?))
        })
    }

    fn ab_evidence_box(args) {
        Ok(SqlValue::Fixed(box_bytes(&header(args)?.bounds)))
    }

    fn ab_evidence_count(args) {
        Ok(SqlValue::I32(header(args)?.samples as i32))
    }

    fn ab_evidence_station_count(args) {
        Ok(SqlValue::I32(header(args)?.stations as i32))
    }

    /// ab_model(evidence): all parameters count as given.
    fn ab_model_of_evidence(args) { Given::all(header(args)?.model).ret() }
}
