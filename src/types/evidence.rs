//! `ab_evidence`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::Result;
use asbuilt_core::verify::{Evidence, EvidenceHeader};

use super::box_bytes;
use super::evidence_model::GivenParameters;
use super::hex::{hex_in, hex_out};
use super::rollup::rolled_up;
use crate::pg::{Account, Backend, Message, SqlValue, TextInput, Varlena, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_evidence:1:";

/// Evidence.
pub type EvidenceArg<'a> = Varlena<'a, Evidence>;

impl EvidenceArg<'_> {
    /// Its header alone.
    pub fn header(&self) -> Result<EvidenceHeader> {
        Evidence::header(self.prefix(Evidence::HEADER_LEN))
    }

    /// The whole of it.
    pub fn read(&self) -> Result<Evidence> {
        Evidence::from_bytes(self.bytes(), &Backend)
    }
}

sql_functions! {
    on Account::Evidence;

    fn ab_evidence_in(text: TextInput) {
        let bytes = hex_in(&text, "ab_evidence", PREFIX)?;
        Ok(SqlValue::Bytes(Evidence::from_bytes(&bytes, &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_evidence_out(evidence: EvidenceArg) {
        hex_out(&evidence, PREFIX)
    }

    fn ab_evidence_recv(message: Message) {
        Ok(SqlValue::Bytes(Evidence::from_bytes(message.rest(), &Backend)?.to_bytes(&Backend)?))
    }

    fn ab_evidence_send(evidence: EvidenceArg) {
        Ok(evidence.copied())
    }

    /// A NULL adds nothing.
    fn ab_evidence_rollup(e1: Option<EvidenceArg>, e2: Option<EvidenceArg>) {
        rolled_up(e1, e2, |e1, e2| {
            let mut e = e1.read()?;
            e.merge(&e2.read()?, &Backend)?;
            Ok(SqlValue::Bytes(e.to_bytes(&Backend)?))
        })
    }

    fn ab_evidence_box(evidence: EvidenceArg) {
        Ok(SqlValue::Fixed(box_bytes(&evidence.header()?.bounds)))
    }

    fn ab_evidence_count(evidence: EvidenceArg) {
        Ok(SqlValue::I32(evidence.header()?.samples as i32))
    }

    fn ab_evidence_station_count(evidence: EvidenceArg) {
        Ok(SqlValue::I32(evidence.header()?.stations as i32))
    }

    /// All parameters count as given.
    fn ab_model_of_evidence(evidence: EvidenceArg) { GivenParameters::all(evidence.header()?.model).ret() }
}
