//! Profiles drawn by many short edges: the geometry library takes them for smooth curves and thins them out by up to 10
//! mm, more than many a tolerance. Here they are thinned by less; drawn larger, and scaled down again by an operator,
//! they are left alone by the library.

use std::borrow::Cow;
use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::document::{Document, Edits};
use super::library::Library;
use super::line::points_of;
use super::profiles::{CIRCLE_CORNERS, ELLIPSE_CORNERS, ellipse, placed, polyline};
use super::record::Record;
use super::units::project_metres;
use super::value::{Value, real};

/// The factor of enlargement: a power of two, which changes no digit.
const LARGER: f64 = (1u64 << 20) as f64;
/// The library's own bounds: profiles with fewer points, or with longer edges as fractions of the diagonal, are left
/// alone.
const FEWEST_POINTS: usize = 24;
const LONGEST_MEAN: f64 = 1.0 / 16.0;
const LONGEST: f64 = 0.10;
/// By how much a boundary may be off, metres; more for openings, where every corner makes the cut slower.
const OFF_M: f64 = 2e-4;
const OFF_OF_OPENINGS_M: f64 = 2e-3;
/// Profiles of more points than this are left alone.
const MAX_POINTS: usize = 4096;

const KINDS: [&str; 2] = ["IFCARBITRARYCLOSEDPROFILEDEF", "IFCARBITRARYPROFILEDEFWITHVOIDS"];

pub fn is_needed(document: &Document) -> bool {
    let is_candidate = |record| curves(document, record).iter().any(|&id| may_be_dense(document, id));
    KINDS.iter().any(|keyword| document.all(keyword).any(is_candidate))
}

pub fn keep(text: Cow<'_, [u8]>, angle: Option<f64>) -> Cow<'_, [u8]> {
    let document = Document::new(&text);
    let mut free = document.free_numbers();
    let (mut edits, mut library) = (Edits::default(), None);
    let metres = project_metres(&document).unwrap_or(1.0);
    let mut of_openings = None;
    for keyword in KINDS {
        for record in document.all(keyword) {
            let curves = curves(&document, record);
            if !curves.iter().any(|&id| may_be_dense(&document, id)) {
                continue;
            }
            let mut read = |id: u64| {
                let library = library.get_or_insert_with(|| Library::new(&text, angle));
                boundary(&document, library, id)
            };
            // The library's panics cost their own profile alone.
            let all = || curves.iter().map(|&id| read(id)).collect::<Option<Vec<_>>>();
            let Some(boundaries) = catch_unwind(AssertUnwindSafe(all)).ok().flatten() else { continue };
            if !boundaries.iter().any(|b| is_dense(b)) {
                continue;
            }
            let of_openings = of_openings.get_or_insert_with(|| shapes_of_openings(&document));
            let off = if of_openings.contains(&record.id) { OFF_OF_OPENINGS_M } else { OFF_M } / metres;
            let left: Vec<Boundary> = boundaries.iter().map(|b| thinned(b, off)).collect();
            write(record, &left, &mut free, &mut edits);
        }
    }
    drop(library);
    if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) }
}

/// The outer boundary and the holes of an area; a profile of another kind has none.
fn curves(document: &Document, record: &Record) -> Vec<u64> {
    let values = document.values(record);
    if !values.first().is_some_and(|kind| kind.is("AREA")) {
        return Vec::new();
    }
    let holes = values.get(3).map_or(&[][..], Value::list);
    values.get(2).into_iter().chain(holes).filter_map(Value::reference).collect()
}

fn may_be_dense(document: &Document, curve: u64) -> bool {
    let Some(line) = document.values_of(curve, "IFCPOLYLINE") else { return document.find(curve).is_some() };
    line.first().is_some_and(|points| points.list().len() >= FEWEST_POINTS)
}

type Boundary = Vec<[f64; 2]>;

/// The points of a closed curve, with the first not repeated.
pub fn boundary(document: &Document, library: &mut Library, id: u64) -> Option<Boundary> {
    let mut points: Boundary = if let Some(points) = points_of(document, id) {
        points.iter().map(|p| p.first_chunk().copied()).collect::<Option<_>>()?
    } else if let Some(round) = round(document, id) {
        round
    } else {
        let curve = library.decoder.decode_by_id(u32::try_from(id).ok()?).ok()?;
        library.curve(&curve, [None, None])?.iter().map(|p| [p.x, p.y]).collect()
    };
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let is_sound = points.len() >= 3 && points.len() <= MAX_POINTS && points.iter().flatten().all(|c| c.is_finite());
    is_sound.then_some(points)
}

/// A whole circle or ellipse.
fn round(document: &Document, id: u64) -> Option<Boundary> {
    let numbers = |v: &[Value], slots: [usize; 2]| Some([v.get(slots[0])?.number()?, v.get(slots[1])?.number()?]);
    if let Some(circle) = document.values_of(id, "IFCCIRCLE") {
        return placed(document, circle.first()?, ellipse(&numbers(&circle, [1, 1])?, CIRCLE_CORNERS)?);
    }
    let v = document.values_of(id, "IFCELLIPSE")?;
    placed(document, v.first()?, ellipse(&numbers(&v, [1, 2])?, ELLIPSE_CORNERS)?)
}

fn is_dense(points: &[[f64; 2]]) -> bool {
    let n = points.len();
    let edges = (0..n).map(|i| (points[i], points[(i + 1) % n])).map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
    let (sum, longest) = edges.fold((0.0, 0.0f64), |(sum, longest), e| (sum + e, longest.max(e)));
    let extent = [0, 1].map(|k| {
        let of = || points.iter().map(|p| p[k]);
        of().fold(f64::MIN, f64::max) - of().fold(f64::MAX, f64::min)
    });
    let diagonal = extent[0].hypot(extent[1]);
    n >= FEWEST_POINTS && sum / n as f64 <= LONGEST_MEAN * diagonal && longest <= LONGEST * diagonal
}

