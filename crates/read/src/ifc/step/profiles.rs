//! Profiles that the geometry library does not know, or draws differently from the standard: written out as polygons.

use super::document::{Document, Edits};
use super::record::Record;
use super::value::{Value, real};

/// A point of a profile, in the file's unit.
pub type ProfilePoint = [f64; 2];

/// Draws a profile from its numbers.
pub type Outline = fn(&[f64]) -> Option<Vec<ProfilePoint>>;

/// Corners of an ellipse: its area comes out 0.04 % short.
pub const ELLIPSE_CORNERS: usize = 128;
/// Corners of a circle, as the geometry library draws it.
pub const CIRCLE_CORNERS: usize = 36;
/// Steps of a rounded corner.
const FILLET_STEPS: usize = 6;

/// Writes out the ellipses, trapezia and Z shapes.
pub fn write_out(document: &Document, free: &mut dyn Iterator<Item = u64>, edits: &mut Edits) {
    let kinds: [(&str, Outline); 3] = [
        ("IFCELLIPSEPROFILEDEF", |n| ellipse(n.first_chunk()?, ELLIPSE_CORNERS)),
        ("IFCTRAPEZIUMPROFILEDEF", |n| trapezium(n.first_chunk()?)),
        ("IFCZSHAPEPROFILEDEF", |n| z_shape(n)),
    ];
    for (keyword, outline) in kinds {
        for record in document.all(keyword) {
            let values = document.values(record);
            let numbers: Vec<f64> = values.iter().skip(3).map(|v| v.number().unwrap_or(0.0)).collect();
            let outline = outline(&numbers).and_then(|o| placed(document, values.get(2)?, o));
            if let Some(outline) = outline.filter(|o| o.iter().flatten().all(|x| x.is_finite())) {
                write(document, record, &values, &outline, free, edits);
            }
        }
    }
}

pub fn ellipse(&[a, b]: &[f64; 2], corners: usize) -> Option<Vec<ProfilePoint>> {
    let at = |i: usize| (std::f64::consts::TAU * i as f64 / corners as f64).sin_cos();
    (a > 0.0 && b > 0.0).then(|| (0..corners).map(at).map(|(sin, cos)| [a * cos, b * sin]).collect())
}

/// Its box is centred below; `offset` is from the bottom's left end to the top's.
fn trapezium(&[bottom, top, depth, offset]: &[f64; 4]) -> Option<Vec<ProfilePoint>> {
    let (left, y) = (-bottom / 2.0, depth / 2.0);
    let corners = [[left, -y], [-left, -y], [left + offset + top, y], [left + offset, y]];
    (bottom > 0.0 && top > 0.0 && depth > 0.0).then(|| corners.to_vec())
}

/// Depth, width of a flange from the web's far face, thickness of web and flanges, fillet, edge: 2 · width − web wide.
fn z_shape(numbers: &[f64]) -> Option<Vec<ProfilePoint>> {
    let &[depth, width, web, flange] = numbers.first_chunk()?;
    let radius = |i: usize| numbers.get(i).copied().unwrap_or(0.0).max(0.0);
    let (y, w, x) = (depth / 2.0, web / 2.0, width - web / 2.0);
    let (fillet, edge) = (radius(4), radius(5));
    let is_sound = web > 0.0 && flange > 0.0 && x > w && 2.0 * flange < depth;
    let half = [([-w, -y], 0.0), ([x, -y], 0.0), ([x, flange - y], edge), ([w, flange - y], fillet)];
    let all: Vec<(ProfilePoint, f64)> =
        half.into_iter().chain(half.map(|([x, y], radius)| ([-x, -y], radius))).collect();
    is_sound.then(|| rounded(&all))
}

/// A polygon with rounded corners; a radius that does not fit between its neighbours is left out.
pub fn rounded(corners: &[(ProfilePoint, f64)]) -> Vec<ProfilePoint> {
    let n = corners.len();
    let mut out = Vec::new();
    for i in 0..n {
        let (corner, radius) = corners[i];
        let towards = |to: ProfilePoint| {
            let d = [to[0] - corner[0], to[1] - corner[1]];
            let length = d[0].hypot(d[1]);
            (d.map(|c| c / length), length)
        };
        let ((a, to_a), (b, to_b)) = (towards(corners[(i + n - 1) % n].0), towards(corners[(i + 1) % n].0));
        if radius <= 0.0 || radius >= to_a.min(to_b) {
            out.push(corner);
            continue;
        }
        // All corners of these profiles are right angles.
        let centre = [0, 1].map(|k| corner[k] + radius * (a[k] + b[k]));
        out.extend((0..=FILLET_STEPS).map(|step| {
            let (sin, cos) = (std::f64::consts::FRAC_PI_2 * step as f64 / FILLET_STEPS as f64).sin_cos();
            [0, 1].map(|k| centre[k] - radius * (b[k] * cos + a[k] * sin))
        }));
    }
    out
}

