//! `ab_summary(evidence)`, `ab_verdict(evidence)`, `ab_shift(evidence)`: the answers.

use asbuilt_core::Result;
use asbuilt_core::verify::{Evidence, EvidenceModel, Shift, Summary, VerdictRule};

use crate::pg::{Account, Args, Backend, Field, SqlValue, sql_functions};

/// The evidence's model, with the level of accuracy in argument `i` and the confidence in the next, unless NULL.
pub fn question(args: &Args, e: &Evidence, i: usize) -> Result<EvidenceModel> {
    let mut model = *e.model();
    if !args.is_null(i) {
        model.loa = args.loa(i)?;
    }
    if !args.is_null(i + 1) {
        model.set("confidence", args.f64(i + 1))?;
    }
    Ok(model)
}

/// The thresholds in argument `i` and the two after it, unless NULL.
pub fn rule(args: &Args, i: usize) -> Result<VerdictRule> {
    let mut rule = VerdictRule::default();
    for (k, (what, place)) in [
        ("min_confirmed", &mut rule.min_confirmed),
        ("min_coverage", &mut rule.min_coverage),
        ("max_conflict", &mut rule.max_conflict),
    ]
    .into_iter()
    .enumerate()
    {
        if !args.is_null(i + k) {
            let value = args.f64(i + k);
            if !(0.0..=1.0).contains(&value) {
                return Err(asbuilt_core::Error::argument(what, "between 0 and 1", value));
            }
            *place = value;
        }
    }
    Ok(rule)
}

/// The summary of the evidence in argument 0, as the arguments behind it ask; none for NULL.
pub fn summary_arg(args: &Args) -> Result<Option<Summary>> {
    if args.is_null(0) {
        return Ok(None);
    }
    let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
    e.summary(&question(args, &e, 1)?, &rule(args, 3)?, &Backend).map(Some)
}

/// The rigid offset of the evidence in argument 0; none for NULL, and where no direction is determined.
pub fn shift_arg(args: &Args) -> Result<Option<Shift>> {
    if args.is_null(0) {
        return Ok(None);
    }
    Evidence::from_bytes(args.bytes(0), &Backend)?.rigid_shift(&Backend)
}

/// The columns of `ab_summary` up to the shift.
pub fn summary_fields(s: &Summary) -> Vec<Field> {
    let share = |f: fn(&asbuilt_core::verify::Shares) -> f64| Field::or_null(s.shares.as_ref(), |x| Field::F64(f(x)));
    vec![
        Field::Text(s.verdict.name().into()),
        Field::or_null(s.best_loa, Field::Loa),
        Field::I64(s.samples as i64),
        Field::F64(s.coverage),
        share(|x| x.confirmed),
        share(|x| x.refuted),
        share(|x| x.open),
        share(|x| x.conflict),
        Field::or_null(s.deviation, |d| Field::F64(d.0)),
        Field::or_null(s.deviation, |d| Field::F64(d.1)),
    ]
}

/// Offset and standard deviations, three elements each: one is NULL where its axis is not determined, and both arrays
/// are where none is.
fn shift_fields(shift: Option<&Shift>) -> [Field; 2] {
    let Some(t) = shift.filter(|t| (0..3).any(|i| t.determines(i))) else {
        return [Field::Null, Field::Null];
    };
    let along = |of: &dyn Fn(usize) -> f64| Field::Axes([0, 1, 2].map(|i| t.determines(i).then(|| of(i))));
    [along(&|i| t.vector[i]), along(&|i| t.sd(i))]
}

/// The columns of `ab_summary`.
pub fn row(s: &Summary) -> Vec<Field> {
    let mut fields = summary_fields(s);
    fields.extend(shift_fields(s.shift.as_ref()));
    fields
}

sql_functions! {
    on Account::Evidence;

    /// ab_summary(evidence, loa, confidence, min_confirmed, min_coverage, max_conflict)
    fn ab_evidence_summary(args) { Ok(summary_arg(args)?.map_or(SqlValue::Null, |s| SqlValue::Row(row(&s)))) }

    fn ab_verdict(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
        let verdict = e.verdict(&question(args, &e, 1)?, &rule(args, 3)?, &Backend)?;
        Ok(SqlValue::text(verdict.name()))
    }

    /// ab_explain(evidence, loa, confidence, min_confirmed, min_coverage, max_conflict)
    fn ab_explain(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
        Ok(SqlValue::text(&e.explain(&question(args, &e, 1)?, &rule(args, 3)?, &Backend)?))
    }

    /// ab_shift(evidence)
    fn ab_evidence_shift(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        Ok(SqlValue::Row(shift_fields(shift_arg(args)?.as_ref()).to_vec()))
    }
}
