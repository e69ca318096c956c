//! The models that the project ships (demo, demo/models): what the generator writes, and read whole.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use asbuilt_core::geometry::Closedness;

use super::IfcModel;
use super::field_tests::model;

/// Products by class.
type Counts<'a> = &'a [(&'a str, usize)];

const OFFICE: Counts = &[
    ("IfcBeam", 1),
    ("IfcBuildingElementProxy", 1),
    ("IfcCableCarrierSegment", 1),
    ("IfcColumn", 7),
    ("IfcCovering", 56),
    ("IfcCurtainWall", 1),
    ("IfcDoor", 11),
    ("IfcDuctSegment", 6),
    ("IfcFurniture", 66),
    ("IfcLightFixture", 19),
    ("IfcMember", 62),
    ("IfcPipeSegment", 4),
    ("IfcPlate", 26),
    ("IfcRailing", 2),
    ("IfcSanitaryTerminal", 5),
    ("IfcSlab", 4),
    ("IfcSpaceHeater", 10),
    ("IfcStair", 1),
    ("IfcStairFlight", 2),
    ("IfcWall", 27),
    ("IfcWindow", 17),
];

const HOUSE: Counts = &[
    ("IfcBeam", 33),
    ("IfcBuildingElementProxy", 1),
    ("IfcCovering", 44),
    ("IfcDoor", 6),
    ("IfcEnergyConversionDevice", 5),
    ("IfcFlowSegment", 4),
    ("IfcFlowTerminal", 8),
    ("IfcFurnishingElement", 15),
    ("IfcMember", 2),
    ("IfcPlate", 1),
    ("IfcRailing", 3),
    ("IfcRoof", 1),
    ("IfcSlab", 5),
    ("IfcStair", 1),
    ("IfcStairFlight", 1),
    ("IfcWall", 11),
    ("IfcWindow", 12),
];

fn demo() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../demo")
}

/// Runs the generator; `None`, loudly, where there is no Python.
fn make_model(arguments: &[&Path]) -> Option<Vec<u8>> {
    let mut python = Command::new("python3");
    let run = python.arg("-B").arg(demo().join("make_model.py")).args(arguments).output();
    let Ok(out) = run else {
        eprintln!("SKIPPED: there is no python3");
        return None;
    };
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    Some(out.stdout)
}

fn shipped(name: &str) -> Vec<u8> {
    std::fs::read(demo().join(name)).unwrap()
}

#[test]
fn the_shipped_models_are_what_the_generator_writes() {
    let Some(pavilion) = make_model(&[]) else { return };
    assert!(pavilion == shipped("pavilion.ifc"), "demo/pavilion.ifc");
    let folder = std::env::temp_dir().join(format!("asbuilt-shipped-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for kind in ["office", "house"] {
        let (out, stations) = (format!("{kind}.ifc"), format!("{kind}-stations.txt"));
        let [out_path, stations_path] = [&out, &stations].map(|name| folder.join(name));
        make_model(&[Path::new(kind), Path::new("--stations"), &stations_path, &out_path]).unwrap();
        for name in [out, stations] {
            let written = std::fs::read(folder.join(&name)).unwrap();
            assert!(written == shipped(&format!("models/{name}")), "demo/models/{name}");
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Every product with its class, a storey and a closed solid (a whole has that of its parts); nothing to tell.
fn read_whole(name: &str, counts: Counts) -> IfcModel {
    let bytes = shipped(&format!("models/{name}"));
    assert!(bytes.len() < 400_000, "{name}");
    let model = model(&bytes).unwrap();
    let mut seen = BTreeMap::new();
    for p in &model.products {
        *seen.entry(p.ifc_class.as_str()).or_insert(0) += 1;
        let solid = p.solid().unwrap().unwrap_or_else(|| panic!("{} has no mesh", p.shown()));
        assert!(solid.closedness() != Closedness::Open && solid.volume().unwrap() > 0.0, "{}", p.shown());
        assert!(p.storey.is_some(), "{}", p.shown());
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), counts, "{name}");
    assert_eq!((&model.unmeshed[..], &model.noted[..], &model.warnings[..]), (&[][..], &[][..], &[][..]), "{name}");
    model
}

#[test]
fn the_office_is_read_whole() {
    let office = read_whole("office.ifc", OFFICE);
    let area: f64 = office.products.iter().map(|p| p.solid().unwrap().unwrap().area()).sum();
    // Four such storeys have more than 20 000 m², 50 million samples at 2 cm: scripts/bench/7-storeys.sh.
    assert!((6_000.0..8_000.0).contains(&area), "{area} m²");
}

#[test]
fn the_house_is_read_whole() {
    let house = read_whole("house.ifc", HOUSE);
    let rafters: Vec<_> = house.products.iter().filter(|p| p.name.starts_with("Sparren")).collect();
    assert_eq!(rafters.len(), 24);
    for rafter in rafters {
        // 0.08 by 0.2 m, from the eaves to the upright joint at the ridge.
        let volume = rafter.solid().unwrap().unwrap().volume().unwrap();
        assert!((volume / 0.0876 - 1.0).abs() < 1e-3, "{}: {volume} m³", rafter.name);
    }
}

/// Of every door the lining stays and the leaf moves, with panes and handles, though of steel both are called a frame.
#[test]
fn of_doors_the_lining_stays_and_the_leaf_moves() {
    for name in ["office.ifc", "house.ifc"] {
        let doors = model(&shipped(&format!("models/{name}"))).unwrap().products.into_iter();
        for door in doors.filter(|p| p.ifc_class == "IfcDoor") {
            let moves: Vec<bool> = door.parts.iter().map(|p| p.is_movable).collect();
            let expected: Vec<bool> = (0..moves.len()).map(|part| part > 0).collect();
            assert_eq!(moves, expected, "{}", door.shown());
        }
    }
}
