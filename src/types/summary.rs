//! `ab_summary(e)`, `ab_verdict(e)`, `ab_shift(e)`: the answers.

use asbuilt_core::Result;
use asbuilt_core::verify::{Evidence, EvidenceModel, Summary, VerdictRule};

use crate::pg::{Account, Args, Backend, Field, Ret, sql_functions};

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

fn summary(args: &Args) -> Result<Summary> {
    let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
    e.summary(&question(args, &e, 1)?, &rule(args, 3)?, &Backend)
}

/// The columns of `ab_summary`.
pub fn row(s: &Summary) -> Vec<Field> {
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
        Field::or_null(s.shift.as_ref(), |t| Field::Text(t.to_text())),
    ]
}

sql_functions! {
    on Account::Evidence;

    fn ab_summary(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        Ok(Ret::Row(row(&summary(args)?)))
    }

    fn ab_verdict(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
        let verdict = e.verdict(&question(args, &e, 1)?, &rule(args, 3)?, &Backend)?;
        Ok(Ret::text(verdict.name()))
    }

    /// ab_explain(e, loa, confidence, min_confirmed, min_coverage, max_conflict)
    fn ab_explain(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
        Ok(Ret::text(&e.explain(&question(args, &e, 1)?, &rule(args, 3)?, &Backend)?))
    }

    /// The rigid offset as numbers: vector, standard deviations, undetermined directions.
    fn ab_shift(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        let e = Evidence::from_bytes(args.bytes(0), &Backend)?;
        let Some(t) = e.rigid_shift(&Backend)? else {
            return Ok(Ret::Null);
        };
        let axis = |i: usize, x: f64| if t.determines(i) { Field::F64(x) } else { Field::Null };
        let mut fields: Vec<Field> = (0..3).map(|i| axis(i, t.vector[i])).collect();
        fields.extend((0..3).map(|i| axis(i, t.sd(i))));
        Ok(Ret::Row(fields))
    }
}
