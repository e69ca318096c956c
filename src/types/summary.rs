//! `ab_summary(evidence)`, `ab_verdict(evidence)`, `ab_shift(evidence)`: the answers.

use asbuilt_core::evidence::Loa;
use asbuilt_core::verify::{Evidence, Question, Shift, Summary, VerdictRule};
use asbuilt_core::{Error, Result};

use super::evidence::EvidenceArg;
use crate::pg::{Account, Backend, RowField, SqlValue, sql_functions};

/// The question of the evidence's model, at this level of accuracy and confidence where they are given.
pub fn question(e: &Evidence, loa: Option<Loa>, confidence: Option<f64>) -> Result<Question> {
    let mut model = *e.model();
    model.question.loa = loa.unwrap_or(model.question.loa);
    if let Some(confidence) = confidence {
        model.set("confidence", confidence)?;
    }
    Ok(model.question)
}

/// The thresholds `min_confirmed`, `min_coverage` and `max_conflict` where they are given.
pub fn rule([min_confirmed, min_coverage, max_conflict]: [Option<f64>; 3]) -> Result<VerdictRule> {
    let share = |what, value: Option<f64>| match value.filter(|x| !(0.0..=1.0).contains(x)) {
        Some(bad) => Err(Error::argument(what, "between 0 and 1", bad)),
        None => Ok(value),
    };
    let rule = VerdictRule::default();
    let min_confirmed = share("min_confirmed", min_confirmed)?;
    let rule = min_confirmed.map_or(rule, |asked| rule.with_min_confirmed(asked));
    Ok(VerdictRule {
        min_coverage: share("min_coverage", min_coverage)?.unwrap_or(rule.min_coverage),
        max_conflict: share("max_conflict", max_conflict)?.unwrap_or(rule.max_conflict),
        ..rule
    })
}

/// The summary of evidence as it is asked for.
pub fn summary(
    evidence: &EvidenceArg,
    loa: Option<Loa>,
    confidence: Option<f64>,
    thresholds: [Option<f64>; 3],
) -> Result<Summary> {
    let e = evidence.read()?;
    e.summary(&question(&e, loa, confidence)?, &rule(thresholds)?, &Backend)
}

/// The columns of `ab_summary` up to the shift.
pub fn summary_fields(s: &Summary) -> Vec<RowField> {
    let share =
        |f: fn(&asbuilt_core::verify::Shares) -> f64| RowField::or_null(s.shares.as_ref(), |x| RowField::F64(f(x)));
    vec![
        RowField::Text(s.verdict.name().into()),
        RowField::or_null(s.best_loa, RowField::Loa),
        RowField::I64(s.samples as i64),
        RowField::F64(s.coverage),
        share(|x| x.confirmed),
        share(|x| x.refuted),
        share(|x| x.open),
        share(|x| x.conflict),
        RowField::or_null(s.deviation, |d| RowField::F64(d.0)),
        RowField::or_null(s.deviation, |d| RowField::F64(d.1)),
    ]
}

/// Offset and standard deviations, three elements each: one is NULL where its axis is not determined, and both arrays
/// are where none is.
pub fn shift_fields(shift: Option<&Shift>) -> [RowField; 2] {
    let Some(t) = shift.filter(|t| (0..3).any(|i| t.determines(i))) else {
        return [RowField::Null, RowField::Null];
    };
    let along = |of: &dyn Fn(usize) -> f64| RowField::Axes([0, 1, 2].map(|i| t.determines(i).then(|| of(i))));
    [along(&|i| t.vector[i]), along(&|i| t.sd(i))]
}

/// The columns of `ab_summary`; `hidden_by`: by which object, where that is known.
pub fn row(s: &Summary, hidden_by: RowField) -> Vec<RowField> {
    let mut fields = summary_fields(s);
    fields.extend(shift_fields(s.shift.as_ref()));
    fields.extend([
        RowField::or_null(s.deviation_face, |(_, normal)| RowField::Vector(normal.into())),
        RowField::or_null(s.deviation_face, |(number, _)| RowField::I32(number as i32)),
        RowField::or_null(s.unseen, |u| RowField::Text(u.main().name().into())),
        RowField::or_null(s.unseen, |u| RowField::Array(u.shares().into(), vec![7])),
        hidden_by,
    ]);
    fields
}

sql_functions! {
    on Account::Evidence;

    fn ab_evidence_summary(
        evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>,
        min_confirmed: Option<f64>, min_coverage: Option<f64>, max_conflict: Option<f64>,
    ) {
        let thresholds = [min_confirmed, min_coverage, max_conflict];
        Ok(SqlValue::Row(row(&summary(&evidence, loa, confidence, thresholds)?, RowField::Null)))
    }

    fn ab_verdict(
        evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>,
        min_confirmed: Option<f64>, min_coverage: Option<f64>, max_conflict: Option<f64>,
    ) {
        let e = evidence.read()?;
        let question = question(&e, loa, confidence)?;
        let verdict = e.verdict(&question, &rule([min_confirmed, min_coverage, max_conflict])?, &Backend)?;
        Ok(SqlValue::text(verdict.name()))
    }

    fn ab_explain(
        evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>,
        min_confirmed: Option<f64>, min_coverage: Option<f64>, max_conflict: Option<f64>,
    ) {
        let e = evidence.read()?;
        let question = question(&e, loa, confidence)?;
        let rule = rule([min_confirmed, min_coverage, max_conflict])?;
        Ok(SqlValue::text(&e.explain(&question, &rule, &Backend)?))
    }

    fn ab_evidence_shift(evidence: Option<EvidenceArg>) {
        let Some(evidence) = evidence else { return Ok(SqlValue::Null) };
        Ok(SqlValue::Row(shift_fields(evidence.read()?.rigid_shift(&Backend)?.as_ref()).to_vec()))
    }
}
