//! Levels and classes of accuracy, beliefs at other accuracies, tolerances.

use asbuilt_core::evidence::accuracy;

use crate::pg::{Field, Rows, SqlValue, sql_functions};

sql_functions! {
    fn ab_loa_confidence(args) { Ok(SqlValue::F64(args.loa(0)?.confidence(args.f64(1))?)) }

    fn ab_convert_belief(args) {
        Ok(SqlValue::F64(accuracy::convert_belief(args.f64(0), args.f64(1), args.f64(2))?))
    }

    fn ab_convert_belief_loa(args) {
        Ok(SqlValue::F64(accuracy::convert_belief(args.f64(0), args.f64(1), args.loa(2)?.sigma())?))
    }

    /// ab_convert_belief_linear(belief, sigma, sigma_to, divisor)
    fn ab_convert_belief_linear(args) {
        let (belief, capped) =
            accuracy::convert_belief_linear(args.f64(0), args.f64(1), args.f64(2), args.f64(3))?;
        Ok(SqlValue::Row(vec![Field::F64(belief), Field::Bool(capped)]))
    }

    fn ab_relative_tolerance(args) {
        Ok(SqlValue::F64(accuracy::relative_tolerance(args.f64(0), args.f64(1), &args.text(2))?))
    }

    /// ab_is_fit(sigma, tolerance, purpose)
    fn ab_is_fit(args) {
        let sigma = asbuilt_core::uncertain::checked_sd("the sensor's standard deviation", args.f64(0))?;
        Ok(SqlValue::Bool(sigma <= accuracy::largest_sigma(args.f64(1), &args.text(2))?))
    }

    fn ab_din18710_class(args) {
        let mut rows = Rows::new(args)?;
        for (class, lower, upper) in accuracy::DIN_18710 {
            rows.push(&[
                Field::Text(class.into()),
                Field::F64(lower),
                Field::F64(upper),
                Field::Text("DIN 18710-1:2010, one standard deviation".into()),
            ]);
        }
        Ok(SqlValue::Null)
    }
}
