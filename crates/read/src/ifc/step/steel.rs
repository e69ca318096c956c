//! Steel sections with radii or sizes that the geometry library leaves out: written as polygons; slopes of flanges are
//! reported.

use super::document::{Document, Edits};
use super::profiles::{Outline, ProfilePoint, placed, rounded, write};
use super::value::{Value, real};

/// Position of the first of a profile's numbers, after its kind, name and position.
const FIRST: usize = 3;

/// Positions of the slopes.
const SLOPES: [(&str, &[usize]); 5] = [
    ("IFCISHAPEPROFILEDEF", &[6]),
    ("IFCASYMMETRICISHAPEPROFILEDEF", &[9, 11]),
    ("IFCLSHAPEPROFILEDEF", &[5]),
    ("IFCUSHAPEPROFILEDEF", &[6]),
    ("IFCTSHAPEPROFILEDEF", &[7, 8]),
];

pub fn write_out(
    document: &Document,
    free: &mut dyn Iterator<Item = u64>,
    edits: &mut Edits,
    notes: &mut Vec<(u64, String)>,
) {
    // Which radii are left out, and the outline with them.
    let kinds: [(&str, &[usize], Outline); 3] = [
        ("IFCCSHAPEPROFILEDEF", &[4], c_shape),
        ("IFCISHAPEPROFILEDEF", &[5], i_shape),
        ("IFCASYMMETRICISHAPEPROFILEDEF", &[4, 7, 8, 10], asymmetric),
    ];
    for (keyword, radii, outline) in kinds {
        for record in document.all(keyword) {
            let values = document.values(record);
            let numbers = numbers(keyword, &values);
            if !radii.iter().any(|&i| numbers.get(i).is_some_and(|&r| r > 0.0)) {
                continue;
            }
            match outline(&numbers).and_then(|o| placed(document, values.get(2)?, o)) {
                Some(outline) => write(document, record, &values, &outline, free, edits),
                None => notes.push((record.id, "the radii of its profile are not drawn: they do not fit".into())),
            }
        }
    }
    slopes(document, notes);
    equal_legs(document, edits);
}

/// An asymmetric I section of IFC2x3 has a centre of gravity where later versions have radii.
fn numbers(keyword: &str, values: &[Value]) -> Vec<f64> {
    const OF_IFC2X3: usize = 9;
    let mut numbers: Vec<f64> = values.iter().skip(FIRST).map(|v| v.number().unwrap_or(0.0)).collect();
    if keyword == "IFCASYMMETRICISHAPEPROFILEDEF" && numbers.len() <= OF_IFC2X3 {
        numbers.truncate(OF_IFC2X3 - 1);
    }
    if numbers.iter().all(|x| x.is_finite()) { numbers } else { Vec::new() }
}

/// Depth, width, wall, girth of the lips, radius inside its bends; outside it is larger by the wall.
fn c_shape(numbers: &[f64]) -> Option<Vec<ProfilePoint>> {
    let &[depth, width, wall, girth, inside] = numbers.first_chunk()?;
    let (x, y, outside) = (width / 2.0, depth / 2.0, inside + wall);
    let half = [
        ([-x, -y], outside),
        ([x, -y], outside),
        ([x, girth - y], 0.0),
        ([x - wall, girth - y], 0.0),
        ([x - wall, wall - y], inside),
        ([wall - x, wall - y], inside),
    ];
    let other = half.into_iter().rev().map(|([x, y], radius)| ([x, -y], radius));
    let has_room = outside < girth && girth < y && 2.0 * outside < width.min(depth);
    (wall > 0.0 && has_room).then(|| rounded(&half.into_iter().chain(other).collect::<Vec<_>>()))
}

/// Width, depth, web, flange, fillet, edge.
fn i_shape(numbers: &[f64]) -> Option<Vec<ProfilePoint>> {
    let &[width, depth, web, flange, fillet, edge] = numbers.first_chunk()?;
    asymmetric(&[width, depth, web, flange, fillet, width, flange, fillet, edge, 0.0, edge])
}

