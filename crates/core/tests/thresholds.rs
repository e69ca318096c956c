//! The table of thresholds in docs/method.md is what the code says: made from the constants and their comments.
//!
//! `ASBUILT_WRITE=1 cargo test -p asbuilt-core --test thresholds` writes it anew.

use std::fs;
use std::path::{Path, PathBuf};

const BEGIN: &str = "<!-- Thresholds: made from the code by crates/core/tests/thresholds.rs -->\n";
const END: &str = "<!-- End of the thresholds -->\n";

/// Where beams and geometry are judged: files and folders, in the order of the method.
const PLACES: [&str; 17] = [
    "geometry/face.rs",
    "geometry/weld.rs",
    "evidence",
    "scan/tile.rs",
    "origin",
    "verify/aim",
    "verify/model",
    "verify/evidence/samples.rs",
    "verify/sights",
    "verify/collect",
    "verify/surface",
    "verify/verdict",
    "verify/change",
    "voxel/carve",
    "voxel/model",
    "voxel/occupancy/filter.rs",
    "voxel/change",
];

/// Numbers of layouts, of fixed-point units and of tables: nothing is judged by them.
const NOT_JUDGING: [&str; 18] = [
    "BEAMS_IN_KERNEL",
    "BLOCK",
    "CHUNK",
    "LANES",
    "DEVIATION",
    "KERNEL_STEPS",
    "LEN",
    "LOGARITHM",
    "MEAN_WEIGHT",
    "NONE",
    "PARTS",
    "PIECE",
    "STEPS_PER_UNIT",
    "TERMS",
    "TWO_PLANES",
    "VERSION",
    "WEIGHT",
    "BINS_PER_CELL",
];

struct Threshold {
    name: String,
    value: String,
    unit: &'static str,
    meaning: String,
    file: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The file, or those of the folder.
fn files(place: &Path) -> Vec<PathBuf> {
    if place.is_file() {
        return vec![place.into()];
    }
    let mut out: Vec<PathBuf> =
        fs::read_dir(place).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()).collect();
    out.sort();
    out
}

fn unit(name: &str, ty: &str) -> &'static str {
    match name {
        n if n.ends_with("_M") => "m",
        n if n.ends_with("_SIGMAS") || n == "CERTAINLY_OFF" || n == "HUBER" || n == "TUKEY" => "σ",
        n if n.ends_with("_COS") => "cosine",
        n if n.ends_with("_SPACINGS") => "beam spacings",
        "MAX_EXTENT" | "MAX_SLOPE" | "FALL" | "MIN_SPREAD" | "MAX_SPREAD" => "rad",
        _ if ty.starts_with('f') => "1",
        _ => "count",
    }
}

/// A constant of a number, its comment before it.
fn threshold(line: &str, comment: &str, file: &str) -> Option<Threshold> {
    let (_, rest) = line.split_once("const ")?;
    let (name, rest) = rest.split_once(": ")?;
    let (ty, value) = rest.split_once(';')?.0.split_once(" = ")?;
    let is_number = ["f64", "f32", "u64", "u32", "usize"].contains(&ty);
    (is_number && !NOT_JUDGING.contains(&name)).then(|| Threshold {
        name: name.into(),
        value: value.replace('_', ""),
        unit: unit(name, ty),
        meaning: comment.trim().into(),
        file: file.into(),
    })
}

fn thresholds() -> Vec<Threshold> {
    let mut out = Vec::new();
    for place in PLACES {
        for path in files(&root().join(place)) {
            let file = path.strip_prefix(root()).unwrap().to_string_lossy().into_owned();
            let text = fs::read_to_string(&path).unwrap();
            let mut comment = String::new();
            for line in text.split("#[cfg(test)]").next().unwrap().lines().map(str::trim) {
                match line.strip_prefix("///") {
                    Some(words) => comment += words,
                    None => {
                        out.extend(threshold(line, &comment, &file));
                        comment.clear();
                    }
                }
            }
        }
    }
    out
}

fn table(all: &[Threshold]) -> String {
    let mut out = String::from("\n| threshold | value | unit | meaning | file |\n| --- | --- | --- | --- | --- |\n");
    for t in all {
        // Links to code lead nowhere here.
        let meaning = t.meaning.replace("[`", "`").replace("`]", "`").replace('|', "\\|");
        let meaning = meaning.split("](").enumerate().map(|(i, part)| match i {
            0 => part.to_owned(),
            _ => part.split_once(')').map_or_else(String::new, |(_, rest)| rest.to_owned()),
        });
        let meaning = meaning.collect::<String>();
        out += &format!("| `{}` | {} | {} | {} | `{}` |\n", t.name, t.value, t.unit, meaning, t.file);
    }
    out + "\n"
}

#[test]
fn every_threshold_has_its_meaning_and_stands_in_the_method() {
    let all = thresholds();
    assert!(all.len() > 80, "{} thresholds found", all.len());
    let unsaid: Vec<_> =
        all.iter().filter(|t| t.meaning.is_empty()).map(|t| format!("{} {}", t.file, t.name)).collect();
    assert!(unsaid.is_empty(), "without a comment of their own: {unsaid:#?}");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/method.md");
    let page = fs::read_to_string(&path).unwrap();
    let (before, rest) = page.split_once(BEGIN).expect("the table's place");
    let (found, after) = rest.split_once(END).expect("the table's end");
    let made = table(&all);
    if std::env::var("ASBUILT_WRITE").is_ok() {
        fs::write(&path, [before, BEGIN, &made, END, after].concat()).unwrap();
    } else {
        assert!(found == made, "docs/method.md tells other thresholds: run this test with ASBUILT_WRITE=1");
    }
}
