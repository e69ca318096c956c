//! The rooms of `verify` are entered from left to right, and no files in them go round in a circle.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The stages of the method, in order.
const ROOMS: [&str; 6] = ["aim", "model", "evidence", "collect", "surface", "verdict"];

/// For each file of a room its text without comments and tests.
fn files(room: &str) -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/verify").join(room);
    let mut out = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let text = text.split("#[cfg(test)]").next().unwrap();
        let code: Vec<&str> = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect();
        out.insert(path.file_stem().unwrap().to_str().unwrap().to_owned(), code.join("\n"));
    }
    assert!(out.len() > 3, "{room} has {} files", out.len());
    out
}

/// The names that follow `path` in a text.
fn after<'a>(text: &'a str, path: &'a str) -> impl Iterator<Item = &'a str> {
    let name = |rest: &'a str| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap();
    text.match_indices(path)
        .filter(|(i, _)| !text[..*i].ends_with('$'))
        .map(move |(i, _)| name(&text[i + path.len()..]))
}

#[test]
fn a_room_uses_only_those_before_it() {
    let mut arrows = 0;
    for (place, room) in ROOMS.iter().enumerate() {
        for (file, text) in files(room) {
            for used in after(&text, "crate::verify::") {
                let other = ROOMS.iter().position(|r| *r == used);
                assert!(other.is_some_and(|o| o < place), "{room}/{file}.rs uses verify::{used}");
                arrows += 1;
            }
            assert!(!text.contains("super::super"), "{room}/{file}.rs looks up two floors");
        }
    }
    assert!(arrows > 50, "{arrows}");
}

#[test]
fn files_of_a_room_have_an_order() {
    for room in ROOMS {
        let mut left = files(room);
        left.remove("mod");
        while !left.is_empty() {
            let is_free = |text: &str| !after(text, "super::").any(|used| left.contains_key(used));
            let free: Vec<String> = left.iter().filter(|(_, t)| is_free(t)).map(|(f, _)| f.clone()).collect();
            assert!(!free.is_empty(), "{room}: {:?} go round in a circle", left.keys());
            free.iter().for_each(|f| drop(left.remove(f)));
        }
    }
}
