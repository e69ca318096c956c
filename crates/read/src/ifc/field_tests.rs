//! Files from the field with their right answers, and a family of walls with recesses and windows.

use std::fmt::Write as _;
use std::time::Duration;

use super::cut::SplitMix64;
use super::reader::{Limits, Progress};
use super::told::{Task, WorkerMessage};
use super::{IfcModel, Product, assemble, worker};

/// Meshes a text within this process.
pub fn model(bytes: &[u8]) -> Result<IfcModel, String> {
    let limits = Limits::default();
    let within =
        worker::WorkerLimits { memory: u64::MAX, product_time: Duration::from_secs(60), product_memory: u64::MAX };
    let mut told = Vec::new();
    worker::tell(bytes.to_vec(), &Task::default(), within, &mut told)?;
    let (mut progress, mut from) = (Progress::default(), &told[..]);
    while let Some(piece) = WorkerMessage::read(&mut from, u64::MAX).map_err(|e| e.to_string())? {
        progress.take(piece, limits).map_err(|e| e.to_string())?;
    }
    assemble::model(progress).map_err(|e| format!("{e:#}"))
}

pub fn volume(p: &Product) -> f64 {
    p.solid().unwrap().map_or(f64::NAN, |s| s.volume().unwrap_or(f64::NAN))
}

