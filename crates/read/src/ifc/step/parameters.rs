//! The parameters of sweeps: which part of the line is meant where the geometry library does not know.

use super::document::{Document, Edits};
use super::line::line_of;
use super::profiles::polyline;
use super::record::Record;
use super::value::{Value, real};

/// Kind, and the positions of directrix and start parameter.
const KINDS: [(&str, usize, usize); 4] = [
    ("IFCSURFACECURVESWEPTAREASOLID", 2, 3),
    ("IFCFIXEDREFERENCESWEPTAREASOLID", 2, 3),
    ("IFCSWEPTDISKSOLID", 0, 3),
    ("IFCSWEPTDISKSOLIDPOLYGONAL", 0, 3),
];

/// Parameters 0…1 of several segments mean the first segment by the standard, but the whole line to those who write
/// them; the whole line is taken. Other trims are reported, and written out where the library would draw the whole.
pub fn take(
    document: &Document,
    free: &mut dyn Iterator<Item = u64>,
    edits: &mut Edits,
    notes: &mut Vec<(u64, String)>,
) {
    for (keyword, directrix, start) in KINDS {
        for record in document.all(keyword) {
            let values = document.values(record);
            let ends = [start, start + 1].map(|i| values.get(i).and_then(Value::number));
            let Some(id) = values.get(directrix).and_then(Value::reference) else { continue };
            if ends == [None, None] {
                continue;
            }
            let Some(meant) = Meant::read(document, id, ends) else { continue };
            notes.push((record.id, meant.note));
            meant.part.write(document, record, [directrix, start], free, edits);
        }
    }
}

/// What is meant, and why the user is told.
struct Meant {
    part: Part,
    note: String,
}

enum Part {
    /// The line as the library reads it.
    AsWritten,
    Whole,
    Points(Vec<Vec<f64>>),
    /// A basis curve from one parameter to another.
    Trimmed(u64, [f64; 2]),
}

impl Meant {
    fn read(document: &Document, directrix: u64, ends: [Option<f64>; 2]) -> Option<Self> {
        let trimmed = document.values_of(directrix, "IFCTRIMMEDCURVE");
        let basis = trimmed.as_ref().and_then(|t| t.first()?.reference());
        let is_smooth = |id: u64| ["IFCCIRCLE", "IFCELLIPSE", "IFCLINE"].iter().any(|k| is(document, id, k));
        match (trimmed, basis.filter(|&id| is_smooth(id))) {
            (Some(trims), Some(basis)) => Self::of_arc(&trims, basis, ends),
            _ => Self::of_segments(document, directrix, ends),
        }
    }

    fn of_segments(document: &Document, directrix: u64, ends: [Option<f64>; 2]) -> Option<Self> {
        let line = line_of(document, directrix);
        let is_indexed = is(document, directrix, "IFCINDEXEDPOLYCURVE");
        let is_composite = is(document, directrix, "IFCCOMPOSITECURVE");
        let count = match &line {
            Some(line) if !is_composite => line.points.len() - 1,
            _ => listed(document, directrix, usize::from(is_indexed)),
        };
        if ends == [Some(0.0), Some(1.0)] && count > 1 {
            return Some(Self::whole(&format!("the first of {count} segments")));
        }
        let [from, to] = [ends[0].unwrap_or(0.0), ends[1].unwrap_or(count as f64)];
        let is_part = from > 0.0 || to < count as f64;
        let note = format!("its parameters {from}…{to} keep a part of its {count} segments");
        match line {
            Some(line) if is_indexed && is_part => {
                let to = to.min(count as f64);
                let left = (from < to).then(|| super::curves::between(&line.points, from.max(0.0), to))?;
                Some(Self { part: Part::Points(left), note })
            }
            Some(_) if !is_composite && is_part && count > 1 => Some(Self { part: Part::AsWritten, note }),
            None if is_indexed => Some(Self::lost(from, to)),
            _ => None,
        }
    }

    /// Its parameters count from its start in the unit of its trims; where those begin at zero, both agree.
    fn of_arc(trims: &[Value], basis: u64, ends: [Option<f64>; 2]) -> Option<Self> {
        let number = |i: usize| trims.get(i)?.list().iter().find_map(Value::number);
        let is_forth = trims.get(3).is_some_and(|v| v.is("T"));
        let range = number(1).zip(number(2)).filter(|(a, b)| a < b && is_forth);
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b.abs().max(1.0);
        let Some((first, last)) = range else {
            let [from, to] = [ends[0].unwrap_or(0.0), ends[1].unwrap_or(f64::INFINITY)];
            return Some(if ends == [Some(0.0), Some(1.0)] {
                Self::whole("a part of its curve")
            } else {
                Self::lost(from, to)
            });
        };
        let [from, to] = [ends[0].unwrap_or(0.0), ends[1].unwrap_or(last - first)];
        if (near(from, 0.0) && near(to, last - first)) || (near(from, first) && near(to, last)) {
            return None;
        }
        if ends == [Some(0.0), Some(1.0)] {
            return Some(Self::whole("a part of its curve"));
        }
        let is_clear = near(first, 0.0) && 0.0 <= from && from < to && to <= last;
        let note = format!("its parameters {from}…{to} keep a part of its curve");
        let clear = Self { part: Part::Trimmed(basis, [from, to]), note };
        Some(if is_clear { clear } else { Self::lost(from, to) })
    }

