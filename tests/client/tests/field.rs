//! Files from the field, all the way to verdicts; models with products that cannot be meshed.

use std::fmt::Write as _;
use std::fs;

use asbuilt_client_tests::{Database, project, scratch, text};

/// Scans of two walls, how they are read, a word of the note, and the right verdicts for both.
type Pair = (&'static [&'static str], &'static [&'static str], &'static str, &'static [&'static str]);

const PAIRS: [Pair; 4] = [
    (&["e57_two_stations_ok.e57"], &[], "", &["confirmed"]),
    (&["pcd_viewpoint_1.pcd", "pcd_viewpoint_2.pcd"], &[], "", &["confirmed"]),
    // Without an origin nothing is refuted.
    (&["e57_merged_identity_pose.e57"], &[], "without origin", &["confirmed", "unobserved"]),
    (&["e57_merged_identity_pose.e57"], &["--identity-pose", "merged"], "without origin", &["confirmed", "unobserved"]),
];

#[test]
fn both_walls_stand() {
    let folder = project("../shared/data/field");
    if !folder.is_dir() {
        eprintln!("SKIPPED: {} is not there", folder.display());
        return;
    }
    for (i, (scans, options, word, right)) in PAIRS.iter().enumerate() {
        let db = Database::new(&format!("field_{i}"));
        let files: Vec<_> = ["two_walls.ifc"].iter().chain(*scans).map(|name| folder.join(name)).collect();
        let files: Vec<&str> = files.iter().map(|file| text(file)).collect();
        let said = db.asbuilt(&[&["load"], &files[..], *options].concat());
        assert!(said.contains(word), "{said}");
        let verdicts = db.verify(&[]);
        for wall in ["partition", "outer wall"] {
            assert!(right.contains(&verdicts.verdict(wall)), "{scans:?}: {wall} {}", verdicts.verdict(wall));
        }
    }
}

/// A STEP file being built.
struct Step {
    text: String,
    last: u32,
}

impl Step {
    fn add(&mut self, record: &str) -> u32 {
        self.last += 1;
        let _ = writeln!(self.text, "#{}={record};", self.last);
        self.last
    }

    fn point(&mut self, [x, y, z]: [f64; 3]) -> u32 {
        self.add(&format!("IFCCARTESIANPOINT(({x:?},{y:?},{z:?}))").replace('e', "E"))
    }

    /// A product, or an opening, of extruded profiles in any place and direction.
    fn product(&mut self, class: &str, name: &str, at: [f64; 3], axes: &str, profile: &str, depth: f64) -> u32 {
        let (point, profile) = (self.point(at), self.add(profile));
        let place = self.add(&format!("IFCAXIS2PLACEMENT3D(#{point},{axes})"));
        let solid = self.add(&format!("IFCEXTRUDEDAREASOLID(#{profile},#{place},#9,{depth:?})"));
        let shape = self.add(&format!("IFCSHAPEREPRESENTATION(#6,'Body','SweptSolid',(#{solid}))"));
        self.named(class, name, shape)
    }

    fn named(&mut self, class: &str, name: &str, shape: u32) -> u32 {
        let body = self.add(&format!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{shape}))"));
        self.add(&format!("{class}('{name}',$,'{name}',$,$,#8,#{body},$,$)"))
    }

    /// Copies of copies: 2¹³ of a column of 2000 sides.
    fn hungry(&mut self) {
        let corners: Vec<String> = (0..2000)
            .map(|i| (std::f64::consts::TAU * f64::from(i) / 2000.0).sin_cos())
            .map(|(sin, cos)| format!("({:.6},{:.6})", cos, sin))
            .collect();
        let points = self.add(&format!("IFCCARTESIANPOINTLIST2D(({}))", corners.join(",")));
        let line = self.add(&format!("IFCINDEXEDPOLYCURVE(#{points},$,.F.)"));
        let profile = self.add(&format!("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{line})"));
        let solid = self.add(&format!("IFCEXTRUDEDAREASOLID(#{profile},#5,#9,1.)"));
        let mut shape = self.add(&format!("IFCSHAPEREPRESENTATION(#6,'Body','SweptSolid',(#{solid}))"));
        for level in 0..13 {
            let map = self.add(&format!("IFCREPRESENTATIONMAP(#5,#{shape})"));
            let mut copy = |x: f64| {
                let point = self.point([x, f64::from(level), 0.0]);
                let place = self.add(&format!("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#{point},1.,$)"));
                self.add(&format!("IFCMAPPEDITEM(#{map},#{place})"))
            };
            let (one, other) = (copy(0.0), copy(f64::from(1 << level)));
            shape = self.add(&format!("IFCSHAPEREPRESENTATION(#6,'Body','MappedRepresentation',(#{one},#{other}))"));
        }
        self.named("IFCCOLUMN", "hungry", shape);
    }

    /// A block with very many holes in all directions.
    fn endless(&mut self) {
        let host =
            self.product("IFCWALL", "endless", [-50.0, 0.0, 0.0], "$,$", "IFCCIRCLEPROFILEDEF(.AREA.,$,$,10.)", 30.0);
        let mut state = 1u64;
        let mut number = |low: f64, high: f64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for i in 0..400 {
            let [up, along] = [(); 2].map(|()| {
                let d = [(); 3].map(|()| number(-1.0, 1.0));
                self.add(&format!("IFCDIRECTION(({:.6},{:.6},{:.6}))", d[0], d[1], d[2]))
            });
            let at = [-50.0 + number(-8.0, 8.0), number(-8.0, 8.0), number(2.0, 28.0)];
            let profile = format!("IFCCIRCLEPROFILEDEF(.AREA.,$,$,{:.6})", number(0.3, 2.0));
            let hole =
                self.product("IFCOPENINGELEMENT", &format!("o{i}"), at, &format!("#{up},#{along}"), &profile, 12.0);
            self.add(&format!("IFCRELVOIDSELEMENT('v{i}',$,$,$,#{host},#{hole})"));
        }
    }
}

