//! Shapes that the geometry library lacks or draws otherwise than meant, each with its volume in closed form.

use std::f64::consts::{PI, TAU};

use super::field_tests::{File, model, volume};

/// A solid by its records (`@n` is the n-th of them, `#5` the zero, `#9` upwards), its volume in cubic metres, to so
/// many parts of itself, and a word that must be said.
struct Shape {
    records: Vec<String>,
    volume: f64,
    tolerance: f64,
    word: &'static str,
}

fn shape(records: &[&str], volume: f64, tolerance: f64, word: &'static str) -> Shape {
    Shape { records: records.iter().map(|r| (*r).to_owned()).collect(), volume, tolerance, word }
}

const RECTANGLE: &str = "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,0.3,0.5)";
const SMALLER: &str = "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,0.15,0.25)";
/// Points 1 to 4, polyline 5: 4 + 3 + 4 m.
const U: [&str; 5] = [
    "IFCCARTESIANPOINT((0.,0.,0.))",
    "IFCCARTESIANPOINT((4.,0.,0.))",
    "IFCCARTESIANPOINT((4.,3.,0.))",
    "IFCCARTESIANPOINT((0.,3.,0.))",
    "IFCPOLYLINE((@1,@2,@3,@4))",
];

fn along_u(records: &[&str], volume: f64, tolerance: f64, word: &'static str) -> Shape {
    shape(&[&U, records].concat(), volume, tolerance, word)
}

/// A prism of 1 m on a polygon of so many corners on a circle, which may be 0.2 mm off.
fn dense(radius: f64, corners: u32) -> Shape {
    let at = |i: u32| (TAU * f64::from(i) / f64::from(corners)).sin_cos();
    let mut records: Vec<String> =
        (0..corners).map(at).map(|(s, c)| format!("IFCCARTESIANPOINT(({:?},{:?}))", radius * c, radius * s)).collect();
    records.iter_mut().for_each(|r| *r = r.replace('e', "E"));
    let all: Vec<String> = (1..=corners).chain([1]).map(|i| format!("@{i}")).collect();
    let line = corners + 1;
    records.push(format!("IFCPOLYLINE(({}))", all.join(",")));
    records.push(format!("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,@{line})"));
    records.push(format!("IFCEXTRUDEDAREASOLID(@{},#5,#9,1.)", line + 1));
    let n = f64::from(corners);
    Shape { records, volume: n / 2.0 * (TAU / n).sin() * radius * radius, tolerance: 2e-3, word: "" }
}

