//! Patches taken apart, filtered, thinned, moved, joined.

use asbuilt_core::scan::{Origins, Patch};
use asbuilt_core::uncertain::Pose;
use asbuilt_core::{Error, Result};

use super::scan::header;
use super::{box_from, uncertain};
use crate::pg::{Args, Backend, Field, Rows, SqlValue, sql_functions};

fn or_null(patch: Option<Patch>) -> Result<SqlValue> {
    Ok(patch.map_or(SqlValue::Null, |p| SqlValue::Bytes(p.to_bytes())))
}

/// Every beam of the patch in argument 0: origin, return, direction, range, intensity, colour. What did not return has
/// a direction only.
pub fn beams(args: &Args, mut each: impl FnMut([Field; 6])) -> Result<()> {
    let (header, content) = Patch::content_of(args.bytes(0))?;
    let has_rays = header.origins() != Origins::Unknown;
    for (i, b) in content.beams.iter().enumerate() {
        let range = b.offset.norm();
        let when = |there: bool, field: Field| if there { field } else { Field::Null };
        let intensity = content.intensity.as_ref().filter(|_| b.returned);
        let colour = content.colour.as_ref().filter(|_| b.returned);
        each([
            when(has_rays, Field::Vector((header.origin + content.start(i)).into())),
            when(b.returned, Field::Vector((header.origin + content.end(i)).into())),
            when(has_rays && range > 0.0, Field::Vector((b.offset / range).into())),
            when(has_rays && b.returned, Field::F64(range)),
            Field::or_null(intensity, |p| Field::I32(p[i].into())),
            Field::or_null(colour, |p| Field::I32Array(p[i].map(i32::from).to_vec())),
        ]);
    }
    Ok(())
}

sql_functions! {
    fn ab_scan_cone(args) {
        let h = header(args)?;
        if h.origins() != Origins::One {
            return Ok(SqlValue::Row(vec![Field::Null, Field::Null]));
        }
        Ok(SqlValue::Row(vec![Field::Vector(h.cone.axis.into()), Field::F64(h.cone.half_angle)]))
    }

    fn ab_scan_range(args) {
        let h = header(args)?;
        let known = h.returns > 0 && h.origins() != Origins::Unknown;
        let [nearest, farthest] = h.range.map(|r| if known { Field::F64(f64::from(r)) } else { Field::Null });
        Ok(SqlValue::Row(vec![nearest, farthest]))
    }

    /// ab_beams(patch): a beam without return has only a direction.
    fn ab_patch_beams(args) {
        let mut rows = Rows::new(args)?;
        beams(args, |beam| rows.push(&beam))?;
        Ok(SqlValue::Null)
    }

    fn ab_scan_filter_box(args) { or_null(Patch::within(args.bytes(0), &box_from(&args.fixed(1)))?) }

    /// ab_filter(patch, min_range, max_range)
    fn ab_scan_filter_range(args) {
        let (min, max) = (args.f64(1), args.f64(2));
        if min.is_nan() || max.is_nan() || min > max {
            return Err(Error::argument("the ranges", "a least and a greatest one", format!("{min} and {max}")));
        }
        or_null(Patch::between(args.bytes(0), min, max)?)
    }

    fn ab_scan_thin(args) { or_null(Patch::thinned(args.bytes(0), args.f64(1))?) }

    fn ab_transform_scan(args) {
        let pose: Pose = uncertain::value(args, 1);
        Ok(SqlValue::Bytes(Patch::moved(args.bytes(0), &pose)?.to_bytes()))
    }

    fn ab_scan_union(args) {
        or_null(Patch::union(&args.bytes_array(0, "the patches")?, &Backend)?)
    }

    fn ab_scan_retile(args) {
        let mut rows = Rows::new(args)?;
        for patch in Patch::retiled(&args.bytes_array(0, "the patches")?, &Backend)? {
            rows.push(&[Field::Bytes(patch.to_bytes())]);
        }
        Ok(SqlValue::Null)
    }

    /// ab_sees(patch, box, margin)
    fn ab_scan_sees(args) {
        let margin = args.f64(2);
        if !(margin >= 0.0 && margin.is_finite()) {
            return Err(Error::argument("the margin", "0 or more, and finite", margin));
        }
        Ok(SqlValue::Bool(header(args)?.sees(&box_from(&args.fixed(1)), margin)))
    }
}
