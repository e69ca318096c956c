//! The belief calculus on `ab_mass`: rules, measures, decisions.

use asbuilt_core::Error;
use asbuilt_core::evidence::{Criterion, Hypothesis, Rule};

use super::{mass_arg, mass_ret};
use crate::pg::{SqlValue, sql_functions};

sql_functions! {
    fn ab_mass_combine_by(args) {
        mass_ret(&Rule::parse(&args.text(2))?.combine(&mass_arg(args, 0), &mass_arg(args, 1))?)
    }

    fn ab_mass_contradiction(args) { Ok(SqlValue::F64(mass_arg(args, 0).contradiction())) }
    fn ab_mass_nonspecificity(args) { Ok(SqlValue::F64(mass_arg(args, 0).nonspecificity())) }
    fn ab_mass_discord(args) { Ok(SqlValue::F64(mass_arg(args, 0).discord())) }

    fn ab_mass_discount(args) { mass_ret(&mass_arg(args, 0).discount(args.f64(1))?) }

    fn ab_mass_pignistic(args) {
        let p = mass_arg(args, 0).pignistic(Hypothesis::parse(&args.text(1))?);
        p.map(SqlValue::F64).ok_or(Error::TotalConflict)
    }

    fn ab_mass_decide(args) {
        let decision = mass_arg(args, 0).decide(Criterion::parse(&args.text(1))?, args.f64(2))?;
        Ok(SqlValue::text(match decision {
            Some(Hypothesis::Occupied) => "occupied",
            Some(Hypothesis::Empty) => "empty",
            None => "unknown",
        }))
    }
}
