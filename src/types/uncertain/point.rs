//! `ab_point`: constructor, accessors, confidence regions, search.

use asbuilt_core::geometry::{Aabb, Solid, Vec3};
use asbuilt_core::scan::JOIN_MARGIN_M;
use asbuilt_core::uncertain::{Line, Point};
use asbuilt_core::{Error, Result};

use super::{ret, value};
use crate::pg::{Args, Field, Ret, Rows, sql_functions};
use crate::types::{box_bytes, box_from};

/// Standard deviations by which an index grows a point or line: searches up to this many are served.
pub const INDEX_SIGMAS: f64 = 5.0;

pub(super) fn point(args: &Args, i: usize) -> Point {
    value(args, i)
}

/// The box that stands for an object of SQL type `ty` in `&&` and in indexes.
pub fn overlap_box(args: &Args, i: usize, ty: &str) -> Aabb {
    match ty {
        "point" => point(args, i).bounds(INDEX_SIGMAS),
        "line" => value::<Line, 27>(args, i).bounds(INDEX_SIGMAS),
        _ => box_from(&args.fixed(i)),
    }
}

/// The box of the point in argument `i`, as indexes hold it.
pub fn point_box(args: &Args, i: usize) -> Result<Aabb> {
    Ok(overlap_box(args, i, "point"))
}

fn overlap(args: &Args, left: &str, right: &str) -> Result<Ret> {
    Ok(Ret::Bool(overlap_box(args, 0, left).overlaps(&overlap_box(args, 1, right))))
}

/// The box within which a point may be of the solid in argument `i`.
fn near_solid(args: &Args, i: usize) -> Result<Aabb> {
    Ok(Solid::header(args.prefix(i, Solid::HEADER_LEN))?.bounds.expanded(JOIN_MARGIN_M))
}

fn sd(p: &Point) -> [f64; 3] {
    [0, 1, 2].map(|i| p.covariance[(i, i)].max(0.0).sqrt())
}

sql_functions! {
    /// ab_point(x, y, z, sd, covariance)
    fn ab_point_make(args) {
        if (0..4).any(|i| args.is_null(i)) {
            return Ok(Ret::Null);
        }
        let position = Vec3::new(args.f64(0), args.f64(1), args.f64(2));
        if args.is_null(4) {
            return ret(&Point::isotropic(position, args.f64(3))?);
        }
        if args.f64(3) != 0.0 {
            return Err(Error::argument("sd", "left out where a covariance is given", args.f64(3)));
        }
        ret(&Point::new(position, &args.square::<3>(4, "the covariance of the point")?)?)
    }

    fn ab_point_x(args) { Ok(Ret::F64(point(args, 0).position.x)) }
    fn ab_point_y(args) { Ok(Ret::F64(point(args, 0).position.y)) }
    fn ab_point_z(args) { Ok(Ret::F64(point(args, 0).position.z)) }
    fn ab_point_position(args) { Ok(Ret::vector(point(args, 0).position)) }
    fn ab_point_sd(args) { Ok(Ret::vector(sd(&point(args, 0)))) }
    fn ab_point_covariance(args) { Ok(Ret::matrix(&point(args, 0).covariance)) }

    fn ab_point_ellipsoid(args) {
        let mut rows = Rows::new(args)?;
        for (half_axis, direction) in point(args, 0).ellipsoid(args.f64(1))? {
            rows.push(&[Field::F64(half_axis), Field::Vector(direction.into())]);
        }
        Ok(Ret::Null)
    }

    fn ab_point_box(args) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(args.f64(1), 3)?;
        Ok(Ret::Fixed(box_bytes(&point(args, 0).bounds(factor))))
    }

    fn ab_line_box(args) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(args.f64(1), 3)?;
        Ok(Ret::Fixed(box_bytes(&value::<Line, 27>(args, 0).bounds(factor))))
    }

    fn ab_point_mahalanobis(args) { Ok(Ret::F64(point(args, 0).mahalanobis(&point(args, 1)))) }

    fn ab_point_reach(args) {
        let sigmas = args.f64(1);
        if !(0.0..=INDEX_SIGMAS).contains(&sigmas) {
            return Err(Error::argument("the number of standard deviations", "between 0 and 5", sigmas));
        }
        Ok(Ret::Fixed(box_bytes(&point(args, 0).bounds(sigmas))))
    }

    fn ab_overlaps_solid_point(args) { Ok(Ret::Bool(near_solid(args, 0)?.overlaps(&overlap_box(args, 1, "point")))) }
    fn ab_overlaps_point_solid(args) { Ok(Ret::Bool(near_solid(args, 1)?.overlaps(&overlap_box(args, 0, "point")))) }
    fn ab_overlaps_point_box(args) { overlap(args, "point", "box") }
    fn ab_overlaps_point_point(args) { overlap(args, "point", "point") }
    fn ab_overlaps_line_box(args) { overlap(args, "line", "box") }
    fn ab_overlaps_box_point(args) { overlap(args, "box", "point") }
    fn ab_overlaps_box_line(args) { overlap(args, "box", "line") }
}