/// The records that openings are made of.
fn shapes_of_openings(document: &Document) -> HashSet<u64> {
    const REPRESENTATION: usize = 6;
    let mut open: Vec<u64> = Vec::new();
    for keyword in ["IFCOPENINGELEMENT", "IFCOPENINGSTANDARDCASE"] {
        let shape = |record| document.values(record).get(REPRESENTATION).and_then(Value::reference);
        open.extend(document.all(keyword).filter_map(shape));
    }
    let mut seen = HashSet::new();
    while let Some(id) = open.pop() {
        if let Some(record) = document.find(id).filter(|_| seen.insert(id)) {
            open.extend(document.references_of(record));
        }
    }
    seen
}

/// The polygon without points nearer than `off` to the remaining edges.
fn thinned(points: &[[f64; 2]], off: f64) -> Boundary {
    let n = points.len();
    let is_near = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
        let [[dx, dy], [x, y]] = [b, p].map(|q| [q[0] - a[0], q[1] - a[1]]);
        let length = dx.hypot(dy);
        let along = if length > 0.0 { (x * dx + y * dy) / length } else { f64::INFINITY };
        (0.0..=length).contains(&along) && (x * dy - y * dx).abs() <= off * length
    };
    let mut left = vec![points[0]];
    let mut from = 0;
    while from < n {
        let skips = |to: &usize| (from + 1..*to).all(|i| is_near(points[from], points[*to % n], points[i]));
        let to = (from + 2..=n).take_while(skips).last().unwrap_or(from + 1);
        if to < n {
            left.push(points[to]);
        }
        from = to;
    }
    if left.len() >= 3 { left } else { points.to_vec() }
}

fn write(record: &Record, boundaries: &[Boundary], free: &mut dyn Iterator<Item = u64>, edits: &mut Edits) {
    let (mut lines, mut texts) = (Vec::new(), String::new());
    for boundary in boundaries {
        let larger: Vec<[f64; 2]> = boundary.iter().chain(boundary.first()).map(|p| p.map(|c| c * LARGER)).collect();
        let Some((line, text)) = polyline(larger.iter().map(|p| &p[..]), free) else { return };
        lines.push(format!("#{line}"));
        texts += &text;
    }
    let [Some(parent), Some(operator), Some(zero)] = [free.next(), free.next(), free.next()] else { return };
    let profile = match &lines[..] {
        [outer] => format!("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,{outer})"),
        [outer, holes @ ..] => format!("IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,{outer},({}))", holes.join(",")),
        [] => return,
    };
    let (id, smaller) = (record.id, real(1.0 / LARGER));
    let text = format!(
        "#{id}=IFCDERIVEDPROFILEDEF(.AREA.,$,#{parent},#{operator},$);\n#{parent}={profile};\n\
         #{operator}=IFCCARTESIANTRANSFORMATIONOPERATOR2D($,$,#{zero},{smaller});\n\
         #{zero}=IFCCARTESIANPOINT((0.,0.));{texts}"
    );
    edits.replace(record.span.clone(), text);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(text: &str) -> String {
        String::from_utf8(keep(Cow::Borrowed(text.as_bytes()), None).into_owned()).unwrap()
    }

    #[test]
    fn dense_boundaries_are_drawn_larger() {
        let place = "#2=IFCCARTESIANPOINT((3.,4.));#3=IFCAXIS2PLACEMENT2D(#2,$);#4=IFCCIRCLE(#3,0.5);";
        let text = kept(&format!("#1=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#4);{place}"));
        assert!(text.starts_with("#1=IFCDERIVEDPROFILEDEF(.AREA.,$,#43,#44,$);"), "{text}");
        let first = format!("(({:?},{:?}))", 3.5 * LARGER, 4.0 * LARGER);
        assert!(text.contains(&first) && text.contains(&real(1.0 / LARGER)));
        let with_hole = format!("#1=IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#9,(#4));{place}");
        let square = "#5=IFCCARTESIANPOINT((0.,0.));#6=IFCCARTESIANPOINT((9.,0.));#7=IFCCARTESIANPOINT((9.,9.));\
            #9=IFCPOLYLINE((#5,#6,#7,#5));";
        assert!(kept(&format!("{with_hole}{square}")).contains("VOIDS(.AREA.,$,#10,(#15))"), "the hole");
    }

    #[test]
    fn thinned_by_no_more_than_told() {
        let circle: Boundary = ellipse(&[0.5, 0.5], 1000).unwrap();
        for off in [2e-4, 2e-3] {
            let left = thinned(&circle, off);
            // The sagitta of a chord is r (1 − cos(π/n)).
            let sagitta = 0.5 * (1.0 - (std::f64::consts::PI / left.len() as f64).cos());
            assert!(sagitta <= off * 1.01 && sagitta > 0.8 * off, "{}: {sagitta}", left.len());
        }
        let bent = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(thinned(&bent, 1e-3), bent);
    }

    #[test]
    fn others_stay_as_they_are() {
        let square = "#1=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#5);#5=IFCPOLYLINE((#6,#7,#8,#6));";
        assert_eq!(kept(square), square);
        let open = "#1=IFCARBITRARYCLOSEDPROFILEDEF(.CURVE.,$,#4);#4=IFCCIRCLE(#3,0.5);";
        assert_eq!(kept(open), open);
    }
}
