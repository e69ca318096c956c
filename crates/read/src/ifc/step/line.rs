//! Curves that are made of straight lines alone, as their points.

use super::curves::trimmed;
use super::document::Document;
use super::value::Value;

/// Deepest nesting of a curve, and most points.
const MAX_DEPTH: usize = 16;
const MAX_POINTS: usize = 1 << 16;

#[derive(Debug)]
pub struct Polyline {
    pub points: Vec<Vec<f64>>,
    /// The curve's parameter grows by one from point to point.
    pub is_even: bool,
}

/// A polyline, an indexed one, or one composed or trimmed of such; `None` where it has arcs.
pub fn line_of(document: &Document, id: u64) -> Option<Polyline> {
    nested(document, id, 0)
}

pub fn points_of(document: &Document, polyline: u64) -> Option<Vec<Vec<f64>>> {
    let values = document.values_of(polyline, "IFCPOLYLINE")?;
    let points: Option<Vec<_>> = values.first()?.list().iter().map(|v| document.coordinates(v.reference()?)).collect();
    points.filter(|p| are_of_one_kind(p))
}

pub fn nested(document: &Document, id: u64, depth: usize) -> Option<Polyline> {
    let depth = Some(depth + 1).filter(|&d| d <= MAX_DEPTH)?;
    let record = document.find(id)?;
    let values = || document.values(record);
    let line = if document.is(record, "IFCPOLYLINE") {
        Polyline { points: points_of(document, id)?, is_even: true }
    } else if document.is(record, "IFCINDEXEDPOLYCURVE") {
        Polyline { points: indexed(document, &values())?, is_even: true }
    } else if document.is(record, "IFCCOMPOSITECURVE") {
        composed(document, &values(), depth)?
    } else if document.is(record, "IFCTRIMMEDCURVE") {
        Polyline { points: cut(document, &values(), depth)?, is_even: false }
    } else {
        return None;
    };
    Some(line).filter(|l| l.points.len() <= MAX_POINTS && are_of_one_kind(&l.points))
}

fn are_of_one_kind(points: &[Vec<f64>]) -> bool {
    points.len() >= 2 && !points[0].is_empty() && points.iter().all(|p| p.len() == points[0].len())
}

fn indexed(document: &Document, values: &[Value]) -> Option<Vec<Vec<f64>>> {
    let list = document.find(values.first()?.reference()?)?;
    let list = document.values(list);
    let all: Option<Vec<Vec<f64>>> =
        list.first()?.list().iter().map(|p| p.list().iter().map(Value::number).collect()).collect();
    let (all, mut points) = (all?, Vec::new());
    let segments = values.get(1).map_or(&[][..], Value::list);
    if segments.is_empty() {
        return Some(all);
    }
    for segment in segments {
        let Value::Typed(kind, inner) = segment else { return None };
        kind.eq_ignore_ascii_case(b"IFCLINEINDEX").then_some(())?;
        for number in inner.first()?.list() {
            let point = all.get((number.number()? as usize).checked_sub(1)?)?;
            join(&mut points, std::iter::once(point.clone()));
        }
    }
    Some(points)
}

fn composed(document: &Document, values: &[Value], depth: usize) -> Option<Polyline> {
    let mut line = Polyline { points: Vec::new(), is_even: true };
    for segment in values.first()?.list() {
        let segment = document.values_of(segment.reference()?, "IFCCOMPOSITECURVESEGMENT")?;
        let mut next = nested(document, segment.get(2)?.reference()?, depth)?;
        if segment.get(1)?.is("F") {
            next.points.reverse();
        }
        line.is_even &= next.is_even;
        join(&mut line.points, next.points.into_iter());
        (line.points.len() <= MAX_POINTS).then_some(())?;
    }
    Some(line)
}

/// A point that coincides with the last one is not repeated.
fn join(points: &mut Vec<Vec<f64>>, next: impl Iterator<Item = Vec<f64>>) {
    for (i, point) in next.enumerate() {
        if i > 0 || points.last() != Some(&point) {
            points.push(point);
        }
    }
}

fn cut(document: &Document, values: &[Value], depth: usize) -> Option<Vec<Vec<f64>>> {
    let basis = values.first()?.reference()?;
    if document.values_of(basis, "IFCLINE").is_none() {
        return trimmed(document, &nested(document, basis, depth)?, values);
    }
    // A straight line is told by the points at its ends.
    let end = |i: usize| document.coordinates(values.get(i)?.list().iter().find_map(Value::reference)?);
    let ends = [end(1)?, end(2)?];
    Some(ends.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Option<(usize, bool)> {
        line_of(&Document::new(text.as_bytes()), 9).map(|l| (l.points.len(), l.is_even))
    }

    #[test]
    fn lines_of_all_kinds() {
        let list = "#1=IFCCARTESIANPOINTLIST2D(((0.,0.),(5.,0.),(5.,5.),(0.,5.)));";
        let indexed = |segments: &str| points(&format!("{list}#9=IFCINDEXEDPOLYCURVE(#1,{segments},.F.);"));
        assert_eq!(indexed("$"), Some((4, true)));
        assert_eq!(indexed("(IFCLINEINDEX((1,2)),IFCLINEINDEX((2,3)))"), Some((3, true)));
        assert_eq!(indexed("(IFCLINEINDEX((1,2)),IFCARCINDEX((2,3,4)))"), None);
        assert_eq!(indexed("(IFCLINEINDEX((0,2)))"), None);
        let two = "#2=IFCINDEXEDPOLYCURVE(#1,$,.F.);#3=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#2);\
            #4=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.F.,#2);#9=IFCCOMPOSITECURVE((#3,#4),.F.);";
        assert_eq!(points(&format!("{list}{two}")), Some((7, true)));
        assert_eq!(points("#9=IFCCOMPOSITECURVE((#3),.F.);#3=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#9);"), None);
    }
}
