//! What the SQL of 0.1.0 calls and today's does not: its functions live on as `_ab_…_010` (sql/install/99-compat.sql),
//! for views that were made with them, and its own SQL runs until it is updated.

use asbuilt_core::Result;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::num::bytes::ByteReader;
use asbuilt_core::uncertain::UncertainPoint;
use asbuilt_core::verify::{EvidenceModel, Shift, Summary};

use crate::aggregates::evidence::{Gathering, absorb_patch, absorb_tie_point};
use crate::pg::{
    Account, Backend, Declared, F64Array, FixedModel, Message, RowField, SqlValue, TextInput, sql_functions,
};
use crate::types::overlap::of_scan;
use crate::types::{EvidenceArg, GivenParameters, ScanArg, SolidArg, beams, summary, summary_fields};

/// The fixed-length form of the parameters: `ab_evidence_model_010`, once `ab_evidence_model`.
fn fixed(m: &EvidenceModel) -> Result<SqlValue> {
    let mut bytes = Vec::with_capacity(EvidenceModel::LEN);
    m.write(&mut bytes);
    Ok(SqlValue::Fixed(bytes))
}

fn parse(bytes: &[u8]) -> Result<EvidenceModel> {
    let mut r = ByteReader::new(bytes, "ab_evidence_model_010");
    let model = EvidenceModel::read(&mut r)?;
    r.finish()?;
    Ok(model)
}

/// The model of an argument; the default when it is NULL.
fn or_default(model: Option<FixedModel>) -> Result<EvidenceModel> {
    model.map_or_else(|| Ok(EvidenceModel::default()), |m| parse(&m.0))
}

/// The columns of `ab_summary`, the last of them a text: `(+0.0121, -, +0.0003) +/- (0.0004, -, 0.0005)`.
fn summary_row(s: &Summary) -> Vec<RowField> {
    let mut fields = summary_fields(s);
    fields.push(RowField::or_null(s.shift.as_ref(), |t| RowField::Text(t.to_text())));
    fields
}

/// The offset along each axis, then their standard deviations.
fn shift(t: &Shift) -> Vec<RowField> {
    let axis = |i: usize, x: f64| if t.determines(i) { RowField::F64(x) } else { RowField::Null };
    (0..3).map(|i| axis(i, t.vector[i])).chain((0..3).map(|i| axis(i, t.sd(i)))).collect()
}

/// What takes memory for evidence.
mod evidence {
    use super::*;

    sql_functions! {
        on Account::Evidence;

        fn ab_evidence_accum(
            state: Gathering, solid: Option<SolidArg>, patch: Option<ScanArg>, model: Option<FixedModel>,
        ) {
            absorb_patch(state, solid, patch, || or_default(model))
        }

        fn ab_evidence_accum_point(
            state: Gathering, solid: Option<SolidArg>, point: Option<UncertainPoint>, cameras: Option<F64Array>,
            model: Option<FixedModel>,
        ) {
            absorb_tie_point(state, solid, point, cameras, || or_default(model))
        }

        fn ab_summary(
            evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>,
            min_confirmed: Option<f64>, min_coverage: Option<f64>, max_conflict: Option<f64>,
        ) {
            let thresholds = [min_confirmed, min_coverage, max_conflict];
            Ok(SqlValue::Row(summary_row(&summary(&evidence, loa, confidence, thresholds)?)))
        }

        fn ab_shift(evidence: Option<EvidenceArg>) {
            let Some(evidence) = evidence else { return Ok(SqlValue::Null) };
            let offset = evidence.read()?.rigid_shift(&Backend)?;
            Ok(offset.map_or(SqlValue::Null, |t| SqlValue::Row(shift(&t))))
        }
    }
}

sql_functions! {
    fn ab_evidence_model_in(text: TextInput) { fixed(&EvidenceModel::from_text(&text.text())?) }

    fn ab_evidence_model_out(model: FixedModel) { Ok(SqlValue::CString(parse(&model.0)?.to_text())) }

    fn ab_evidence_model_recv(message: Message) { fixed(&parse(message.rest())?) }

    fn ab_evidence_model_send(model: FixedModel) { Ok(SqlValue::Bytes(model.0.to_vec())) }

    fn ab_evidence_model_make(
        loa: Option<Loa>, model: Option<String>, spacing: Option<f64>, sigma_range: Option<f64>,
        sigma_angle: Option<f64>, sigma_station: Option<f64>, sigma_model: Option<f64>, confidence: Option<f64>,
        reliability: Option<f64>, max_incidence: Option<f64>, no_return_range: Option<f64>,
        no_return_weight: Option<f64>, kappa: Option<f64>, lambda: Option<f64>, c: Option<f64>,
    ) {
        let numbers = [
            spacing, sigma_range, sigma_angle, sigma_station, sigma_model, confidence, reliability, max_incidence,
            no_return_range, no_return_weight, kappa, lambda, c,
        ];
        fixed(&GivenParameters::of(loa, model, &numbers)?.model)
    }

    fn ab_evidence_get_model(evidence: EvidenceArg) { fixed(&evidence.header()?.model) }

    /// The cast to today's type: all parameters count as given.
    fn ab_evidence_model_renewed(model: FixedModel) { GivenParameters::all(parse(&model.0)?).ret() }

    /// Without intensity and colour.
    fn ab_scan_beams(rows: Rows; patch: ScanArg) {
        beams(&patch, |beam| rows.push(&beam[..4]))?;
        Ok(SqlValue::Null)
    }

    /// From the hull of a patch, not from its returns.
    fn ab_scan_distance(a: ScanArg, b: Aabb) { Ok(SqlValue::F64(of_scan(&a)?.distance(&b))) }
}

/// What SQL is to declare.
pub const ALL_DECLARED: &[&[Declared]] = &[DECLARED, evidence::DECLARED];