/// Bottom width, depth, web, bottom flange and fillet, top width, flange and fillet, bottom edge, –, top edge.
fn asymmetric(numbers: &[f64]) -> Option<Vec<ProfilePoint>> {
    let &[width, depth, web, flange, fillet, top_width, top_flange, top_fillet] = numbers.first_chunk()?;
    let edges = [8, 10].map(|i| numbers.get(i).copied().unwrap_or(0.0));
    let top_flange = if top_flange > 0.0 { top_flange } else { flange };
    let (y, w) = (depth / 2.0, web / 2.0);
    let (bottom, top) = (flange - y, y - top_flange);
    let right = [
        ([width / 2.0, -y], 0.0),
        ([width / 2.0, bottom], edges[0]),
        ([w, bottom], fillet),
        ([w, top], top_fillet),
        ([top_width / 2.0, top], edges[1]),
        ([top_width / 2.0, y], 0.0),
    ];
    let left = right.into_iter().rev().map(|([x, y], radius)| ([-x, y], radius));
    let room = |width: f64, flange: f64, fillet: f64, edge: f64| {
        fillet >= 0.0 && edge >= 0.0 && flange > 0.0 && edge < flange && fillet + edge < width / 2.0 - w
    };
    let has_room = room(width, flange, fillet, edges[0]) && room(top_width, top_flange, top_fillet, edges[1]);
    let is_sound = web > 0.0 && bottom + fillet < top - top_fillet && has_room;
    is_sound.then(|| rounded(&right.into_iter().chain(left).collect::<Vec<_>>()))
}

fn slopes(document: &Document, notes: &mut Vec<(u64, String)>) {
    for (keyword, slots) in SLOPES {
        for record in document.all(keyword) {
            let numbers = numbers(keyword, &document.values(record));
            if slots.iter().any(|&i| numbers.get(i).is_some_and(|&s| s != 0.0)) {
                notes.push((record.id, "the slope of its profile's flanges is not drawn".into()));
            }
        }
    }
}

/// An L section without a width has two legs of equal length.
fn equal_legs(document: &Document, edits: &mut Edits) {
    for record in document.all("IFCLSHAPEPROFILEDEF") {
        let values = document.values(record);
        if let (Some(Value::Number(depth)), Some(Value::Absent)) = (values.get(FIRST), values.get(FIRST + 1)) {
            let width = document.argument_pieces(record).swap_remove(FIRST + 1);
            edits.replace(width, real(*depth));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::profiles::area;
    use super::*;

    /// The area that a corner of radius one loses from its square.
    const CORNER: f64 = 1.0 - std::f64::consts::FRAC_PI_4;

    #[test]
    fn radii_are_drawn() {
        let near = |outline: Option<Vec<ProfilePoint>>, right: f64| {
            let seen = area(&outline.unwrap());
            assert!((seen / right - 1.0).abs() < 3e-3, "{seen}, right is {right}");
        };
        near(c_shape(&[0.2, 0.1, 0.005, 0.03, 0.01]), 0.0022 - 4.0 * CORNER * (0.015f64.powi(2) - 0.01f64.powi(2)));
        let i = 2.0 * 0.1 * 0.01 + 0.18 * 0.006;
        near(i_shape(&[0.1, 0.2, 0.006, 0.01, 0.012, 0.005]), i + 4.0 * CORNER * (0.012f64.powi(2) - 0.005f64.powi(2)));
        let asymmetric_area = 0.1 * 0.01 + 0.06 * 0.008 + 0.182 * 0.006;
        let fillets = 2.0 * CORNER * (0.012f64.powi(2) + 0.01f64.powi(2));
        near(asymmetric(&[0.1, 0.2, 0.006, 0.01, 0.012, 0.06, 0.008, 0.01]), asymmetric_area + fillets);
        assert!(c_shape(&[0.2, 0.1, 0.005, 0.03, 0.04]).is_none() && i_shape(&[0.1, 0.2, 0.006, 0.01, 0.05]).is_none());
    }

    #[test]
    fn what_is_told_and_what_is_filled_in() {
        let text =
            b"#1=IFCLSHAPEPROFILEDEF(.AREA.,$,$,0.1,$,0.01,$,$,0.1);#2=IFCISHAPEPROFILEDEF(.AREA.,$,$,1.,1.,.1,.1,$);";
        let document = Document::new(text);
        let (mut edits, mut notes) = (Edits::default(), Vec::new());
        write_out(&document, &mut document.free_numbers(), &mut edits, &mut notes);
        assert!(notes.len() == 1 && notes[0].0 == 1 && notes[0].1.contains("slope"), "{notes:?}");
        assert!(String::from_utf8(edits.apply(text)).unwrap().contains("$,$,0.1,0.1,0.01,$,$,0.1)"));
    }
}
