//! Each way in which a file tells glass, and what opens, in files of a few records.

use super::super::Product;
use super::super::field_tests::{File, model};

/// A file with products of several items.
struct Drawn {
    file: File,
    product: &'static str,
}

/// A box by its smallest and largest corner, metres.
type Cuboid = [[f64; 3]; 2];

const LEFT: Cuboid = [[0.0, 0.0, 0.0], [0.06, 0.1, 2.0]];
const RIGHT: Cuboid = [[0.94, 0.0, 0.0], [1.0, 0.1, 2.0]];
const TOP: Cuboid = [[0.06, 0.0, 1.94], [0.94, 0.1, 2.0]];
const SILL: Cuboid = [[0.06, 0.0, 0.0], [0.94, 0.1, 0.06]];
const LEAF: Cuboid = [[0.06, 0.02, 0.0], [0.94, 0.06, 1.94]];
const PANE: Cuboid = [[0.06, 0.04, 0.06], [0.94, 0.06, 1.94]];

impl Drawn {
    fn new(product: &'static str) -> Self {
        Self { file: File::new(), product }
    }

    fn add(&mut self, record: &str) -> u32 {
        self.file.add(format_args!("{record}"))
    }

    /// An item: a box.
    fn item(&mut self, cuboid: Cuboid) -> u32 {
        self.brep(&[cuboid])
    }

    /// One item of several boxes that do not touch each other by their vertices.
    fn brep(&mut self, cuboids: &[Cuboid]) -> u32 {
        let (mut points, mut faces) = (Vec::new(), Vec::new());
        for [low, high] in cuboids {
            let first = points.len() + 1;
            for i in 0..8 {
                let at: Vec<String> =
                    (0..3).map(|k| format!("{:?}", if i >> k & 1 == 1 { high[k] } else { low[k] })).collect();
                points.push(format!("({})", at.join(",")));
            }
            for q in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
                for t in [[q[0], q[1], q[2]], [q[0], q[2], q[3]]] {
                    faces.push(format!("({},{},{})", t[0] + first, t[1] + first, t[2] + first));
                }
            }
        }
        let list = self.add(&format!("IFCCARTESIANPOINTLIST3D(({}))", points.join(",")));
        self.add(&format!("IFCTRIANGULATEDFACESET(#{list},$,.T.,({}),$)", faces.join(",")))
    }

    /// A style of an item, of IFC4 or by an assignment as in IFC2x3.
    fn style(&mut self, item: u32, name: &str, rendering: &str, is_old: bool) -> u32 {
        let colour = self.add("IFCCOLOURRGB($,0.5,0.5,0.5)");
        let shading = self.add(&rendering.replace("(C", &format!("(#{colour}")));
        let mut style = self.add(&format!("IFCSURFACESTYLE('{name}',.BOTH.,(#{shading}))"));
        if is_old {
            style = self.add(&format!("IFCPRESENTATIONSTYLEASSIGNMENT((#{style}))"));
        }
        let item = if item == 0 { "$".to_owned() } else { format!("#{item}") };
        self.add(&format!("IFCSTYLEDITEM({item},(#{style}),$)"))
    }

    fn representation(&mut self, items: &[u32]) -> u32 {
        let items: Vec<String> = items.iter().map(|i| format!("#{i}")).collect();
        self.add(&format!("IFCSHAPEREPRESENTATION(#6,'Body','Tessellation',({}))", items.join(",")))
    }

    /// The product of these representations; its number.
    fn product(&mut self, representation: u32) -> u32 {
        let shape = self.add(&format!("IFCPRODUCTDEFINITIONSHAPE($,$,(#{representation}))"));
        let more = if self.product == "IFCWINDOW" || self.product == "IFCDOOR" { ",$,$,$,$,$,$" } else { ",$,$" };
        self.add(&format!("{}('p',$,'p',$,$,#5000,#{shape}{more})", self.product).replace("#5000", "$"))
    }

    fn of(mut self, items: &[u32]) -> Product {
        let representation = self.representation(items);
        self.product(representation);
        self.read()
    }

    fn read(self) -> Product {
        let mut model = model(self.file.text().as_bytes()).unwrap();
        assert_eq!(model.products.len(), 1, "{:?}", model.unmeshed);
        model.products.remove(0)
    }
}

const CLEAR: &str = "IFCSURFACESTYLERENDERING(C,0.75,$,$,$,$,$,$,.FLAT.)";
const SOLID: &str = "IFCSURFACESTYLERENDERING(C,0.,$,$,$,$,$,$,.FLAT.)";

