//! Small valid files of every format that the loader reads, made here.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cluster::root;
use crate::files::program;

/// A wall of 100 returns in the plane x = 5.
fn points() -> Vec<[f32; 3]> {
    (0..100).map(|i| [5.0, (i % 10) as f32 * 0.02, (i / 10) as f32 * 0.02]).collect()
}

fn lines() -> String {
    points().iter().map(|p| format!("{} {} {}\n", p[0], p[1], p[2])).collect()
}

fn raw() -> Vec<u8> {
    points().iter().flatten().flat_map(|c| c.to_le_bytes()).collect()
}

/// Writes the files; their paths.
pub fn write(folder: &Path) -> Vec<PathBuf> {
    let mut files = vec![];
    let mut keep = |name: &str, bytes: Vec<u8>| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).expect("a seed");
        files.push(path);
    };
    keep("seed.xyz", lines().into());
    keep(
        "intensity.xyz",
        points()
            .iter()
            .map(|p| format!("{:.4},{:.4},{:.4},0.5,255,0,7\n", p[0], p[1], p[2]))
            .collect::<String>()
            .into(),
    );
    keep(
        "seed.pts",
        format!(
            "100\n{}",
            points().iter().map(|p| format!("{} {} {} -100 1 2 3\n", p[0], p[1], p[2])).collect::<String>()
        )
        .into(),
    );
    keep("seed.ptx", ptx().into());
    keep("ascii.ply", format!("{}{}", ply_header("ascii"), lines()).into());
    keep("binary.ply", [ply_header("binary_little_endian").into_bytes(), raw()].concat());
    keep(
        "big.ply",
        [
            ply_header("binary_big_endian").into_bytes(),
            points().iter().flatten().flat_map(|c| c.to_be_bytes()).collect(),
        ]
        .concat(),
    );
    keep("ascii.pcd", format!("{}{}", pcd_header("ascii"), lines()).into());
    keep("binary.pcd", [pcd_header("binary").into_bytes(), raw()].concat());
    keep("wall.ifc", std::fs::read(root().join("demo/pavilion.ifc")).expect("the demo's model"));
    for (name, format, compressed) in
        [("seed.las", 2, false), ("extended.las", 7, false), ("seed.laz", 2, true), ("extended.laz", 7, true)]
    {
        let path = folder.join(name);
        las(&path, format, compressed);
        files.push(path);
    }
    files.extend(e57(folder));
    files
}

fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex 100\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    )
}

fn pcd_header(data: &str) -> String {
    format!(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 100\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 100\nDATA {data}\n"
    )
}

fn ptx() -> String {
    let axes = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    let cells: String = points()
        .iter()
        .enumerate()
        .map(|(i, p)| if i % 7 == 3 { "0 0 0 0.5\n".into() } else { format!("{} {} {} 0.5\n", p[0], p[1], p[2]) })
        .collect();
    format!("10\n10\n{axes}{cells}")
}

fn las(path: &Path, format: u8, compressed: bool) {
    let mut builder = las::Builder::from((1, 4));
    builder.point_format = las::point::Format::new(format).unwrap();
    builder.point_format.is_compressed = compressed;
    let mut writer = las::Writer::from_path(path, builder.into_header().unwrap()).expect("a LAS file");
    for (i, p) in points().iter().enumerate() {
        let point = las::Point {
            x: p[0].into(),
            y: p[1].into(),
            z: p[2].into(),
            intensity: i as u16,
            color: Some(las::Color::new(1, 2, 3)),
            gps_time: (format == 7).then_some(i as f64),
            ..Default::default()
        };
        writer.write_point(point).expect("a point");
    }
    writer.close().expect("a LAS file");
}

/// By the program's own simulator, of few beams.
fn e57(folder: &Path) -> Option<PathBuf> {
    let (stations, out) = (folder.join("stations.txt"), folder.join("seed.e57"));
    std::fs::write(&stations, "2.0 2.2 1.6\n").expect("a file of stations");
    let run = Command::new(program())
        .args(["simulate", "--step-mrad", "60", "--stations"])
        .arg(&stations)
        .arg("--out")
        .arg(&out)
        .arg(root().join("demo/pavilion.ifc"))
        .output();
    let run = run.expect("the program asbuilt; build it, or name it in ASBUILT");
    if !run.status.success() {
        println!("attack: STALE: no E57 seed: {}", String::from_utf8_lossy(&run.stderr));
        return None;
    }
    Some(out)
}
