//! Shapes that the geometry library lacks or draws wrongly, each with its volume in closed form.

use std::f64::consts::{PI, TAU};

use super::field_tests::{File, model, volume};

/// A solid by its records (`@n` is the n-th of them, `#5` the zero, `#9` upwards), its volume in cubic metres, to
/// within a relative error, and a word that a note must contain.
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

/// A prism of 1 m on a polygon with this many corners on a circle, which may be 0.2 mm off.
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

/// A wall of 8 × 0.3 × 3 m, cut between 0 and 3 m by a plane with this normal at this many metres.
fn steep(normal: &str, at: f64, volume: f64) -> Shape {
    let records = [
        "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,8.,0.3)",
        "IFCEXTRUDEDAREASOLID(@1,#5,#9,3.)",
        &format!("IFCCARTESIANPOINT(({at:?},0.,0.))"),
        &format!("IFCDIRECTION({normal})"),
        "IFCDIRECTION((0.,1.,0.))",
        "IFCAXIS2PLACEMENT3D(@3,@4,@5)",
        "IFCPLANE(@6)",
        "IFCCARTESIANPOINTLIST2D(((0.,-1.),(3.,-1.),(3.,1.),(0.,1.),(0.,-1.)))",
        "IFCINDEXEDPOLYCURVE(@8,$,.F.)",
        "IFCPOLYGONALBOUNDEDHALFSPACE(@7,.F.,#5,@9)",
        "IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,@2,@10)",
    ];
    shape(&records, volume, 1e-4, "")
}

/// A box as a closed shell, which is the last of the records.
fn shell(records: &mut Vec<String>, low: [f64; 3], high: [f64; 3]) {
    const FACES: [[usize; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let first = records.len() + 1;
    for i in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|k| if i >> k & 1 == 0 { low[k] } else { high[k] });
        records.push(format!("IFCCARTESIANPOINT(({x:?},{y:?},{z:?}))"));
    }
    for face in FACES {
        let [a, b, c, d] = face.map(|i| i + first);
        records.push(format!("IFCPOLYLOOP((@{a},@{b},@{c},@{d}))"));
        records.push(format!("IFCFACEOUTERBOUND(@{},.T.)", records.len()));
        records.push(format!("IFCFACE((@{}))", records.len()));
    }
    let faces: Vec<String> = (0..6).map(|i| format!("@{}", first + 10 + 3 * i)).collect();
    records.push(format!("IFCCLOSEDSHELL(({}))", faces.join(",")));
}

fn cuts() -> Vec<Shape> {
    let mut hollow = Vec::new();
    shell(&mut hollow, [0.0; 3], [4.0, 1.0, 3.0]);
    shell(&mut hollow, [0.25; 3], [3.75, 0.75, 2.75]);
    hollow.push("IFCFACETEDBREPWITHVOIDS(@27,(@54))".into());
    vec![
        steep("(1.,0.,0.)", 1.0, 5.4),
        steep("(1.,0.,0.05)", 1.0, 7.2 - 0.9 * 2.075),
        steep("(1.,0.,0.)", 9.0, 7.2),
        Shape { records: hollow, volume: 12.0 - 3.5 * 0.5 * 2.5, tolerance: 1e-4, word: "" },
    ]
}