/// Which boxes of a product are transparent, and which movable: by 12 triangles each, in the order of their places.
fn flags(product: &Product) -> Vec<(bool, bool)> {
    let solid = product.solid().unwrap().unwrap();
    let flag = |t: usize| (solid.is_transparent(t), solid.is_movable(t));
    (0..solid.triangles().len()).step_by(12).map(flag).collect()
}

fn transparent(product: &Product) -> Vec<bool> {
    flags(product).into_iter().map(|f| f.0).collect()
}

fn movable(product: &Product) -> Vec<bool> {
    flags(product).into_iter().map(|f| f.1).collect()
}

#[test]
fn surface_styles_tell_glass() {
    for (rendering, is_old, is_clear) in [
        (CLEAR, false, true),
        (CLEAR, true, true),
        ("IFCSURFACESTYLESHADING(C,0.6)", false, true),
        ("IFCSURFACESTYLESHADING(C)", true, false),
        (SOLID, false, false),
        ("IFCSURFACESTYLERENDERING(C,0.3,$,$,$,$,$,$,.FLAT.)", false, false),
    ] {
        let mut drawn = Drawn::new("IFCPLATE");
        let items = [drawn.item(LEFT), drawn.item(PANE)];
        drawn.style(items[1], "blue", rendering, is_old);
        let product = drawn.of(&items);
        assert_eq!(transparent(&product), [false, is_clear], "{rendering}");
        assert_eq!(product.parts[1].name.as_deref(), Some("blue"));
    }
}

#[test]
fn a_mapped_item_has_the_style_of_what_it_maps_or_its_own() {
    for on_map in [false, true] {
        let mut drawn = Drawn::new("IFCPLATE");
        let item = drawn.item(PANE);
        let inner = drawn.representation(&[item]);
        let map = drawn.add(&format!("IFCREPRESENTATIONMAP(#5,#{inner})"));
        let target = drawn.add("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#4,1.,$)");
        let mapped = drawn.add(&format!("IFCMAPPEDITEM(#{map},#{target})"));
        drawn.style(if on_map { mapped } else { item }, "Glas", SOLID, false);
        assert_eq!(transparent(&drawn.of(&[mapped])), [true], "on the map: {on_map}");
    }
}

#[test]
fn materials_tell_glass() {
    let of = |records: &[&str]| {
        let mut drawn = Drawn::new("IFCPLATE");
        let item = drawn.item(PANE);
        let representation = drawn.representation(&[item]);
        let product = drawn.product(representation);
        // `@n` is the record n before.
        let mut last = product;
        for record in records {
            let back = |n: u32| format!("#{}", last + 1 - n);
            let record = (1..9).fold(record.to_string(), |r, n| r.replace(&format!("@{n}"), &back(n)));
            last = drawn.add(&record);
        }
        drawn.add(&format!("IFCRELASSOCIATESMATERIAL('m',$,$,$,(#{product}),#{last})"));
        transparent(&drawn.read())[0]
    };
    let list = "IFCMATERIALLIST((@2,@1))";
    assert!(of(&["IFCMATERIAL('Float glass 6 mm',$,$)"]));
    assert!(of(&["IFCMATERIAL('Verre',$,$)", "IFCMATERIALLIST((@1))"]));
    assert!(!of(&["IFCMATERIAL('Glass wool',$,$)"]));
    assert!(!of(&["IFCMATERIAL('Glass',$,$)", "IFCMATERIAL('Wood',$,$)", list]));
    assert!(of(&["IFCMATERIAL('Glass',$,$)", "IFCMATERIAL('Air gap',$,$)", list]));
    let layers = ["IFCMATERIAL('Glas',$,$)", "IFCMATERIALLAYER(@1,0.006,$,$,$,$,$)", "IFCMATERIALLAYERSET((@1),$,$)"];
    assert!(of(&layers));
    // A material with a style of its own.
    assert!(of(&[
        "IFCSURFACESTYLERENDERING($,0.9,$,$,$,$,$,$,.FLAT.)",
        "IFCSURFACESTYLE('s',.BOTH.,(@1))",
        "IFCSTYLEDITEM($,(@1),$)",
        "IFCSTYLEDREPRESENTATION(#6,$,$,(@1))",
        "IFCMATERIAL('X12',$,$)",
        "IFCMATERIALDEFINITIONREPRESENTATION($,$,(@2),@1)",
        "IFCMATERIALLIST((@2))",
    ]));
}

