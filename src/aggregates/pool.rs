//! `ab_combine_agg`: any number of masses by one rule.

use asbuilt_core::Result;
use asbuilt_core::evidence::{Pool, Rule};

use crate::pg::{AggState, Args, SqlValue, aggregate_state, deserialised_state, sql_functions};
use crate::types::{mass_arg, mass_ret};

fn state(args: &Args, i: usize, rule: Rule) -> Result<AggState<Pool>> {
    aggregate_state(args, i, || Pool::new(rule))
}

sql_functions! {
    /// transition(state, mass): a NULL mass adds nothing.
    fn ab_combine_accum(args) {
        let mut state = state(args, 0, Rule::Dempster)?;
        if !args.is_null(1) {
            state.get().add(&mass_arg(args, 1))?;
        }
        Ok(state.ret())
    }

    /// transition(state, mass, rule[, reliability]): a NULL among them adds nothing.
    fn ab_combine_accum_by(args) {
        if (1..args.len()).any(|i| args.is_null(i)) {
            return Ok(if args.is_null(0) { SqlValue::Null } else { state(args, 0, Rule::Dempster)?.ret() });
        }
        let rule = Rule::parse(&args.text(2))?;
        let mut state = state(args, 0, rule)?;
        let mut mass = mass_arg(args, 1);
        if args.len() > 3 {
            mass = mass.discount(args.f64(3))?;
        }
        if state.get().rule() != rule {
            return Err(Pool::other_rule(state.get().rule(), rule));
        }
        state.get().add(&mass)?;
        Ok(state.ret())
    }

    fn ab_combine_merge(args) {
        if args.is_null(1) {
            return Ok(if args.is_null(0) { SqlValue::Null } else { state(args, 0, Rule::Dempster)?.ret() });
        }
        let right = *state(args, 1, Rule::Dempster)?.get();
        let mut left = state(args, 0, right.rule())?;
        left.get().merge(&right)?;
        Ok(left.ret())
    }

    fn ab_combine_serial(args) { Ok(SqlValue::Bytes(state(args, 0, Rule::Dempster)?.get().to_bytes())) }

    fn ab_combine_deserial(args) { Ok(deserialised_state(Pool::from_bytes(args.bytes(0))?).ret()) }

    fn ab_combine_final(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        match state(args, 0, Rule::Dempster)?.get().mass()? {
            Some(m) => mass_ret(&m),
            None => Ok(SqlValue::Null),
        }
    }
}
