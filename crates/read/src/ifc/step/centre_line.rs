//! Lines with a thickness (IfcCenterLineProfileDef), which the geometry library does not know: an open one is a band,
//! a closed one a ring.

use super::document::{Document, Edits};
use super::line::line_of;
use super::profiles::{ProfilePoint, area, closed, write};
use super::value::Value;

pub fn write_out(document: &Document, free: &mut dyn Iterator<Item = u64>, edits: &mut Edits) {
    for record in document.all("IFCCENTERLINEPROFILEDEF") {
        let values = document.values(record);
        let line = values.get(2).and_then(|v| line_of(document, v.reference()?));
        let Some((line, thickness)) = line.zip(values.get(3).and_then(Value::number)) else { continue };
        match sides(&line.points, thickness) {
            Some((right, left, false)) => {
                let band: Vec<ProfilePoint> = right.into_iter().chain(left.into_iter().rev()).collect();
                write(document, record, &values, &band, free, edits);
            }
            Some((right, left, true)) => {
                let is_outer = area(&right).abs() > area(&left).abs();
                let (outer, inner) = if is_outer { (right, left) } else { (left, right) };
                let [Some(outer), Some(inner)] = [closed(&outer, free), closed(&inner, free)] else { return };
                let rest = format!("(.AREA.,$,#{},(#{}));{}{}", outer.0, inner.0, outer.1, inner.1);
                edits.replace(record.span.clone(), format!("#{}=IFCARBITRARYPROFILEDEFWITHVOIDS{rest}", record.id));
            }
            None => {}
        }
    }
}

/// Half the thickness to each side, mitred at corners, and whether the line is closed; `None` where it turns back on
/// itself.
fn sides(line: &[Vec<f64>], thickness: f64) -> Option<(Vec<ProfilePoint>, Vec<ProfilePoint>, bool)> {
    const BACK_COS: f64 = -0.98;
    let mut line: Vec<ProfilePoint> = line.iter().map(|p| p.first_chunk().copied()).collect::<Option<_>>()?;
    let is_closed = line.len() > 3 && line.first() == line.last();
    let normal = |s: &[ProfilePoint]| {
        let [x, y] = [s[1][0] - s[0][0], s[1][1] - s[0][1]];
        let length = x.hypot(y);
        (length > 0.0).then(|| [-y / length, x / length])
    };
    let normals: Vec<ProfilePoint> = line.windows(2).map(normal).collect::<Option<_>>()?;
    let last = normals.len() - 1;
    if is_closed {
        line.pop();
    }
    let offset = |i: usize| {
        let before = if is_closed && i == 0 { last } else { i.max(1) - 1 };
        let (a, b) = (normals[before], normals[i.min(last)]);
        let cos = a[0] * b[0] + a[1] * b[1];
        (cos > BACK_COS).then(|| [0, 1].map(|k| thickness / 2.0 * (a[k] + b[k]) / (1.0 + cos)))
    };
    let offsets: Vec<ProfilePoint> = (0..line.len()).map(offset).collect::<Option<_>>()?;
    let side = |sign: f64| line.iter().zip(&offsets).map(move |(p, o)| [p[0] + sign * o[0], p[1] + sign * o[1]]);
    let is_one_way = is_closed || line.first() != line.last();
    (thickness > 0.0 && is_one_way).then(|| (side(-1.0).collect(), side(1.0).collect(), is_closed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_and_rings() {
        let line = |points: &[[f64; 2]]| points.iter().map(|p| p.to_vec()).collect::<Vec<_>>();
        let (right, left, is_closed) = sides(&line(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]), 0.2).unwrap();
        let band: Vec<ProfilePoint> = right.into_iter().chain(left.into_iter().rev()).collect();
        assert!((area(&band) - 1.4).abs() < 1e-12 && !is_closed);
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
        let (right, left, is_closed) = sides(&line(&square), 0.2).unwrap();
        assert!((area(&right) - area(&left) - 3.2).abs() < 1e-12 && is_closed);
        assert!(sides(&line(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]), 0.2).is_none());
    }
}
