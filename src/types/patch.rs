//! Patches taken apart, filtered, thinned, moved, joined.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Patch;
use asbuilt_core::uncertain::Pose;
use asbuilt_core::{Error, Result};

use super::scan::header;
use super::{box_from, uncertain};
use crate::pg::{Args, Field, Ret, Rows, interrupt, sql_functions};

fn or_null(patch: Option<Patch>) -> Result<Ret> {
    Ok(patch.map_or(Ret::Null, |p| Ret::Bytes(p.to_bytes())))
}

fn retiled(args: &Args) -> Result<Vec<Patch>> {
    Patch::retiled(&args.bytes_array(0, "the patches")?, &interrupt)
}

sql_functions! {
    fn ab_scan_cone(args) {
        let h = header(args)?;
        if !h.has_origin() {
            return Ok(Ret::Row(vec![Field::Null, Field::Null]));
        }
        Ok(Ret::Row(vec![Field::Vector(h.cone.axis.into()), Field::F64(h.cone.half_angle)]))
    }

    fn ab_scan_range(args) {
        let h = header(args)?;
        let [nearest, farthest] = h.range.map(|r| if h.returns > 0 { Field::F64(f64::from(r)) } else { Field::Null });
        Ok(Ret::Row(vec![nearest, farthest]))
    }

    /// ab_beams(patch): what did not return has a direction only.
    fn ab_scan_beams(args) {
        let mut rows = Rows::new(args)?;
        let (header, beams) = Patch::beams_of(args.bytes(0))?;
        for b in beams {
            let range = b.offset.norm();
            let direction = || Field::Vector((b.offset / range).into());
            let returned = |field: Field| if b.returned { field } else { Field::Null };
            rows.push(&[
                if header.has_origin() { Field::Vector(header.origin.into()) } else { Field::Null },
                returned(Field::Vector(Vec3::into(b.offset + header.origin))),
                if header.has_origin() && range > 0.0 { direction() } else { Field::Null },
                if header.has_origin() { returned(Field::F64(range)) } else { Field::Null },
            ]);
        }
        Ok(Ret::Null)
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
        Ok(Ret::Bytes(Patch::moved(args.bytes(0), &pose)?.to_bytes()))
    }

    fn ab_scan_retile(args) {
        let mut rows = Rows::new(args)?;
        for patch in retiled(args)? {
            rows.push(&[Field::Bytes(patch.to_bytes())]);
        }
        Ok(Ret::Null)
    }

    /// ab_sees(patch, box, margin)
    fn ab_scan_sees(args) {
        let margin = args.f64(2);
        if !(margin >= 0.0 && margin.is_finite()) {
            return Err(Error::argument("the margin", "0 or more, and finite", margin));
        }
        Ok(Ret::Bool(header(args)?.sees(&box_from(&args.fixed(1)), margin)))
    }
}