/// Constituents are matched to items by the names of shape aspects; what those say of doors and windows counts too.
#[test]
fn shape_aspects_tell_what_items_are() {
    let mut drawn = Drawn::new("IFCWINDOW");
    let items = [drawn.brep(&[LEFT, RIGHT, TOP, SILL]), drawn.item(PANE)];
    for (name, item) in [("Lining", items[0]), ("Infill", items[1])] {
        let representation = drawn.representation(&[item]);
        drawn.add(&format!("IFCSHAPEASPECT((#{representation}),'{name}',$,.U.,$)"));
    }
    let representation = drawn.representation(&items);
    let product = drawn.product(representation);
    let wood = drawn.add("IFCMATERIAL('Pine',$,$)");
    let glass = drawn.add("IFCMATERIAL('Glass',$,$)");
    let lining = drawn.add(&format!("IFCMATERIALCONSTITUENT('Lining',$,#{wood},$,$)"));
    let infill = drawn.add(&format!("IFCMATERIALCONSTITUENT('infill',$,#{glass},$,$)"));
    let set = drawn.add(&format!("IFCMATERIALCONSTITUENTSET($,$,(#{lining},#{infill}))"));
    drawn.add(&format!("IFCRELASSOCIATESMATERIAL('m',$,$,$,(#{product}),#{set})"));
    assert_eq!(transparent(&drawn.read()), [false, false, false, false, true]);

    let mut drawn = Drawn::new("IFCDOOR");
    let items = [drawn.item(LEAF), drawn.item(PANE)];
    for (name, item) in [("Framing", items[0]), ("Glazing", items[1])] {
        let representation = drawn.representation(&[item]);
        drawn.add(&format!("IFCSHAPEASPECT((#{representation}),'{name}',$,.U.,$)"));
    }
    assert_eq!(flags(&drawn.of(&items)), [(false, true), (true, true)]);
}

#[test]
fn a_leaf_within_a_frame_moves() {
    let mut drawn = Drawn::new("IFCDOOR");
    let handle = [[0.8, -0.05, 1.0], [0.9, 0.02, 1.05]];
    let frame = drawn.brep(&[LEFT, RIGHT, TOP]);
    let items = [frame, drawn.item(LEAF), drawn.item(handle)];
    assert_eq!(movable(&drawn.of(&items)), [false, false, false, true, true]);
    // The same in one item.
    let mut drawn = Drawn::new("IFCDOOR");
    let threshold = [[0.06, 0.0, 0.0], [0.94, 0.1, 0.02]];
    let leaf = [[0.07, 0.02, 0.03], [0.93, 0.06, 1.93]];
    let all = drawn.brep(&[LEFT, RIGHT, TOP, threshold, leaf]);
    assert_eq!(movable(&drawn.of(&[all])), [false, false, false, false, true]);
    // Nothing can be told apart.
    let mut drawn = Drawn::new("IFCDOOR");
    let all = drawn.item(LEAF);
    assert_eq!(movable(&drawn.of(&[all])), [true]);
    // No door.
    let mut drawn = Drawn::new("IFCPLATE");
    let items = [drawn.brep(&[LEFT, RIGHT, TOP]), drawn.item(LEAF)];
    assert_eq!(movable(&drawn.of(&items)), [false; 4]);
}

