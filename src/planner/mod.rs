//! What the planner is told: statistics of the boxes of a column (ANALYZE), and from them how many rows `&&`, `@>` and
//! `<@` will find.

use asbuilt_core::Result;
use asbuilt_core::geometry::{Aabb, BoxRelation, BoxStatistics};
use asbuilt_core::scan::JOIN_MARGIN_M;

use crate::pg::{
    Args, ColumnStatistics, Internal, Oid, Other, Restriction, SqlValue, Statistics, analysed_by, join, own_value,
    restriction, sql_functions,
};
use crate::types::overlap::{of_line, of_point, of_scan, of_solid, of_tile};

/// Where nothing is known of a table, because it was never analysed. Small enough that an index is used.
const UNKNOWN: f64 = 1e-4;

struct Boxes;

impl Statistics for Boxes {
    fn of(type_name: &str, sample: &mut dyn Iterator<Item = Args>) -> Option<Vec<f64>> {
        // A damaged value is skipped: reading it will raise an error, ANALYZE goes on.
        let boxes: Vec<Aabb> = sample.filter_map(|value| box_of(type_name, &value)).collect();
        Some(BoxStatistics::of(&boxes)?.to_numbers())
    }
}

/// The box of argument 0 as `&&` sees it.
fn box_of(type_name: &str, value: &Args) -> Option<Aabb> {
    match type_name {
        "ab_box" => own_value(value, type_name),
        "ab_solid" => of_solid(&own_value(value, type_name)?).ok(),
        "ab_scan" => of_scan(&own_value(value, type_name)?).ok(),
        "ab_point" => of_point(&own_value(value, type_name)?).ok(),
        "ab_line" => of_line(&own_value(value, type_name)?).ok(),
        "ab_occupancy" | "ab_change" => of_tile(&own_value(value, type_name)?).ok(),
        _ => None,
    }
}

fn statistics(column: &ColumnStatistics) -> Option<BoxStatistics> {
    BoxStatistics::from_numbers(column.numbers.as_deref()?)
}

/// A point overlaps a solid within some distance.
fn margin(a: Option<&str>, b: Option<&str>) -> f64 {
    let pair = [a, b];
    if pair.contains(&Some("ab_point")) && pair.contains(&Some("ab_solid")) { JOIN_MARGIN_M } else { 0.0 }
}

fn mirrored(relation: BoxRelation) -> BoxRelation {
    match relation {
        BoxRelation::Overlaps => BoxRelation::Overlaps,
        BoxRelation::Contains => BoxRelation::Contained,
        BoxRelation::Contained => BoxRelation::Contains,
    }
}

fn share_of_rows(args: &Args, relation: BoxRelation) -> Result<SqlValue> {
    let share = restriction(args).map_or(UNKNOWN, |r| restricted(&r, relation).unwrap_or(UNKNOWN));
    Ok(SqlValue::F64(share))
}

fn restricted(r: &Restriction, relation: BoxRelation) -> Option<f64> {
    let own = statistics(&r.column)?;
    let name = r.column.type_name.as_deref();
    let relation = if r.column_on_left { relation } else { mirrored(relation) };
    let share = match &r.other {
        Other::Null => 0.0,
        Other::Value(value, theirs) => {
            let query = box_of(theirs, value)?;
            own.selectivity(&query.expanded(margin(name, Some(theirs))), relation)
        }
        Other::Column(other) => {
            own.join_selectivity(&statistics(other)?, relation, margin(name, other.type_name.as_deref()))
        }
        // What is asked for is like what is there.
        Other::Unknown => own.join_selectivity(&own, relation, 0.0),
    };
    Some(share * r.column.present)
}

fn share_of_pairs(args: &Args, relation: BoxRelation) -> Result<SqlValue> {
    let j = join(args);
    let known = statistics(&j.left).zip(statistics(&j.right)).map(|(left, right)| {
        let margin = margin(j.left.type_name.as_deref(), j.right.type_name.as_deref());
        left.join_selectivity(&right, relation, margin) * j.left.present * j.right.present
    });
    let pairs = known.unwrap_or(UNKNOWN);
    // A semi join asks how many outer rows have a partner at all.
    Ok(SqlValue::F64(j.inner_rows.map_or(pairs, |rows| (pairs * rows).min(1.0))))
}

sql_functions! {
    fn ab_typanalyze(call: Call; column: Internal) { Ok(analysed_by::<Boxes>(call)) }

    fn ab_overlap_sel(call: Call; root: Internal, operator: Oid, list: Internal, relation: i32) {
        share_of_rows(call, BoxRelation::Overlaps)
    }
    fn ab_contains_sel(call: Call; root: Internal, operator: Oid, list: Internal, relation: i32) {
        share_of_rows(call, BoxRelation::Contains)
    }
    fn ab_contained_sel(call: Call; root: Internal, operator: Oid, list: Internal, relation: i32) {
        share_of_rows(call, BoxRelation::Contained)
    }

    fn ab_overlap_join_sel(call: Call; root: Internal, operator: Oid, list: Internal, kind: i16, join: Internal) {
        share_of_pairs(call, BoxRelation::Overlaps)
    }
    fn ab_contains_join_sel(call: Call; root: Internal, operator: Oid, list: Internal, kind: i16, join: Internal) {
        share_of_pairs(call, BoxRelation::Contains)
    }
    fn ab_contained_join_sel(call: Call; root: Internal, operator: Oid, list: Internal, kind: i16, join: Internal) {
        share_of_pairs(call, BoxRelation::Contained)
    }
}