/// Moved by an IfcAxis2Placement2D, if there is one.
pub fn placed(document: &Document, position: &Value, outline: Vec<ProfilePoint>) -> Option<Vec<ProfilePoint>> {
    let Some(id) = position.reference() else { return Some(outline) };
    let placement = document.values_of(id, "IFCAXIS2PLACEMENT2D")?;
    let &[x, y] = document.coordinates(placement.first()?.reference()?)?.first_chunk()?;
    let axis = placement.get(1).and_then(Value::reference).and_then(|id| document.coordinates(id));
    let axis = axis.and_then(|a| a.first_chunk().copied()).unwrap_or([1.0, 0.0]);
    let length = axis[0].hypot(axis[1]);
    let [cos, sin] = if length > 0.0 { axis.map(|c| c / length) } else { [1.0, 0.0] };
    Some(outline.into_iter().map(|[u, v]| [x + cos * u - sin * v, y + sin * u + cos * v]).collect())
}

pub fn write(
    document: &Document,
    record: &Record,
    values: &[Value],
    outline: &[ProfilePoint],
    free: &mut dyn Iterator<Item = u64>,
    edits: &mut Edits,
) {
    let kind = if values[0].is("CURVE") { "CURVE" } else { "AREA" };
    let Some((line, points)) = closed(outline, free) else { return };
    let id = record.id;
    let text = format!("#{id}=IFCARBITRARYCLOSEDPROFILEDEF(.{kind}.,$,#{line});{points}");
    debug_assert!(document.find(line).is_none());
    edits.replace(record.span.clone(), text);
}

/// The records of a polyline that ends where it begins.
pub fn closed(outline: &[ProfilePoint], free: &mut dyn Iterator<Item = u64>) -> Option<(u64, String)> {
    polyline(outline.iter().chain(outline.first()).map(<[f64; 2]>::as_slice), free)
}

/// The signed area: positive counter-clockwise, negative clockwise.
pub fn area(outline: &[ProfilePoint]) -> f64 {
    let n = outline.len();
    (0..n).map(|i| (outline[i], outline[(i + 1) % n])).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
}

/// The records of a polyline: its number, and the text of it and its points.
pub fn polyline<'p>(
    points: impl Iterator<Item = &'p [f64]>,
    free: &mut dyn Iterator<Item = u64>,
) -> Option<(u64, String)> {
    let line = free.next()?;
    let (mut ids, mut text) = (Vec::new(), String::new());
    for point in points {
        let id = free.next()?;
        let numbers: Vec<String> = point.iter().copied().map(real).collect();
        text += &format!("\n#{id}=IFCCARTESIANPOINT(({}));", numbers.join(","));
        ids.push(format!("#{id}"));
    }
    Some((line, format!("\n#{line}=IFCPOLYLINE(({}));{text}", ids.join(","))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_and_widths() {
        assert!(
            (area(&ellipse(&[0.8, 0.2], ELLIPSE_CORNERS).unwrap()) / (std::f64::consts::PI * 0.16) - 1.0).abs() < 5e-4
        );
        assert!((area(&trapezium(&[1.0, 0.6, 0.5, 0.2]).unwrap()) - 0.4).abs() < 1e-12);
        let z = z_shape(&[0.2, 0.1, 0.01, 0.02]).unwrap();
        assert!((area(&z) - (2.0 * 0.1 * 0.02 + 0.16 * 0.01)).abs() < 1e-12);
        assert_eq!(z.iter().map(|p| p[0]).fold(0.0, f64::max), 0.095);
        let soft = z_shape(&[0.2, 0.1, 0.01, 0.02, 0.01, 0.005]).unwrap();
        // A fillet adds, an edge takes away, (1 − π/4) r² each.
        let spared = 2.0 * (1.0 - std::f64::consts::FRAC_PI_4) * (0.01f64.powi(2) - 0.005f64.powi(2));
        assert!((area(&soft) - area(&z) - spared).abs() < 0.05 * spared);
        assert!(z_shape(&[0.2, 0.1, 0.01]).is_none() && ellipse(&[0.0, 1.0], 36).is_none());
    }

    #[test]
    fn written_where_it_lies() {
        let text = b"#1=IFCTRAPEZIUMPROFILEDEF(.AREA.,'x;',#2,2.,2.,1.,0.);#2=IFCAXIS2PLACEMENT2D(#3,#4);\
            #3=IFCCARTESIANPOINT((10.,20.));#4=IFCDIRECTION((0.,1.));";
        let document = Document::new(text);
        let mut edits = Edits::default();
        write_out(&document, &mut document.free_numbers(), &mut edits);
        let seen = String::from_utf8(edits.apply(text)).unwrap();
        assert!(seen.starts_with("#1=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#5);\n#5=IFCPOLYLINE((#6,#7,#8,#9,#10));"));
        assert!(seen.contains("#6=IFCCARTESIANPOINT((10.5,19.0));"), "{seen}");
    }
}
