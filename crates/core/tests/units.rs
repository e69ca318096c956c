//! Public functions that take or give lengths, angles or vectors say in what unit, or in which frame. Those of `num` work
//! on plain numbers.

use std::fs;
use std::path::{Path, PathBuf};

/// One of these in the comment tells it: a unit, a frame, or that the number has none.
const TELLING: [&str; 38] = [
    "metre",
    " m ",
    " m,",
    " m.",
    " m;",
    " m)",
    "m²",
    "m³",
    "radian",
    " rad",
    "SI unit",
    "unit of",
    "unit distance",
    "without unit",
    "σ",
    "share",
    "probab",
    "ratio",
    "belie",
    "mass",
    "plausib",
    "confiden",
    "between 0 and 1",
    "world",
    "local",
    "scanner",
    "frame",
    "voxel",
    "direction",
    "axis",
    "axes",
    "normal",
    "tangent",
    "quant",
    "covarian",
    "varian",
    "commonalit",
    "significan",
];

fn sources(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
}

/// The public functions of a source with their comments and signatures, up to the body.
fn functions(text: &str) -> Vec<(String, String)> {
    let (mut comment, mut out) = (String::new(), Vec::new());
    let mut lines = text.split("#[cfg(test)]").next().unwrap().lines();
    while let Some(line) = lines.next().map(str::trim) {
        if let Some(words) = line.strip_prefix("///") {
            comment += words;
            comment.push(' ');
        } else if line.starts_with("pub fn ") {
            let mut signature = line.to_owned();
            while !signature.contains('{') {
                let Some(more) = lines.next() else { break };
                signature += more;
            }
            out.push((std::mem::take(&mut comment), signature.split('{').next().unwrap().to_owned()));
        } else if !line.starts_with("#[") {
            comment.clear();
        }
    }
    out
}

#[test]
fn public_functions_tell_their_units_or_frames() {
    let (mut files, mut silent, mut asked) = (Vec::new(), Vec::new(), 0);
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut files);
    for file in &files {
        if file.parent().is_some_and(|folder| folder.ends_with("num")) {
            continue;
        }
        for (comment, signature) in functions(&fs::read_to_string(file).unwrap()) {
            let has_numbers = ["f64", "f32", "Vec3"].iter().any(|ty| signature.contains(ty));
            asked += u32::from(has_numbers);
            if has_numbers && !TELLING.iter().any(|word| comment.to_lowercase().contains(&word.to_lowercase())) {
                silent.push(format!("{}: {signature}", file.display()));
            }
        }
    }
    assert!(asked > 200, "{asked} functions with numbers found");
    assert!(silent.is_empty(), "in what unit, or in which frame?\n{}", silent.join("\n"));
}