/// The volume of one of the products, m³, to within a relative error; or a word that a note must contain.
type ExpectedVolume = (&'static str, &'static [f64], f64, &'static str);

const FIELD: [ExpectedVolume; 20] = [
    ("ifc_recess_with_window_axis_aligned_ok", &[3.95], 1e-3, ""),
    ("ifc_recess_with_window_rotated_half_degree", &[3.95], 1e-3, ""),
    ("ifc_bom", &[2.4], 1e-6, ""),
    ("ifc_comment_first", &[2.4], 1e-6, ""),
    ("ifc_trailing", &[2.4], 1e-6, ""),
    ("ifc_far_vertex", &[2.4], 1e-6, "IfcWall far wall (#32): a vertex lies 6999999998 m"),
    ("ifc_arc_degrees_no_angle_unit_hangs", &[4.49], 1e-3, "degrees"),
    ("ifc_arc_column_degrees_no_angle_unit", &[2.356], 2e-2, "degrees"),
    ("ifc_productrepresentation", &[2.4], 1e-6, ""),
    ("ifc_sweep_parameters_0_to_1", &[1.65], 1e-6, "IfcFooting ground beam (#29): its parameters 0…1"),
    ("ifc_trimmed_polyline", &[37.5], 1e-6, ""),
    ("ifc_half_coplanar_all", &[2.4], 1e-6, "IfcWall all gone (#38): nothing is left"),
    ("ifc_prof_ellipse", &[1.50796], 5e-4, ""),
    ("ifc_prof_trapezium", &[1.2], 1e-6, ""),
    ("ifc_prof_zshape", &[0.0168], 1e-6, ""),
    ("ifc_mapconversion", &[2.4], 1e-6, "eastings 512345.000 m, northings 5412345.000 m, height 101.500 m, 30.000000°"),
    ("ifc_bigid_mix", &[2.4, 2.4], 1e-6, ""),
    ("ifc_dupguid", &[2.4, 2.4], 1e-6, ""),
    ("ifc_names_latin1", &[2.4], 1e-6, "Latin-1"),
    ("two_walls", &[0.625, 2.5], 1e-6, ""),
];

#[test]
fn the_fields_files() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/field");
    if !folder.is_dir() {
        eprintln!("SKIPPED: {} is not there", folder.display());
        return;
    }
    for (name, volumes, tolerance, word) in FIELD {
        let bytes = std::fs::read(folder.join(format!("{name}.ifc"))).unwrap();
        let model = model(&bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
        let seen: Vec<f64> = model.products.iter().filter(|p| !p.triangles.is_empty()).map(volume).collect();
        assert_eq!(seen.len(), volumes.len(), "{name}");
        for (seen, right) in seen.iter().zip(volumes) {
            assert!((seen / right - 1.0).abs() <= tolerance, "{name}: {seen} is not {right}");
        }
        let pairs = model.unmeshed.iter().chain(&model.noted).map(|(what, why)| format!("{what}: {why}"));
        let mut said: Vec<String> = pairs.chain(model.warnings.clone()).collect();
        said.extend(model.map_conversion.map(|m| m.shown()));
        assert!(said.iter().any(|s| s.contains(word)) || word.is_empty(), "{name}: {said:?}");
        assert!(!word.is_empty() || said.is_empty(), "{name}: {said:?}");
    }
}

#[test]
fn names_are_readable_and_shapes_have_their_width() {
    let wall = File::new().wall(&Wall { openings: vec![], ..Wall::random(&mut SplitMix64(1)) }).text();
    let named = wall.replace("'wall'", "'W\u{1}nde'").into_bytes();
    let named: Vec<u8> = named.into_iter().map(|b| if b == 1 { 0xE4 } else { b }).collect();
    assert_eq!(model(&named).unwrap().products[0].name, "Wände");
    let marked = [b"\xEF\xBB\xBF/* x */\n", wall.as_bytes(), &[b'\n'; 6000]].concat();
    assert_eq!(model(&marked).unwrap().products.len(), 1);
    let big = wall.replace("#25=", "#5000000025=").replace("#25,", "#5000000025,");
    assert_eq!(model(big.as_bytes()).unwrap().products.len(), 1);
}

/// A wall along its own x axis, its openings as boxes: start in x and z; width and height; start and end in y.
struct Wall {
    degrees: f64,
    size: [f64; 3],
    openings: Vec<[f64; 6]>,
}

impl Wall {
    /// 0 to 180 degrees, dense near the axes; 1 to 3 recesses, up to 3 windows, half of which overlap them.
    fn random(random: &mut SplitMix64) -> Self {
        let mut from = |low: f64, high: f64| low + (high - low) * random.number();
        let axis = [0.0, 90.0, 180.0][from(0.0, 2.999) as usize];
        let sign = from(-1.0, 1.0).signum();
        let degrees = match from(0.0, 1.0) {
            x if x < 0.6 => axis + sign * 10f64.powf(from(-4.0, 0.3)),
            x if x < 0.9 => from(0.0, 180.0),
            _ => axis,
        };
        let size @ [length, thick, high] = [from(2.0, 8.0), from(0.08, 0.6), from(2.4, 4.0)];
        let mut openings: Vec<[f64; 6]> = Vec::new();
        for _ in 0..from(1.0, 3.999) as usize {
            let (w, h) = (from(0.3, 1.8), from(0.3, 1.9));
            let (x, z, depth) = (from(0.1, length - w - 0.05), from(0.1, high - h - 0.05), thick * from(0.2, 0.8));
            let at = if from(0.0, 1.0) < 0.5 { -thick / 2.0 } else { thick / 2.0 - depth };
            openings.push([x, z, w, h, at, at + depth]);
        }
        for _ in 0..from(0.0, 3.999) as usize {
            let ([rx, rz, rw, rh, ..], w, h) = (openings[0], from(0.3, 1.2), from(0.3, 1.2));
            let apart = [from(0.1, length - w - 0.1), from(0.1, high - h - 0.1)];
            let over = [rx + rw * from(-0.3, 0.8), rz + rh * from(-0.3, 0.8)];
            let [x, z] = if from(0.0, 1.0) < 0.6 { over } else { apart };
            let more = if from(0.0, 1.0) < 0.5 { 0.0 } else { from(0.01, 0.2) };
            openings.push([x, z, w, h, -thick / 2.0 - more, thick / 2.0 + more]);
        }
        Self { degrees, size, openings }
    }

    /// The volume, by a partition of the wall's plane into pieces with the same openings.
    fn volume(&self) -> f64 {
        let [length, thick, high] = self.size;
        let cuts = |k: usize, end: f64| {
            let ends = self.openings.iter().flat_map(|o| [o[k], o[k] + o[k + 2]]).map(|c| c.clamp(0.0, end));
            let mut all: Vec<f64> = ends.chain([0.0, end]).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let mut volume = 0.0;
        for x in cuts(0, length).windows(2) {
            for z in cuts(1, high).windows(2) {
                let (u, v) = ((x[0] + x[1]) / 2.0, (z[0] + z[1]) / 2.0);
                let here = self.openings.iter().filter(|o| o[0] < u && u < o[0] + o[2] && o[1] < v && v < o[1] + o[3]);
                let mut depths: Vec<[f64; 2]> = here.map(|o| [o[4].max(-thick / 2.0), o[5].min(thick / 2.0)]).collect();
                depths.sort_by(|a, b| a[0].total_cmp(&b[0]));
                let (mut removed, mut to) = (0.0, f64::NEG_INFINITY);
                for [a, b] in depths {
                    removed += (b - a.max(to)).max(0.0);
                    to = to.max(b);
                }
                volume += (x[1] - x[0]) * (z[1] - z[0]) * (thick - removed);
            }
        }
        volume
    }
}

/// A STEP file being built.
pub struct File {
    text: String,
    pub last: u32,
}

impl File {
    pub fn new() -> Self {
        let text = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('x','2024-01-01T00:00:00',(''),(''),'','','');\n\
            FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n#1=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n#3=IFCUNITASSIGNMENT((#1));\n\
            #4=IFCCARTESIANPOINT((0.,0.,0.));\n#5=IFCAXIS2PLACEMENT3D(#4,$,$);\n\
            #6=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#5,$);\n#7=IFCPROJECT('p',$,'P',$,$,$,$,(#6),#3);\n\
            #8=IFCDIRECTION((0.,1.,0.));\n#9=IFCDIRECTION((0.,0.,1.));\n";
        Self { text: text.into(), last: 9 }
    }

    pub fn add(&mut self, record: std::fmt::Arguments) -> u32 {
        self.last += 1;
        let _ = writeln!(self.text, "#{}={record};", self.last);
        self.last
    }

    /// A box on a place and two axes: from there along the first for `depth`.
    pub fn body(&mut self, at: [f64; 3], axes: &str, [a, b, depth]: [f64; 3]) -> u32 {
        let point = self.add(format_args!("IFCCARTESIANPOINT(({:?},{:?},{:?}))", at[0], at[1], at[2]));
        let place = self.add(format_args!("IFCAXIS2PLACEMENT3D(#{point},{axes})"));
        let profile = self.add(format_args!("IFCRECTANGLEPROFILEDEF(.AREA.,$,$,{a:?},{b:?})"));
        let solid = self.add(format_args!("IFCEXTRUDEDAREASOLID(#{profile},#{place},#9,{depth:?})"));
        let shape = self.add(format_args!("IFCSHAPEREPRESENTATION(#6,'Body','SweptSolid',(#{solid}))"));
        self.add(format_args!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{shape}))"))
    }

    fn wall(mut self, wall: &Wall) -> Self {
        let (sin, cos) = wall.degrees.to_radians().sin_cos();
        let along = self.add(format_args!("IFCDIRECTION(({cos:?},{sin:?},0.))"));
        let place = self.add(format_args!("IFCAXIS2PLACEMENT3D(#4,#9,#{along})"));
        let place = self.add(format_args!("IFCLOCALPLACEMENT($,#{place})"));
        let [length, thick, high] = wall.size;
        let body = self.body([length / 2.0, 0.0, 0.0], "$,$", [length, thick, high]);
        let id = self.last + 1;
        let host = self.add(format_args!("IFCWALL('w{id}',$,'wall',$,$,#{place},#{body},$,$)"));
        for &[x, z, w, h, from, to] in &wall.openings {
            let body = self.body([x + w / 2.0, from, z + h / 2.0], "#8,#9", [h, w, to - from]);
            let local = self.add(format_args!("IFCLOCALPLACEMENT(#{place},#5)"));
            let id = self.last + 1;
            let hole = self.add(format_args!("IFCOPENINGELEMENT('o{id}',$,'o',$,$,#{local},#{body},$,.OPENING.)"));
            self.add(format_args!("IFCRELVOIDSELEMENT('v{id}',$,$,$,#{host},#{hole})"));
        }
        self
    }

    pub fn text(self) -> String {
        self.text + "ENDSEC;\nEND-ISO-10303-21;\n"
    }
}

/// A cut that cannot be judged is marked: an opening that cannot be meshed, or one whose surface is open.
#[test]
fn what_cannot_be_judged_is_marked() {
    let wall = Wall { degrees: 0.0, size: [4.0, 0.3, 3.0], openings: vec![[1.0, 1.0, 1.0, 1.0, -0.2, 0.2]] };
    let text = File::new().wall(&wall).text();
    let at = text.rfind("IFCEXTRUDEDAREASOLID").unwrap();
    let end = at + text[at..].find(';').unwrap();
    let with = |solid: &str| format!("{}{solid}{}", &text[..at], &text[end..]);
    let corners = "IFCCARTESIANPOINTLIST3D(((1.,-1.,1.),(2.,-1.,1.),(2.,1.,1.),(1.,1.,1.),\
        (1.,-1.,2.),(2.,-1.,2.),(2.,1.,2.),(1.,1.,2.)))";
    // A box without its lid.
    let open = format!(
        "IFCTRIANGULATEDFACESET(#900,$,.F.,((1,3,2),(1,4,3),(1,2,6),(1,6,5),(2,3,7),(2,7,6),(3,4,8),(3,8,7),(4,1,5),\
         (4,5,8)),$);\n#900={corners}"
    );
    for (solid, word) in [("IFCNOSUCHSOLID($)", "was not cut out"), (open.as_str(), "do not trust its openings")] {
        let model = model(with(solid).as_bytes()).unwrap();
        let said = &model.noted[0];
        assert!(said.0.starts_with("IfcWall wall") && said.1.contains(word), "{solid}: {said:?}");
    }
}

/// Of 200 walls at most 4 may be marked instead of right, none may be wrong without a mark.
#[test]
fn recesses_and_windows() {
    let mut random = SplitMix64(7);
    let walls: Vec<Wall> = (0..200).map(|_| Wall::random(&mut random)).collect();
    let file = walls.iter().fold(File::new(), File::wall);
    let model = model(file.text().as_bytes()).unwrap();
    let mut marked = 0;
    for (wall, product) in walls.iter().zip(&model.products) {
        let (seen, right) = (volume(product), wall.volume());
        marked += usize::from(product.note.is_some());
        let is_right = (seen / right - 1.0).abs() < 1e-3;
        let (degrees, openings) = (wall.degrees, &wall.openings);
        assert!(product.note.is_some() || is_right, "{degrees}°: {seen}, right is {right}: {openings:?}");
    }
    assert_eq!(model.products.len(), 200);
    assert!(marked <= 4, "{marked} marked: {:?}", model.noted);
}