#[test]
fn bad_products_cost_themselves_alone() {
    let head = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
        FILE_NAME('x','2024-01-01T00:00:00',(''),(''),'','','');\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n\
        #1=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n#3=IFCUNITASSIGNMENT((#1));\n#4=IFCCARTESIANPOINT((0.,0.,0.));\n\
        #5=IFCAXIS2PLACEMENT3D(#4,$,$);\n#6=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#5,$);\n\
        #7=IFCPROJECT('p',$,'P',$,$,$,$,(#6),#3);\n#8=IFCLOCALPLACEMENT($,#5);\n#9=IFCDIRECTION((0.,0.,1.));\n";
    let mut file = Step { text: head.into(), last: 9 };
    let wall = "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4.,0.2)";
    let good = |file: &mut Step, i: i32| {
        file.product("IFCWALL", &format!("good {i}"), [10.0 * f64::from(i), 0.0, 0.0], "$,$", wall, 3.0)
    };
    for i in 0..100 {
        good(&mut file, i);
    }
    file.product("IFCWALL", "impossible", [7e9, 0.0, 0.0], "$,$", wall, 3.0);
    file.hungry();
    file.endless();
    for i in 100..200 {
        good(&mut file, i);
    }
    let path = scratch("bad_products.ifc");
    fs::write(&path, file.text + "ENDSEC;\nEND-ISO-10303-21;\n").unwrap();
    let db = Database::new("bad_products");
    let said = db.asbuilt(&["load", text(&path), "--product-timeout", "8", "--product-memory", "300MB"]);
    for (name, why) in [("impossible", "7000000000 m"), ("hungry", "memory"), ("endless", "longer than 8 s")] {
        let line = said.lines().find(|l| l.contains("missing: ") && l.contains(name));
        assert!(line.is_some_and(|l| l.contains(why)), "{name}: {said}");
    }
    let count =
        "SELECT count(*) FROM building_object WHERE name LIKE 'good %' AND ab_volume(solid) BETWEEN 2.399 AND 2.401";
    let good: i64 = db.connect().query_one(count, &[]).unwrap().get(0);
    assert_eq!(good, 200);
    fs::remove_file(&path).unwrap();
}