fn shapes() -> Vec<Shape> {
    // A circle is drawn with 36 corners.
    let disk = 18.0 * (TAU / 36.0).sin();
    let plane = "IFCPLANE(#5)";
    let mut all = vec![
        along_u(&[RECTANGLE, plane, "IFCSURFACECURVESWEPTAREASOLID(@6,#5,@5,$,$,@7)"], 1.65, 1e-6, ""),
        along_u(&[RECTANGLE, plane, "IFCSURFACECURVESWEPTAREASOLID(@6,#5,@5,0.,1.,@7)"], 1.65, 1e-6, "whole was taken"),
        along_u(&[RECTANGLE, plane, "IFCSURFACECURVESWEPTAREASOLID(@6,#5,@5,0.,2.,@7)"], 1.05, 1e-6, "keep a part"),
        along_u(&[RECTANGLE, "IFCFIXEDREFERENCESWEPTAREASOLID(@6,#5,@5,$,$,#9)"], 1.65, 1e-6, ""),
        along_u(&["IFCSWEPTDISKSOLID(@5,0.1,$,$,$)"], disk * 0.01 * 11.0, 1e-6, ""),
        along_u(&["IFCSWEPTDISKSOLID(@5,0.1,0.05,0.,1.)"], disk * 0.0075 * 11.0, 1e-6, "whole was taken"),
        along_u(&["IFCSWEPTDISKSOLIDPOLYGONAL(@5,0.1,$,$,$,0.5)"], disk * 0.01 * (9.0 + PI / 2.0), 2e-3, ""),
        shape(&[RECTANGLE, SMALLER, "IFCEXTRUDEDAREASOLIDTAPERED(@1,#5,#9,3.,@2)"], 0.15 * 1.75, 1e-6, ""),
        shape(
            &[RECTANGLE, "IFCCIRCLEPROFILEDEF(.AREA.,$,$,0.2)", "IFCEXTRUDEDAREASOLIDTAPERED(@1,#5,#9,3.,@2)"],
            f64::NAN,
            0.0,
            "different corners",
        ),
        shape(
            &[
                "IFCELLIPSEPROFILEDEF(.AREA.,$,$,1.,0.5)",
                "IFCELLIPSEPROFILEDEF(.AREA.,$,$,0.5,0.25)",
                "IFCEXTRUDEDAREASOLIDTAPERED(@1,#5,#9,3.,@2)",
            ],
            PI * 0.5 * 1.75,
            1e-3,
            "",
        ),
        // The middle of the profile two metres from the axis, half a turn: chords of 7.5 degrees.
        shape(
            &[
                RECTANGLE,
                SMALLER,
                "IFCCARTESIANPOINT((-2.,0.,0.))",
                "IFCDIRECTION((0.,1.,0.))",
                "IFCAXIS1PLACEMENT(@3,@4)",
                "IFCREVOLVEDAREASOLIDTAPERED(@1,#5,@5,3.141592653589793,@2)",
            ],
            0.15 * (1.0 - 0.5 + 1.0 / 12.0) * 2.0 * PI,
            4e-3,
            "",
        ),
        shape(
            &[
                "IFCCARTESIANPOINT((0.,0.))",
                "IFCCARTESIANPOINT((4.,0.))",
                "IFCCARTESIANPOINT((4.,3.))",
                "IFCPOLYLINE((@1,@2,@3))",
                "IFCCENTERLINEPROFILEDEF(.AREA.,$,@4,0.2)",
                "IFCEXTRUDEDAREASOLID(@5,#5,#9,3.)",
            ],
            4.2,
            1e-6,
            "",
        ),
        shape(
            &[
                "IFCCARTESIANPOINT((7.,8.))",
                "IFCAXIS2PLACEMENT2D(@1,$)",
                "IFCCIRCLE(@2,0.1)",
                "IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,@3)",
                "IFCEXTRUDEDAREASOLID(@4,#5,#9,1.)",
            ],
            disk * 0.01,
            1e-5,
            "",
        ),
    ];
    all.extend([(0.1, 30), (0.1, 127), (0.25, 64), (2.0, 360)].map(|(radius, corners)| dense(radius, corners)));
    all
}

#[test]
fn volumes_in_closed_form() {
    for Shape { records, volume: right, tolerance, word } in shapes() {
        let mut file = File::new();
        let mut numbers: Vec<u32> = Vec::new();
        for record in &records {
            let mut text = record.clone();
            // The longest first: @1 begins @10.
            for (i, number) in numbers.iter().enumerate().rev() {
                text = text.replace(&format!("@{}", i + 1), &format!("#{number}"));
            }
            numbers.push(file.add(format_args!("{text}")));
        }
        let solid = file.last;
        let shape = file.add(format_args!("IFCSHAPEREPRESENTATION(#6,'Body','AdvancedSweptSolid',(#{solid}))"));
        let body = file.add(format_args!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{shape}))"));
        let place = file.add(format_args!("IFCLOCALPLACEMENT($,#5)"));
        file.add(format_args!("IFCBUILDINGELEMENTPROXY('p',$,'p',$,$,#{place},#{body},$,$)"));
        let what = records.last().unwrap();
        let model = model(file.text().as_bytes()).unwrap_or_else(|e| panic!("{what}: {e}"));
        let product = &model.products[0];
        let (seen, said) = (volume(product), product.note.clone().unwrap_or_default());
        assert!(right.is_nan() || (seen / right - 1.0).abs() <= tolerance, "{what}: {seen}, right is {right}");
        assert!(said.contains(word) && (word.is_empty() == said.is_empty()), "{what}: {said}");
    }
}
