//! Curves that the geometry library reads otherwise than meant: polylines and sweeps that are trimmed.

use super::document::{Document, Edits};
use super::profiles::polyline;
use super::value::Value;

/// Nearer than this (of the line's length) a point lies on the line.
const ON_LINE: f64 = 1e-4;

/// Writes trimmed polylines as the polylines that are left of them.
pub fn write_out_trimmed(document: &Document, free: &mut dyn Iterator<Item = u64>, edits: &mut Edits) {
    for record in document.all("IFCTRIMMEDCURVE") {
        let values = document.values(record);
        let Some(line) = values.first().and_then(|v| points_of(document, v.reference()?)) else { continue };
        let Some(left) = trimmed(document, &line, &values) else { continue };
        let Some((id, text)) = polyline(left.iter().map(Vec::as_slice), free) else { return };
        // The trimmed curve's own number becomes the polyline's.
        let text = text.replacen(&format!("\n#{id}="), &format!("#{}=", record.id), 1);
        edits.replace(record.span.clone(), text);
    }
}

pub fn points_of(document: &Document, polyline: u64) -> Option<Vec<Vec<f64>>> {
    let values = document.values_of(polyline, "IFCPOLYLINE")?;
    let points: Option<Vec<_>> = values.first()?.list().iter().map(|v| document.coordinates(v.reference()?)).collect();
    points.filter(|p| p.len() >= 2 && p.iter().all(|q| q.len() == p[0].len()))
}

/// The piece between both trims, in the curve's own sense.
fn trimmed(document: &Document, line: &[Vec<f64>], values: &[Value]) -> Option<Vec<Vec<f64>>> {
    let by_parameter = values.get(4)?.is("PARAMETER");
    let at = |trim: &Value| parameter(document, line, trim, by_parameter);
    let (mut from, mut to) = (at(values.get(1)?)?, at(values.get(2)?)?);
    // Against the sense of the line the trims come in the other order.
    let is_against = values.get(3)?.is("F");
    if is_against {
        std::mem::swap(&mut from, &mut to);
    }
    let mut left = vec![point_at(line, from)];
    left.extend((0..line.len()).filter(|&i| from < i as f64 && (i as f64) < to).map(|i| line[i].clone()));
    left.push(point_at(line, to));
    if is_against {
        left.reverse();
    }
    (from < to).then_some(left)
}

/// Where a trim lies: the segment's number and the part of it.
fn parameter(document: &Document, line: &[Vec<f64>], trim: &Value, by_parameter: bool) -> Option<f64> {
    let number = trim.list().iter().find_map(Value::number);
    let point = trim.list().iter().find_map(Value::reference).and_then(|id| document.coordinates(id));
    let number = || number.map(|x| x.clamp(0.0, (line.len() - 1) as f64));
    let projected = || point.as_ref().and_then(|p| project(line, p));
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

/// Sweeps whose parameters are 0…1 although their line has more than one segment: the standard means the first,
/// those who write it mean the whole, and so it is taken. What is trimmed otherwise is told.
pub fn take_whole(document: &Document, edits: &mut Edits, notes: &mut Vec<(u64, String)>) {
    // Kind, and where directrix and start parameter stand.
    let kinds = [
        ("IFCSURFACECURVESWEPTAREASOLID", 2, 3),
        ("IFCFIXEDREFERENCESWEPTAREASOLID", 2, 3),
        ("IFCSWEPTDISKSOLID", 0, 3),
        ("IFCSWEPTDISKSOLIDPOLYGONAL", 0, 3),
    ];
    for (keyword, directrix, start) in kinds {
        for record in document.all(keyword) {
            let values = document.values(record);
            let number = |i: usize| values.get(i).and_then(Value::number);
            let line = values.get(directrix).and_then(Value::reference);
            let (segments, is_line) = line.map_or((0, false), |id| segments(document, id));
            let told = match (number(start), number(start + 1)) {
                _ if segments < 2 => continue,
                (Some(0.0), Some(1.0)) => {
                    let pieces = document.argument_pieces(record);
                    for piece in pieces.into_iter().skip(start).take(2) {
                        edits.replace(piece, "$");
                    }
                    format!(
                        "its parameters 0…1 would keep the first of {segments} segments; the whole was taken, as most \
                         who write them mean it"
                    )
                }
                (from, to) if is_line && (from > Some(0.0) || to.is_some_and(|to| to < segments as f64)) => {
                    let (from, to) = (from.unwrap_or(0.0), to.unwrap_or(segments as f64));
                    format!("its parameters {from}…{to} keep a part of its {segments} segments")
                }
                _ => continue,
            };
            notes.push((record.id, told));
        }
    }
}

/// How many there are, and whether they are a polyline's.
fn segments(document: &Document, line: u64) -> (usize, bool) {
    if let Some(points) = points_of(document, line) {
        return (points.len() - 1, true);
    }
    let composite = document.values_of(line, "IFCCOMPOSITECURVE");
    (composite.and_then(|v| Some(v.first()?.list().len())).unwrap_or(0), false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rewritten(text: &str) -> (String, Vec<String>) {
        let document = Document::new(text.as_bytes());
        let (mut edits, mut notes) = (Edits::default(), Vec::new());
        write_out_trimmed(&document, &mut document.free_numbers(), &mut edits);
        take_whole(&document, &mut edits, &mut notes);
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

    #[test]
    fn parameters_of_a_sweep() {
        let sweep = |rest: &str| rewritten(&format!("{LINE}#9=IFCSURFACECURVESWEPTAREASOLID(#6,$,#4,{rest},#8);"));
        let (text, said) = sweep("0. /* a, b */,1.");
        assert!(text.contains("(#6,$,#4,$,$,#8)") && said[0].contains("first of 2"), "{text}");
        assert!(sweep("$,$").1.is_empty() && sweep("0.,2.").1.is_empty());
        assert!(sweep("0.,1.5").1[0].contains("0…1.5 keep a part"));
    }
}
