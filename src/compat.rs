//! What the SQL of 0.1.0 calls and today's does not: its functions live on as `_ab_…_010` (sql/install/99-compat.sql),
//! for views that were made with them, and its own SQL runs until it is updated.

use asbuilt_core::Result;
use asbuilt_core::num::bytes::Reader;
use asbuilt_core::verify::{EvidenceModel, Shift, Summary};

use crate::aggregates::evidence::{absorb_patch, absorb_tie_point};
use crate::pg::{Account, Args, Field, Rows, SqlValue, sql_functions};
use crate::types::evidence::header;
use crate::types::overlap::{of_box, of_scan};
use crate::types::{Given, beams, shift_arg, summary_arg, summary_fields};

/// The fixed-length form of the parameters: `ab_evidence_model_010`, once `ab_evidence_model`.
fn fixed(m: &EvidenceModel) -> Result<SqlValue> {
    let mut bytes = Vec::with_capacity(EvidenceModel::LEN);
    m.write(&mut bytes);
    Ok(SqlValue::Fixed(bytes))
}

fn parse(bytes: &[u8]) -> Result<EvidenceModel> {
    let mut r = Reader::new(bytes, "ab_evidence_model_010");
    let model = EvidenceModel::read(&mut r)?;
    r.finish()?;
    Ok(model)
}

/// The model in argument `i`; the default when it is NULL.
fn fixed_arg(args: &Args, i: usize) -> Result<EvidenceModel> {
    if args.is_null(i) { Ok(EvidenceModel::default()) } else { parse(&args.fixed::<{ EvidenceModel::LEN }>(i)) }
}

/// The columns of `ab_summary`, the last of them a text: `(+0.0121, -, +0.0003) +/- (0.0004, -, 0.0005)`.
fn summary(s: &Summary) -> Vec<Field> {
    let mut fields = summary_fields(s);
    fields.push(Field::or_null(s.shift.as_ref(), |t| Field::Text(t.to_text())));
    fields
}

/// The offset along each axis, then their standard deviations.
fn shift(t: &Shift) -> Vec<Field> {
    let axis = |i: usize, x: f64| if t.determines(i) { Field::F64(x) } else { Field::Null };
    (0..3).map(|i| axis(i, t.vector[i])).chain((0..3).map(|i| axis(i, t.sd(i)))).collect()
}

sql_functions! {
    on Account::Evidence;

    fn ab_evidence_accum(args) { absorb_patch(args, fixed_arg) }

    fn ab_evidence_accum_point(args) { absorb_tie_point(args, fixed_arg) }

    fn ab_summary(args) { Ok(summary_arg(args)?.map_or(SqlValue::Null, |s| SqlValue::Row(summary(&s)))) }

    fn ab_shift(args) { Ok(shift_arg(args)?.map_or(SqlValue::Null, |t| SqlValue::Row(shift(&t)))) }
}

sql_functions! {
    fn ab_evidence_model_in(args) { fixed(&EvidenceModel::from_text(&args.cstring(0))?) }

    fn ab_evidence_model_out(args) { Ok(SqlValue::CString(fixed_arg(args, 0)?.to_text())) }

    fn ab_evidence_model_recv(args) { fixed(&parse(args.message(0))?) }

    fn ab_evidence_model_send(args) { Ok(SqlValue::Bytes(args.fixed::<{ EvidenceModel::LEN }>(0).to_vec())) }

    fn ab_evidence_model_make(args) { fixed(&Given::from_args(args)?.model) }

    fn ab_evidence_get_model(args) { fixed(&header(args)?.model) }

    /// The cast to today's type: all parameters count as given.
    fn ab_evidence_model_renewed(args) { Given::all(fixed_arg(args, 0)?).ret() }

    /// Without intensity and colour.
    fn ab_scan_beams(args) {
        let mut rows = Rows::new(args)?;
        beams(args, |beam| rows.push(&beam[..4]))?;
        Ok(SqlValue::Null)
    }

    /// From the hull of a patch, not from its returns.
    fn ab_scan_distance(args) { Ok(SqlValue::F64(of_scan(args, 0)?.distance(&of_box(args, 1)?))) }
}
