//! Trimmed curves that the geometry library reads untrimmed: lines are written as what is left of them.

use super::document::{Document, Edits};
use super::line::{Polyline, line_of};
use super::profiles::polyline;
use super::value::Value;

/// A point nearer than this (as a fraction of the line's length) lies on the line.
const ON_LINE: f64 = 1e-4;

/// What the library does not trim.
const UNTRIMMED: [&str; 4] = ["IFCPOLYLINE", "IFCINDEXEDPOLYCURVE", "IFCCOMPOSITECURVE", "IFCTRIMMEDCURVE"];

/// Writes trimmed lines of any kind as the polylines that are left of them.
pub fn write_out_trimmed(
    document: &Document,
    free: &mut dyn Iterator<Item = u64>,
    edits: &mut Edits,
    notes: &mut Vec<(u64, String)>,
) {
    for record in document.all("IFCTRIMMEDCURVE") {
        let values = document.values(record);
        let Some(basis) = values.first().and_then(|v| document.find(v.reference()?)) else { continue };
        if !UNTRIMMED.iter().any(|keyword| document.is(basis, keyword)) {
            continue;
        }
        let Some(left) = line_of(document, basis.id).and_then(|line| trimmed(document, &line, &values)) else {
            notes.push((
                record.id,
                "one of its curves is trimmed in a way that is not clear: it may be drawn whole".into(),
            ));
            continue;
        };
        let Some((id, text)) = polyline(left.iter().map(Vec::as_slice), free) else { return };
        // The trimmed curve's own number becomes the polyline's.
        let text = text.replacen(&format!("\n#{id}="), &format!("#{}=", record.id), 1);
        edits.replace(record.span.clone(), text);
    }
}

/// The piece between both trims, in the curve's own direction.
pub fn trimmed(document: &Document, line: &Polyline, values: &[Value]) -> Option<Vec<Vec<f64>>> {
    let by_parameter = values.get(4)?.is("PARAMETER");
    let at = |trim: &Value| parameter(document, line, trim, by_parameter);
    let (mut from, mut to) = (at(values.get(1)?)?, at(values.get(2)?)?);
    // Against the sense of the line the trims come in the other order.
    let is_against = values.get(3)?.is("F");
    if is_against {
        std::mem::swap(&mut from, &mut to);
    }
    let mut left = (from < to).then(|| between(&line.points, from, to))?;
    if is_against {
        left.reverse();
    }
    Some(left)
}

/// From one parameter to another.
pub fn between(line: &[Vec<f64>], from: f64, to: f64) -> Vec<Vec<f64>> {
    let mut left = vec![point_at(line, from)];
    left.extend((0..line.len()).filter(|&i| from < i as f64 && (i as f64) < to).map(|i| line[i].clone()));
    left.push(point_at(line, to));
    left
}

/// Where a trim lies: the segment's number and the fraction of it.
fn parameter(document: &Document, line: &Polyline, trim: &Value, by_parameter: bool) -> Option<f64> {
    let number = trim.list().iter().find_map(Value::number);
    let point = trim.list().iter().find_map(Value::reference).and_then(|id| document.coordinates(id));
    let last = (line.points.len() - 1) as f64;
    let number = || number.filter(|_| line.is_even).map(|x| x.clamp(0.0, last));
    let projected = || point.as_ref().and_then(|p| project(&line.points, p));
    if by_parameter { number().or_else(projected) } else { projected().or_else(number) }
}

fn point_at(line: &[Vec<f64>], t: f64) -> Vec<f64> {
    let i = (t.floor() as usize).min(line.len() - 2);
    let part = t - i as f64;
    line[i].iter().zip(&line[i + 1]).map(|(a, b)| a + (b - a) * part).collect()
}

/// The nearest place of the line to a point, if it lies on it.
fn project(line: &[Vec<f64>], point: &[f64]) -> Option<f64> {
    let length: f64 = line.windows(2).map(|s| distance(&s[0], &s[1])).sum();
    let nearest = (0..line.len() - 1).map(|i| {
        let (a, b) = (&line[i], &line[i + 1]);
        let along: f64 = a.iter().zip(b).zip(point).map(|((a, b), p)| (b - a) * (p - a)).sum();
        let square = distance(a, b).powi(2);
        let part = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
        let t = i as f64 + part;
        (distance(&point_at(line, t), point), t)
    });
    let (off, t) = nearest.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (point.len() == line[0].len() && off <= ON_LINE * length).then_some(t)
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rewritten(text: &str) -> (String, Vec<String>) {
        let document = Document::new(text.as_bytes());
        let (mut edits, mut notes) = (Edits::default(), Vec::new());
        write_out_trimmed(&document, &mut document.free_numbers(), &mut edits, &mut notes);
        (String::from_utf8(edits.apply(text.as_bytes())).unwrap(), notes.into_iter().map(|n| n.1).collect())
    }

    const LINE: &str = "#1=IFCCARTESIANPOINT((0.,0.));#2=IFCCARTESIANPOINT((5.,0.));#3=IFCCARTESIANPOINT((5.,5.));\
        #4=IFCPOLYLINE((#1,#2,#3));#5=IFCCARTESIANPOINT((5.,2.5));";

    #[test]
    fn a_polyline_ends_where_it_is_trimmed() {
        let points = |trims: &str| {
            let (text, _) = rewritten(&format!("{LINE}#9=IFCTRIMMEDCURVE(#4,{trims});"));
            let at = text.find("#9=").unwrap();
            let (_, new) = text[at..].split_once('\n').unwrap_or_default();
            new.split("IFCCARTESIANPOINT").skip(1).map(|p| p.split(';').next().unwrap().to_owned()).collect::<Vec<_>>()
        };
        let forth = ["((0.0,0.0))", "((5.0,0.0))", "((5.0,2.5))"];
        assert_eq!(points("(#1),(#5),.T.,.CARTESIAN."), forth);
        assert_eq!(points("(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(1.5)),.T.,.PARAMETER."), forth);
        assert_eq!(points("(#5),(#1),.F.,.CARTESIAN."), ["((5.0,2.5))", "((5.0,0.0))", "((0.0,0.0))"]);
        assert_eq!(points("(#5,IFCPARAMETERVALUE(0.5)),(#3),.T.,.PARAMETER.").len(), 3);
    }
}
