//! `ab_combine_agg`: any number of masses by one rule.

use asbuilt_core::evidence::{CombinationRule, Mass, Pool};

use crate::pg::{AggState, Bytea, Internal, SqlValue, Varlena, deserialised_state, sql_functions, state_or_new};
use crate::types::mass_ret;

type PoolState = AggState<Pool>;

/// The state, left as it is.
fn unchanged(state: Option<PoolState>) -> SqlValue {
    state.map_or(SqlValue::Null, |s| s.ret())
}

sql_functions! {
    /// A NULL mass adds nothing.
    fn ab_combine_accum(call: Call; state: Option<PoolState>, mass: Option<Mass>) {
        let mut state = state_or_new(call, state, || Pool::new(CombinationRule::Dempster))?;
        if let Some(mass) = mass {
            state.get().add(&mass)?;
        }
        Ok(state.ret())
    }

    /// A NULL among the arguments adds nothing; the reliability may be missing.
    fn ab_combine_accum_by(
        call: Call; state: Option<PoolState>, mass: Option<Mass>, rule: Option<String>, reliability: Option<f64>
    ) {
        let (Some(mut mass), Some(rule), true) = (mass, rule, call.len() == 3 || reliability.is_some()) else {
            return Ok(unchanged(state));
        };
        let rule = CombinationRule::parse(&rule)?;
        let mut state = state_or_new(call, state, || Pool::new(rule))?;
        if let Some(reliability) = reliability {
            mass = mass.discount(reliability)?;
        }
        if state.get().rule() != rule {
            return Err(Pool::other_rule(state.get().rule(), rule));
        }
        state.get().add(&mass)?;
        Ok(state.ret())
    }

    fn ab_combine_merge(call: Call; left: Option<PoolState>, right: Option<PoolState>) {
        let Some(mut right) = right else { return Ok(unchanged(left)) };
        let right = *right.get();
        let mut left = state_or_new(call, left, || Pool::new(right.rule()))?;
        left.get().merge(&right)?;
        Ok(left.ret())
    }

    fn ab_combine_serial(state: PoolState) {
        let mut state = state;
        Ok(SqlValue::Bytes(state.get().to_bytes()))
    }

    fn ab_combine_deserial(bytes: Varlena<Bytea>, dummy: Internal) {
        Ok(deserialised_state(Pool::from_bytes(bytes.bytes())?).ret())
    }

    fn ab_combine_final(state: Option<PoolState>) {
        let Some(mut state) = state else { return Ok(SqlValue::Null) };
        match state.get().mass()? {
            Some(m) => mass_ret(&m),
            None => Ok(SqlValue::Null),
        }
    }
}
