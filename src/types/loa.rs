//! `ab_loa`: an enum that SQL declares; here is only the table of its bounds.

use asbuilt_core::evidence::Loa;

use crate::pg::{RowField, SqlValue, sql_functions};

sql_functions! {
    fn ab_loa_class(rows: Rows;) {
        for loa in Loa::ALL {
            rows.push(&[
                RowField::Loa(loa),
                RowField::F64(loa.lower()),
                RowField::F64(loa.upper()),
                RowField::F64(loa.upper() / 2.0),
                RowField::Text("USIBD Level of Accuracy Specification Guide, version 2.0 (2016), 95 %".into()),
            ]);
        }
        Ok(SqlValue::Null)
    }

    /// ab_upper_bound(loa)
    fn ab_tolerance(loa: Loa) {
        Ok(SqlValue::F64(loa.upper()))
    }
}
