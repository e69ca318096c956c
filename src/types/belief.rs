//! The belief calculus on `ab_mass`: rules, measures, decisions.

use asbuilt_core::Error;
use asbuilt_core::evidence::{CombinationRule, Criterion, Hypothesis, Mass};

use super::mass_ret;
use crate::pg::{SqlValue, sql_functions};

sql_functions! {
    fn ab_mass_combine_by(m1: Mass, m2: Mass, rule: String) {
        mass_ret(&CombinationRule::parse(&rule)?.combine(&m1, &m2)?)
    }

    fn ab_mass_contradiction(mass: Mass) { Ok(SqlValue::F64(mass.contradiction())) }
    fn ab_mass_nonspecificity(mass: Mass) { Ok(SqlValue::F64(mass.nonspecificity())) }
    fn ab_mass_discord(mass: Mass) { Ok(SqlValue::F64(mass.discord())) }

    fn ab_mass_discount(mass: Mass, reliability: f64) { mass_ret(&mass.discount(reliability)?) }

    fn ab_mass_pignistic(mass: Mass, hypothesis: String) {
        let p = mass.pignistic(Hypothesis::parse(&hypothesis)?);
        p.map(SqlValue::F64).ok_or(Error::TotalConflict)
    }

    fn ab_mass_decide(mass: Mass, criterion: String, threshold: f64) {
        let decision = mass.decide(Criterion::parse(&criterion)?, threshold)?;
        Ok(SqlValue::text(match decision {
            Some(Hypothesis::Occupied) => "occupied",
            Some(Hypothesis::Empty) => "empty",
            None => "unknown",
        }))
    }
}
