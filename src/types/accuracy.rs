//! Levels and classes of accuracy, beliefs at other accuracies, tolerances.

use asbuilt_core::evidence::{Loa, accuracy};

use crate::pg::{RowField, SqlValue, sql_functions};

sql_functions! {
    fn ab_loa_confidence(loa: Loa, within: f64) { Ok(SqlValue::F64(loa.confidence(within)?)) }

    fn ab_convert_belief(belief: f64, sigma: f64, sigma_to: f64) {
        Ok(SqlValue::F64(accuracy::convert_belief(belief, sigma, sigma_to)?))
    }

    fn ab_convert_belief_loa(belief: f64, sigma: f64, loa: Loa) {
        Ok(SqlValue::F64(accuracy::convert_belief(belief, sigma, loa.sigma())?))
    }

    fn ab_convert_belief_linear(belief: f64, sigma: f64, sigma_to: f64, divisor: f64) {
        let (belief, capped) = accuracy::convert_belief_linear(belief, sigma, sigma_to, divisor)?;
        Ok(SqlValue::Row(vec![RowField::F64(belief), RowField::Bool(capped)]))
    }

    fn ab_relative_tolerance(t1: f64, t2: f64, rule: String) {
        Ok(SqlValue::F64(accuracy::relative_tolerance(t1, t2, &rule)?))
    }

    fn ab_is_fit(sigma: f64, tolerance: f64, purpose: String) {
        let sigma = asbuilt_core::uncertain::checked_sd("the sensor's standard deviation", sigma)?;
        Ok(SqlValue::Bool(sigma <= accuracy::largest_sigma(tolerance, &purpose)?))
    }

    fn ab_din18710_class(rows: Rows;) {
        for (class, lower, upper) in accuracy::DIN_18710 {
            rows.push(&[
                RowField::Text(class.into()),
                RowField::F64(lower),
                RowField::F64(upper),
                RowField::Text("DIN 18710-1:2010, one standard deviation".into()),
            ]);
        }
        Ok(SqlValue::Null)
    }
}
