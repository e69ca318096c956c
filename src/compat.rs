//! What the SQL of 0.1.0 calls and today's does not: its functions live on as `_ab_…_010` (sql/install/99-compat.sql), for
//! views that were made with them, and its own SQL runs until it is updated.

use asbuilt_core::verify::{Shift, Summary};

use crate::pg::{Account, Field, Ret, Rows, sql_functions};
use crate::types::overlap::{of_box, of_scan};
use crate::types::{beams, shift_arg, summary_arg, summary_fields};

/// The columns of `ab_summary`, the last of them a text: `(+0.0121, -, +0.0003) +/- (0.0004, -, 0.0005)`.
fn summary(s: &Summary) -> Vec<Field> {
    let mut fields = summary_fields(s);
    fields.push(Field::or_null(s.shift.as_ref(), |t| Field::Text(t.to_text())));
    fields
}

/// The offset along each axis, then their standard deviations.
fn shift(t: &Shift) -> Vec<Field> {
    let axis = |i: usize, x: f64| if t.determines(i) { Field::F64(x) } else { Field::Null };
    (0..3).map(|i| axis(i, t.vector[i])).chain((0..3).map(|i| axis(i, t.sd(i)))).collect()
}

sql_functions! {
    on Account::Evidence;

    fn ab_summary(args) { Ok(summary_arg(args)?.map_or(Ret::Null, |s| Ret::Row(summary(&s)))) }

    fn ab_shift(args) { Ok(shift_arg(args)?.map_or(Ret::Null, |t| Ret::Row(shift(&t)))) }
}

sql_functions! {
    /// Without intensity and colour.
    fn ab_scan_beams(args) {
        let mut rows = Rows::new(args)?;
        beams(args, |beam| rows.push(&beam[..4]))?;
        Ok(Ret::Null)
    }

    /// From the hull of a patch, not from its returns.
    fn ab_scan_distance(args) { Ok(Ret::F64(of_scan(args, 0)?.distance(&of_box(args, 1)?))) }
}