/// Lines that are trimmed, or followed only in part.
fn lines() -> Vec<Shape> {
    let slab = |line: &[&str; 4], trimmed: &str| {
        let rest = [
            "IFCCARTESIANPOINT((0.,0.))",
            "IFCCARTESIANPOINT((5.,2.5))",
            trimmed,
            "IFCCARTESIANPOINT((0.,2.5))",
            "IFCPOLYLINE((@6,@8,@5))",
            "IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,@7)",
            "IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,@9)",
            "IFCCOMPOSITECURVE((@10,@11),.F.)",
            "IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,@12)",
            "IFCEXTRUDEDAREASOLID(@13,#5,#9,3.)",
        ];
        shape(&[&line[..], &rest].concat(), 37.5, 1e-6, "")
    };
    let points = "IFCCARTESIANPOINTLIST2D(((0.,0.),(5.,0.),(5.,5.),(0.,5.)))";
    let indexed = "IFCINDEXEDPOLYCURVE(@1,$,.F.)";
    let segment = "IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,@2)";
    let composite = "IFCCOMPOSITECURVE((@3),.F.)";
    let u = ["IFCCARTESIANPOINTLIST3D(((0.,0.,0.),(4.,0.,0.),(4.,3.,0.),(0.,3.,0.)))", indexed];
    let along = |line: [&str; 2], ends: &str, volume, tolerance| {
        let sweep = format!("IFCSURFACECURVESWEPTAREASOLID(@3,#5,@2,{ends},@4)");
        shape(&[&line[..], &[RECTANGLE, "IFCPLANE(#5)", &sweep]].concat(), volume, tolerance, "keep a part")
    };
    let arc = [
        "IFCCIRCLE(#5,5.)",
        "IFCTRIMMEDCURVE(@1,(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(3.141592653589793)),.T.,.PARAMETER.)",
    ];
    vec![
        slab(&[points, indexed, segment, composite], "IFCTRIMMEDCURVE(@2,(@5),(@6),.T.,.CARTESIAN.)"),
        slab(&[points, indexed, segment, composite], "IFCTRIMMEDCURVE(@4,(@5),(@6),.T.,.CARTESIAN.)"),
        along(u, "1.,2.", 0.45, 1e-6),
        along(arc, "0.,1.5707963267948966", 0.15 * 2.5 * PI, 1e-3),
    ]
}

/// Chords of 7.5 degrees are 0.3 % short; also for a profile that touches its axis.
fn turned() -> Vec<Shape> {
    let about = |x: &str, angle: f64, volume: f64| {
        let records = [
            RECTANGLE,
            &format!("IFCCARTESIANPOINT(({x},0.,0.))"),
            "IFCDIRECTION((0.,1.,0.))",
            "IFCAXIS1PLACEMENT(@2,@3)",
            &format!("IFCREVOLVEDAREASOLID(@1,#5,@4,{angle:?})"),
        ];
        shape(&records, volume, 3e-3, "")
    };
    vec![
        about("-2.", TAU, 0.15 * 2.0 * TAU),
        about("-2.", PI / 2.0, 0.15 * PI),
        about("0.15", TAU, PI * 0.09 * 0.5),
        about("-0.15", PI, PI * 0.09 * 0.25),
    ]
}

/// Two metres of sections with radii, and a ring of a thick line.
fn steel() -> Vec<Shape> {
    let beam = |profile: &str, area: f64| shape(&[profile, "IFCEXTRUDEDAREASOLID(@1,#5,#9,2.)"], 2.0 * area, 3e-3, "");
    // A fillet of radius one, and what an edge takes away.
    let corner = 1.0 - PI / 4.0;
    let i = 2.0 * 0.1 * 0.01 + 0.18 * 0.006;
    let asymmetric = "IFCASYMMETRICISHAPEPROFILEDEF(.AREA.,$,$,0.1,0.2,0.006,0.01,0.012,0.06,0.008,0.01,$,$,$,$)";
    let ring = [
        "IFCCARTESIANPOINTLIST2D(((0.,0.),(4.,0.),(4.,4.),(0.,4.),(0.,0.)))",
        "IFCINDEXEDPOLYCURVE(@1,$,.F.)",
        "IFCCENTERLINEPROFILEDEF(.AREA.,$,@2,0.2)",
        "IFCEXTRUDEDAREASOLID(@3,#5,#9,1.)",
    ];
    let sloped = ["IFCUSHAPEPROFILEDEF(.AREA.,$,$,0.2,0.1,0.01,0.01,$,$,0.1)", "IFCEXTRUDEDAREASOLID(@1,#5,#9,2.)"];
    vec![
        beam("IFCCSHAPEPROFILEDEF(.AREA.,$,$,0.2,0.1,0.005,0.03,0.01)", 0.0022 - 4.0 * corner * 1.25e-4),
        beam("IFCISHAPEPROFILEDEF(.AREA.,$,$,0.1,0.2,0.006,0.01,$,0.008,$)", i - 4.0 * corner * 6.4e-5),
        beam(asymmetric, 0.1 * 0.01 + 0.06 * 0.008 + 0.182 * 0.006 + 2.0 * corner * 2.44e-4),
        beam("IFCLSHAPEPROFILEDEF(.AREA.,$,$,0.1,$,0.01,$,$,$)", 0.0019),
        shape(&sloped, f64::NAN, 0.0, "slope"),
        shape(&ring, 3.2, 1e-6, ""),
    ]
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
    all.extend([cuts(), lines(), turned(), steel()].into_iter().flatten());
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