    fn whole(instead_of: &str) -> Self {
        let note =
            format!("its parameters 0…1 would keep {instead_of}; the whole was taken, as most who write them mean it");
        Self { part: Part::Whole, note }
    }

    fn lost(from: f64, to: f64) -> Self {
        let to = if to.is_finite() { to.to_string() } else { "its end".into() };
        let note = format!("its parameters {from}…{to} are not clear: it follows the whole of its curve");
        Self { part: Part::Whole, note }
    }
}

impl Part {
    fn write(
        self,
        document: &Document,
        record: &Record,
        [directrix, start]: [usize; 2],
        free: &mut dyn Iterator<Item = u64>,
        edits: &mut Edits,
    ) {
        let written = match self {
            Self::AsWritten => return,
            Self::Whole => None,
            Self::Points(points) => polyline(points.iter().map(Vec::as_slice), free),
            Self::Trimmed(basis, ends) => free.next().map(|id| {
                let [from, to] = ends.map(|x| format!("(IFCPARAMETERVALUE({}))", real(x)));
                (id, format!("\n#{id}=IFCTRIMMEDCURVE(#{basis},{from},{to},.T.,.PARAMETER.);"))
            }),
        };
        let pieces = document.argument_pieces(record);
        for piece in pieces.iter().skip(start).take(2) {
            edits.replace(piece.clone(), "$");
        }
        if let Some((id, text)) = written {
            edits.replace(pieces[directrix].clone(), format!("#{id}"));
            edits.replace(record.span.end..record.span.end, text);
        }
    }
}

fn is(document: &Document, id: u64, keyword: &str) -> bool {
    document.find(id).is_some_and(|r| document.is(r, keyword))
}

/// How many segments are listed in an argument of a curve.
fn listed(document: &Document, curve: u64, slot: usize) -> usize {
    let values = document.find(curve).map(|r| document.values(r)).unwrap_or_default();
    values.get(slot).map_or(0, |v| v.list().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swept(records: &str, directrix: &str, ends: &str) -> (String, Vec<String>) {
        let text = format!("{records}#9=IFCSURFACECURVESWEPTAREASOLID(#6,$,{directrix},{ends},#8);");
        let document = Document::new(text.as_bytes());
        let (mut edits, mut notes) = (Edits::default(), Vec::new());
        take(&document, &mut document.free_numbers(), &mut edits, &mut notes);
        (String::from_utf8(edits.apply(text.as_bytes())).unwrap(), notes.into_iter().map(|n| n.1).collect())
    }

    #[test]
    fn of_lines() {
        let points = "#1=IFCCARTESIANPOINT((0.,0.));#2=IFCCARTESIANPOINT((5.,0.));#3=IFCCARTESIANPOINT((5.,5.));\
            #4=IFCPOLYLINE((#1,#2,#3));";
        let (text, said) = swept(points, "#4", "0. /* a, b */,1.");
        assert!(text.contains("(#6,$,#4,$,$,#8)") && said[0].contains("first of 2"), "{text}");
        assert!(swept(points, "#4", "$,$").1.is_empty() && swept(points, "#4", "0.,2.").1.is_empty());
        assert!(swept(points, "#4", "0.,1.5").1[0].contains("0…1.5 keep a part"));
        let list = "#1=IFCCARTESIANPOINTLIST2D(((0.,0.),(5.,0.),(5.,5.)));#4=IFCINDEXEDPOLYCURVE(#1,$,.F.);";
        let (text, said) = swept(list, "#4", "1.,2.");
        assert!(text.contains("(#6,$,#10,$,$,#8);\n#10=IFCPOLYLINE") && said[0].contains("1…2 keep"), "{text}");
        assert!(swept(list, "#4", "0.,2.").1.is_empty());
    }

    #[test]
    fn of_arcs() {
        let arc = "#3=IFCCIRCLE(#2,5.);\
            #4=IFCTRIMMEDCURVE(#3,(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(180.)),.T.,.PARAMETER.);";
        let (text, said) = swept(arc, "#4", "0.,90.");
        assert!(text.contains("#10=IFCTRIMMEDCURVE(#3,(IFCPARAMETERVALUE(0.0)),(IFCPARAMETERVALUE(90.0))"), "{text}");
        assert!(said[0].contains("keep a part") && swept(arc, "#4", "0.,180.").1.is_empty());
        assert!(swept(arc, "#4", "0.,1.").1[0].contains("whole was taken"));
        assert!(swept(&arc.replace("(0.)", "(20.)"), "#4", "30.,90.").1[0].contains("not clear"));
    }
}
