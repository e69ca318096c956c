//! How products are connected in a file: representations, units, missing records, products at impossible places.

use super::IfcModel;
use super::field_tests::{File, model, volume};

/// A file with a wall of 2.4 m³, and the number of its shape.
fn wall() -> (File, u32) {
    let mut file = File::new();
    let shape = file.body([0.0; 3], "$,$", [4.0, 0.2, 3.0]);
    file.add(format_args!("IFCWALL('good',$,'good',$,$,$,#{shape},$,$)"));
    (file, shape)
}

/// The wall, and another product of this shape.
fn with(shape: &str) -> IfcModel {
    let (mut file, _) = wall();
    file.add(format_args!("IFCWALL('bad',$,'bad',$,$,$,{shape},$,$)"));
    model(file.text().as_bytes()).unwrap()
}

#[test]
fn clearances_and_fallbacks_are_no_second_body() {
    for other in ["Clearance", "Reference", "Body-FallBack", "Facetation", "Body"] {
        let (mut file, shape) = wall();
        let solid = shape - 2;
        let body = shape - 1;
        let second = file.add(format_args!("IFCSHAPEREPRESENTATION(#6,'{other}','SweptSolid',(#{solid}))"));
        let both = file.add(format_args!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{second},#{body}))"));
        file.add(format_args!("IFCWALL('two',$,'two',$,$,$,#{both},$,$)"));
        let model = model(file.text().as_bytes()).unwrap();
        assert!((volume(&model.products[1]) - 2.4).abs() < 1e-6, "{other}: {}", volume(&model.products[1]));
    }
}

#[test]
fn what_hangs_on_nothing_is_named() {
    let model = with("#900");
    assert_eq!(model.products.len(), 2);
    assert!(model.unmeshed[0].1.contains("#900, which is not in the file"), "{:?}", model.unmeshed);
    let (mut file, _) = wall();
    let shape = file.add(format_args!("IFCPRODUCTDEFINITIONSHAPE($,$,(#901))"));
    file.add(format_args!("IFCWALL('bad',$,'bad',$,$,$,#{shape},$,$)"));
    let model = super::field_tests::model(file.text().as_bytes()).unwrap();
    assert!(model.unmeshed[0].1.contains("#901"), "{:?}", model.unmeshed);
}

#[test]
fn a_missing_semicolon_or_a_number_twice_loses_nothing_in_silence() {
    let (mut file, first) = wall();
    let shape = file.body([9.0, 0.0, 0.0], "$,$", [1.0; 3]);
    file.add(format_args!("IFCWALL('b',$,'b',$,$,$,#{shape},$,$)"));
    let last = file.last;
    let text = file.text();
    let unsaid = model(text.as_bytes()).unwrap();
    assert!(unsaid.products.len() == 2 && unsaid.warnings.is_empty(), "{:?}", unsaid.warnings);
    let wall = format!("'good',$,$,$,#{first},$,$)");
    let open = model(text.replacen(&format!("{wall};"), &wall, 1).as_bytes()).unwrap();
    assert_eq!((open.products.len(), open.warnings.len()), (2, 1), "{:?}", open.warnings);
    let twice = text.replacen(&format!("#{last}="), "#15=", 1);
    let twice = model(twice.as_bytes()).unwrap();
    assert!(twice.warnings.iter().any(|w| w.contains("#15")), "{:?}", twice.warnings);
}

#[test]
fn one_far_product_does_not_take_the_others() {
    for far in ["1.E38", "1.E300", "7.E9"] {
        let (mut file, shape) = wall();
        let point = file.add(format_args!("IFCCARTESIANPOINT(({far},0.,0.))"));
        let place = file.add(format_args!("IFCAXIS2PLACEMENT3D(#{point},$,$)"));
        let place = file.add(format_args!("IFCLOCALPLACEMENT($,#{place})"));
        file.add(format_args!("IFCWALL('far',$,'far',$,$,#{place},#{shape},$,$)"));
        let model = model(file.text().as_bytes()).unwrap();
        assert!((volume(&model.products[0]) - 2.4).abs() < 1e-6, "{far}");
        let (_, said) = &model.unmeshed[0];
        assert!(said.contains("from the file's zero") && said.len() < 90, "{said}");
    }
}

#[test]
fn the_unit_that_is_meshed_is_the_one_that_is_told() {
    for (factor, metres, words) in [("0.3048", 0.3048, 0), ("1.", 0.3048, 1), ("0.", 0.3048, 1), ("-1.", 0.3048, 1)] {
        let unit = format!(
            "#1=IFCCONVERSIONBASEDUNIT(#901,.LENGTHUNIT.,'FOOT',#902);\n#901=IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0);\n\
             #902=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE({factor}),#903);\n#903=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);"
        );
        let text = wall().0.text().replace("#1=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);", &unit);
        let model = model(text.as_bytes()).unwrap();
        assert_eq!((model.length_unit, model.warnings.len()), (Some(metres), words), "{factor}");
        assert!((volume(&model.products[0]) - 2.4 * 0.3048f64.powi(3)).abs() < 1e-6);
    }
}

#[test]
fn what_cannot_be_is_said_of_the_record_itself() {
    let (mut file, _) = wall();
    let shape = file.body([0.0; 3], "$,$", [1.0, 1.0, 0.0]);
    file.add(format_args!("IFCWALL('flat',$,'flat',$,$,$,#{shape},$,$)"));
    let said = model(file.text().as_bytes()).unwrap().unmeshed;
    assert!(said[0].1.contains(&format!("IFCEXTRUDEDAREASOLID (#{}): its depth is 0", shape - 2)), "{said:?}");
}

/// A gable, its roof clipped by half-spaces: a recess with a window in it, at any angle.
#[test]
fn recess_and_window_in_a_gable() {
    let mut file = File::new();
    let turns = [0.0, 0.001, 0.05, 0.2, 0.5, 1.0, 17.0, 44.9, 60.0, 89.99, 90.0, 120.0, 179.5, 179.9f64];
    for degrees in turns {
        gable(&mut file, degrees);
    }
    let model = model(file.text().as_bytes()).unwrap();
    // 4 × 2 m and a gable of 1 m, 0.4 m thick; recess 2 × 1.5 × 0.1 and window 1 × 1 m overlap.
    let right = 0.4 * (8.0 + 2.0) - 0.1 * 3.0 - 0.3;
    let is_right = |p: &&super::Product| (volume(p) / right - 1.0).abs() < 1e-3;
    let seen: Vec<(f64, &Option<String>)> = model.products.iter().map(|p| (volume(p), &p.note)).collect();
    assert_eq!(model.products.len(), turns.len());
    assert!(model.products.iter().all(|p| p.note.is_some() || is_right(&p)), "{seen:?}");
    assert!(model.noted.is_empty(), "{seen:?}");
}

fn gable(file: &mut File, degrees: f64) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let along = file.add(format_args!("IFCDIRECTION(({cos:?},{sin:?},0.))"));
    let place = file.add(format_args!("IFCAXIS2PLACEMENT3D(#4,#9,#{along})"));
    let place = file.add(format_args!("IFCLOCALPLACEMENT($,#{place})"));
    let mut shape = file.body([2.0, 0.2, 0.0], "$,$", [4.0, 0.4, 3.0]);
    let mut solid = shape - 2;
    let top = file.add(format_args!("IFCCARTESIANPOINT((2.,0.,3.))"));
    for x in [-1.0, 1.0f64] {
        let up = file.add(format_args!("IFCDIRECTION(({x:?},0.,2.))"));
        let axes = file.add(format_args!("IFCAXIS2PLACEMENT3D(#{top},#{up},#8)"));
        let plane = file.add(format_args!("IFCPLANE(#{axes})"));
        let half = file.add(format_args!("IFCHALFSPACESOLID(#{plane},.F.)"));
        solid = file.add(format_args!("IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#{solid},#{half})"));
    }
    let body = file.add(format_args!("IFCSHAPEREPRESENTATION(#6,'Body','Clipping',(#{solid}))"));
    shape = file.add(format_args!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{body}))"));
    let id = file.last + 1;
    let host = file.add(format_args!("IFCWALL('g{id}',$,'gable',$,$,#{place},#{shape},$,$)"));
    for [x, z, w, h, from, to] in [[1.0, 0.5, 2.0, 1.5, 0.0, 0.1], [1.5, 0.75, 1.0, 1.0, 0.0, 0.4]] {
        let body = file.body([x + w / 2.0, from, z + h / 2.0], "#8,#9", [h, w, to - from]);
        let local = file.add(format_args!("IFCLOCALPLACEMENT(#{place},#5)"));
        let id = file.last + 1;
        let hole = file.add(format_args!("IFCOPENINGELEMENT('o{id}',$,'o',$,$,#{local},#{body},$,.OPENING.)"));
        file.add(format_args!("IFCRELVOIDSELEMENT('v{id}',$,$,$,#{host},#{hole})"));
    }
}