#[test]
fn sashes_move_and_panes_in_a_frame_do_not() {
    let frame = [LEFT, RIGHT, TOP, SILL];
    let sash = [
        [[0.07, 0.02, 0.07], [0.13, 0.08, 1.93]],
        [[0.87, 0.02, 0.07], [0.93, 0.08, 1.93]],
        [[0.13, 0.02, 1.87], [0.87, 0.08, 1.93]],
        [[0.13, 0.02, 0.07], [0.87, 0.08, 0.13]],
    ];
    let pane = [[0.13, 0.04, 0.13], [0.87, 0.06, 1.87]];
    let window = |inner: &[Cuboid], pane: Cuboid, more: &str| {
        let mut drawn = Drawn::new("IFCWINDOW");
        let mut items = vec![drawn.brep(&frame)];
        if !inner.is_empty() {
            items.push(drawn.brep(inner));
        }
        items.push(drawn.item(pane));
        drawn.style(*items.last().unwrap(), "glass", CLEAR, false);
        let representation = drawn.representation(&items);
        let product = drawn.product(representation);
        if !more.is_empty() {
            let set = drawn.add(more);
            drawn.add(&format!("IFCRELDEFINESBYPROPERTIES('r',$,$,$,(#{product}),#{set})"));
        }
        movable(&drawn.read())
    };
    assert_eq!(window(&sash, pane, ""), [[false; 4], [true; 4]].concat().into_iter().chain([true]).collect::<Vec<_>>());
    assert_eq!(window(&[], PANE, ""), [false; 5]);
    // Where everything is named as a sash the names tell nothing.
    let mut drawn = Drawn::new("IFCWINDOW");
    let items = [drawn.brep(&frame), drawn.brep(&sash)];
    for item in items {
        drawn.style(item, "Sash", SOLID, false);
    }
    assert_eq!(movable(&drawn.of(&items)), [[false; 4], [true; 4]].concat());
    // A mullion and a transom between fixed panes.
    let bars = [[[0.48, 0.02, 0.06], [0.52, 0.08, 1.94]], [[0.06, 0.02, 0.9], [0.94, 0.08, 0.95]]];
    assert_eq!(window(&bars, PANE, ""), [false; 7]);
    let fixed = "IFCWINDOWPANELPROPERTIES('w',$,$,$,.FIXEDCASEMENT.,.MIDDLE.,$,$,$)";
    assert_eq!(window(&sash, pane, fixed), [false; 9]);
    let opens = "IFCWINDOWPANELPROPERTIES('w',$,$,$,.SIDEHUNGLEFTHAND.,.LEFT.,$,$,$)";
    assert_eq!(window(&sash, pane, opens)[4..], [true; 5]);
}

/// A leaf hangs above its threshold: what is screwed on at its foot, a kick plate, goes with it.
#[test]
fn a_kick_plate_moves_with_its_leaf() {
    let boxes: [Cuboid; 6] = [
        [[0.0, 0.0, 0.0], [0.05, 0.1, 2.0]],
        [[0.95, 0.0, 0.0], [1.0, 0.1, 2.0]],
        [[0.05, 0.0, 1.95], [0.95, 0.1, 2.0]],
        [[0.05, 0.0, 0.0], [0.95, 0.1, 0.008]],
        [[0.05, 0.02, 0.01], [0.95, 0.06, 1.95]],
        [[0.06, 0.0, 0.01], [0.94, 0.02, 0.1]],
    ];
    let mut drawn = Drawn::new("IFCDOOR");
    let items: Vec<u32> = boxes.into_iter().map(|b| drawn.item(b)).collect();
    assert_eq!(movable(&drawn.of(&items)), [false, false, false, false, true, true]);
}

/// Objects by class in the models of others: how many there are, with transparent parts, with movable ones.
type Counts = std::collections::BTreeMap<String, [usize; 3]>;

fn counts(file: &std::path::Path) -> Counts {
    let mut counts = Counts::new();
    for product in model(&std::fs::read(file).unwrap()).map_or_else(|_| Vec::new(), |m| m.products) {
        let [is_transparent, is_movable] = product.flags();
        let of_class = counts.entry(product.ifc_class).or_default();
        *of_class = [of_class[0] + 1, of_class[1] + usize::from(is_transparent), of_class[2] + usize::from(is_movable)];
    }
    counts
}

/// Prints what is flagged in every model; with `--nocapture` to be read.
#[test]
#[ignore = "needs ../shared/data"]
fn models_of_others() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let mut of_duplex = Counts::new();
    for folder in std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()).filter(|f| f.is_dir()) {
        let files = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path());
        for file in files.filter(|f| f.extension().is_some_and(|e| e == "ifc")) {
            let counts = counts(&file);
            for (class, [all, transparent, movable]) in counts.iter().filter(|(_, c)| c[1] + c[2] > 0) {
                println!("{}: {class} {all}, transparent {transparent}, movable {movable}", file.display());
            }
            if file.ends_with("Duplex_A_20110907.ifc") {
                of_duplex = counts;
            }
        }
    }
    assert_eq!(of_duplex["IfcDoor"][2], of_duplex["IfcDoor"][0], "every door has a leaf");
    // Two of 24 are skylights of a single item without any style; 4 are casements, the others are named as fixed.
    assert_eq!(of_duplex["IfcWindow"], [24, 22, 4]);
    assert_eq!(of_duplex["IfcWallStandardCase"][1..], [0, 0]);
}
