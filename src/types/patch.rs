//! Patches taken apart, filtered, thinned, moved, joined.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::{Origins, Patch};
use asbuilt_core::uncertain::UncertainPose;
use asbuilt_core::{Error, Result};

use super::scan::ScanArg;
use crate::pg::{Backend, RowField, ScanArray, SqlValue, sql_functions};

fn or_null(patch: Option<Patch>) -> Result<SqlValue> {
    Ok(patch.map_or(SqlValue::Null, |p| SqlValue::Bytes(p.to_bytes())))
}

/// Every beam of a patch: origin, return, direction, range, intensity, colour. What did not return has
/// a direction only.
pub fn beams(patch: &ScanArg, mut each: impl FnMut([RowField; 6])) -> Result<()> {
    let (header, content) = Patch::content_of(patch.bytes())?;
    let has_rays = header.origins() != Origins::Unknown;
    for (i, b) in content.beams.iter().enumerate() {
        let range = b.offset.norm();
        let when = |there: bool, field: RowField| if there { field } else { RowField::Null };
        let intensity = content.intensity.as_ref().filter(|_| b.returned);
        let colour = content.colour.as_ref().filter(|_| b.returned);
        each([
            when(has_rays, RowField::Vector((header.origin + content.start(i)).into())),
            when(b.returned, RowField::Vector((header.origin + content.end(i)).into())),
            when(has_rays && range > 0.0, RowField::Vector((b.offset / range).into())),
            when(has_rays && b.returned, RowField::F64(range)),
            RowField::or_null(intensity, |p| RowField::I32(p[i].into())),
            RowField::or_null(colour, |p| RowField::I32Array(p[i].map(i32::from).to_vec())),
        ]);
    }
    Ok(())
}

sql_functions! {
    fn ab_scan_cone(patch: ScanArg) {
        let h = patch.header()?;
        if h.origins() != Origins::One {
            return Ok(SqlValue::Row(vec![RowField::Null, RowField::Null]));
        }
        Ok(SqlValue::Row(vec![RowField::Vector(h.cone.axis.into()), RowField::F64(h.cone.half_angle)]))
    }

    fn ab_scan_range(patch: ScanArg) {
        let h = patch.header()?;
        let known = h.returns > 0 && h.origins() != Origins::Unknown;
        let [nearest, farthest] = h.range.map(|r| if known { RowField::F64(f64::from(r)) } else { RowField::Null });
        Ok(SqlValue::Row(vec![nearest, farthest]))
    }

    /// A beam without return has only a direction.
    fn ab_patch_beams(rows: Rows; patch: ScanArg) {
        beams(&patch, |beam| rows.push(&beam))?;
        Ok(SqlValue::Null)
    }

    fn ab_scan_filter_box(patch: ScanArg, bounds: Aabb) { or_null(Patch::within(patch.bytes(), &bounds)?) }

    fn ab_scan_filter_range(patch: ScanArg, min: f64, max: f64) {
        if min.is_nan() || max.is_nan() || min > max {
            return Err(Error::argument("the ranges", "a least and a greatest one", format!("{min} and {max}")));
        }
        or_null(Patch::between(patch.bytes(), min, max)?)
    }

    fn ab_scan_thin(patch: ScanArg, spacing: f64) { or_null(Patch::thinned(patch.bytes(), spacing)?) }

    fn ab_transform_scan(patch: ScanArg, pose: UncertainPose) {
        Ok(SqlValue::Bytes(Patch::moved(patch.bytes(), &pose)?.to_bytes()))
    }

    fn ab_scan_union(patches: ScanArray) {
        or_null(Patch::union(&patches.elements("the patches")?, &Backend)?)
    }

    fn ab_scan_retile(rows: Rows; patches: ScanArray) {
        for patch in Patch::retiled(&patches.elements("the patches")?, &Backend)? {
            rows.push(&[RowField::Bytes(patch.to_bytes())]);
        }
        Ok(SqlValue::Null)
    }

    fn ab_scan_sees(patch: ScanArg, bounds: Aabb, margin: f64) {
        if !(margin >= 0.0 && margin.is_finite()) {
            return Err(Error::argument("the margin", "0 or more, and finite", margin));
        }
        Ok(SqlValue::Bool(patch.header()?.sees(&bounds, margin)))
    }
}
