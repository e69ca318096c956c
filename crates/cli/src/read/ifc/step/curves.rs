//! Curves that the geometry library reads otherwise than meant: polylines that are trimmed, sweeps around corners.

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

fn points_of(document: &Document, polyline: u64) -> Option<Vec<Vec<f64>>> {
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

/// Sweeps along a line of more than one segment, told of the sweep's number: with parameters 0…1 the standard means
/// the first segment, though many who write it mean the whole; and around the corners the geometry library turns the
/// profile.
pub fn doubt_sweeps(document: &Document, notes: &mut Vec<(u64, String)>) {
    // Kind, and where directrix and start parameter stand.
    let kinds = [
        ("IFCSURFACECURVESWEPTAREASOLID", 2, 3),
        ("IFCFIXEDREFERENCESWEPTAREASOLID", 2, 3),
        ("IFCDIRECTRIXCURVESWEPTAREASOLID", 2, 3),
        ("IFCSWEPTDISKSOLID", 0, 3),
    ];
    for (keyword, directrix, start) in kinds {
        for record in document.all(keyword) {
            let values = document.values(record);
            let number = |i: usize| values.get(i).and_then(Value::number);
            let line = values.get(directrix).and_then(Value::reference);
            let segments = line.map_or(0, |id| segments(document, id));
            let is_first = number(start) == Some(0.0) && number(start + 1) == Some(1.0);
            let doubt = match (is_first, directrix) {
                _ if segments < 2 => continue,
                (true, _) => format!(
                    "its sweep is trimmed to the first of {segments} segments, as its parameters 0…1 say; if the whole \
                     is meant, leave the parameters out"
                ),
                // A disk has no direction that could turn.
                (false, 0) => continue,
                _ => {
                    format!("its sweep goes around the corners of {segments} segments: its profile may come out turned")
                }
            };
            notes.push((record.id, doubt));
        }
    }
}

fn segments(document: &Document, line: u64) -> usize {
    points_of(document, line).map_or(0, |p| p.len() - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rewritten(text: &str) -> (String, Vec<String>) {
        let document = Document::new(text.as_bytes());
        let (mut edits, mut notes) = (Edits::default(), Vec::new());
        write_out_trimmed(&document, &mut document.free_numbers(), &mut edits);
        doubt_sweeps(&document, &mut notes);
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
        assert!(sweep("0. /* a, b */,1.").1[0].contains("first of 2"));
        assert!(sweep("$,$").1[0].contains("corners of 2"));
        assert!(rewritten(&format!("{LINE}#9=IFCSWEPTDISKSOLID(#4,1.,$,$,$);")).1.is_empty());
    }
}
