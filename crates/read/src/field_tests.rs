//! Scans as they occur in the field, each with its right answer.

use std::path::{Path, PathBuf};

use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;

use super::{RawScan, ReadOptions, read_scans};

/// What reading must return.
enum ExpectedScan {
    /// The five points, all without origin, and words that a note must contain.
    Five(&'static str),
    /// Number of points, whether they have an origin, and words that a note must contain.
    Points(&'static [[f64; 3]], bool, &'static str),
    /// Number of points, without origin, and words that a note must contain.
    Count(usize, &'static str),
    /// An error with these words.
    Refused(&'static str),
}

use ExpectedScan::{Count, Five, Points, Refused};

const FIVE: [[f64; 3]; 5] =
    [[1.25, 2.5, 0.75], [1.5, 2.5, 0.75], [1.75, 2.5, 0.75], [1.25, 2.75, 0.75], [1.5, 2.75, 1.0]];
const TWO: &[[f64; 3]] = &[[1.25, 2.5, 0.75], [1.5, 2.5, 0.75]];
const UTM: &[[f64; 3]] = &[[500_000.12, 5_400_000.45, 101.5], [500_000.13, 5_400_000.46, 101.6]];
/// The five points, moved by (2000000, 700000, 100) and rounded to a thousandth of a foot.
const FEET: &[[f64; 3]] = &[
    [2_000_001.25, 700_002.5, 100.75],
    [2_000_001.5, 700_002.5, 100.75],
    [2_000_001.75, 700_002.5, 100.75],
    [2_000_001.25, 700_002.75, 100.75],
    [2_000_001.5, 700_002.75, 101.0],
];

fn read(path: &Path, options: &ReadOptions) -> anyhow::Result<Vec<RawScan>> {
    let mut scans = Vec::new();
    read_scans(path, options, &ProgressBar::hidden(), &mut |scan| {
        scans.push(scan);
        Ok(())
    })?;
    Ok(scans)
}

fn world(scan: &RawScan) -> Vec<Vec3> {
    scan.content.beams.iter().filter(|b| b.returned).map(|b| scan.anchor + b.offset).collect()
}

/// What is wrong, if anything.
fn judge(path: &Path, options: &ReadOptions, right: &ExpectedScan) -> Result<(), String> {
    let scans = match (read(path, options), right) {
        (Err(e), Refused(words)) if format!("{e:#}").contains(words) => return Ok(()),
        (Err(e), _) => return Err(format!("refused: {e:#}")),
        (Ok(scans), Refused(_)) => {
            return Err(format!("read, and gave {:?}", scans.iter().map(world).collect::<Vec<_>>()));
        }
        (Ok(scans), _) => scans,
    };
    let points: Vec<Vec3> = scans.iter().flat_map(world).collect();
    let said = scans.iter().flat_map(|s| s.notes.clone()).collect::<Vec<_>>().join("; ");
    let (expected, has_origin, words): (&[[f64; 3]], bool, &str) = match *right {
        Five(words) => (&FIVE, false, words),
        Points(points, has_origin, words) => (points, has_origin, words),
        Count(count, words) => {
            let fits =
                points.len() == count && said.contains(words) && scans.iter().all(|s| s.world_from_scan.is_none());
            return if fits { Ok(()) } else { Err(format!("{} points, said \"{said}\"", points.len())) };
        }
        Refused(_) => (&[], false, ""),
    };
    let same = points.len() == expected.len()
        && points.iter().zip(expected).all(|(a, b)| (a - Vec3::from(*b)).amax() < if b[0] > 1e6 { 2e-4 } else { 1e-6 });
    let origins = scans.iter().all(|s| s.world_from_scan.is_some() == has_origin);
    if same && origins && said.contains(words) {
        Ok(())
    } else {
        Err(format!("{points:?}, origins right {origins}, said \"{said}\""))
    }
}

/// Files of the data folder beside the project, where it exists.
#[test]
fn files_of_the_field() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/field");
    if !folder.exists() {
        eprintln!("SKIPPED: {} is not there", folder.display());
        return;
    }
    let plain = ReadOptions::default;
    let columns = |c: &str| ReadOptions { columns: Some(c.parse().unwrap()), ..plain() };
    let noisy = ReadOptions { keep_noise: true, ..plain() };
    let cases: Vec<(&str, ReadOptions, ExpectedScan)> = vec![
        ("e57_merged_identity_pose.e57", plain(), Count(9148, "merged cloud")),
        ("e57_identity_pose_local_grid.e57", plain(), Count(1600, "far from zero")),
        ("ptx_identity_local_grid.ptx", plain(), Count(48, "far from zero")),
        ("e57_duplicate_namespace.e57", plain(), Count(1600, "twice")),
        ("e57_latin1_xml.e57", plain(), Count(1600, "Latin-1")),
        ("las_us_survey_feet.las", plain(), Points(FEET, false, "US survey feet")),
        ("las_wkt_feet.las", plain(), Points(FEET, false, "US survey feet")),
        ("las_degrees.las", plain(), Refused("degrees")),
        ("las_legacy_count_smaller.las", plain(), Five("count of version 1.4")),
        ("las_noise.las", noisy, Five("kept")),
        ("las_vertft.las", plain(), Points(FEET, false, "heights in feet")),
        ("las_withheld.las", plain(), Count(3, "2 withheld points dropped")),
        ("las_noise.las", plain(), Count(3, "2 points classified as noise")),
        ("pcd_integer_xyz.pcd", plain(), Count(5, "")),
        ("ptx_one_column_of_1500000.ptx", plain(), Count(2, "promises 1500000 points and holds 2")),
        ("las_version_1_5.las", plain(), Five("newer")),
        ("las_vlr_count_too_high.las", plain(), Five("records")),
        ("las12_scale0.las", plain(), Refused("scale")),
        ("pcd_uppercase_xyz.pcd", plain(), Five("")),
        ("ply_uppercase_xyz.ply", plain(), Five("")),
        ("pcd_comma.pcd", plain(), Five("")),
        ("pcd_duplicate_field.pcd", plain(), Five("")),
        ("pcd_zero_returns.pcd", plain(), Points(TWO, false, "3 points at 0 0 0")),
        ("ply_decimal_comma.ply", plain(), Five("")),
        ("ply_list_before_xyz_ascii.ply", plain(), Five("")),
        ("ply_uint64_property.ply", plain(), Five("")),
        ("ply_latin1_comment.ply", plain(), Five("")),
        ("ply_bom.ply", plain(), Five("")),
        ("ply_bom_in_data.ply", plain(), Five("")),
        ("ply_cr_line_ends.ply", plain(), Five("")),
        ("pts_more_than_counted.pts", plain(), Five("promises 4 points and holds 5")),
        ("pts_count_zero.pts", plain(), Five("promises 0 points and holds 5")),
        ("xyz_thousands_separator.xyz", plain(), Points(UTM, false, "")),
        ("xyz_apostrophe.xyz", plain(), Points(UTM, false, "")),
        ("xyz_point_number_first.xyz", plain(), Refused("--columns n,x,y,z")),
        ("xyz_point_number_first.xyz", columns("n,x,y,z"), Five("")),
        ("xyz_latin1_title.xyz", plain(), Five("title lines")),
        ("xyz_utf16.xyz", plain(), Five("")),
        ("xyz_three_title_lines.xyz", plain(), Five("3 title lines")),
        ("xyz_quoted.xyz", plain(), Points(TWO, false, "")),
        ("xyz_pipe.xyz", plain(), Points(TWO, false, "")),
        ("xyz_cr.xyz", plain(), Five("")),
    ];
    let wrong: Vec<String> =
        cases.iter().filter_map(|(name, options, right)| wrong(&folder.join(name), options, right)).collect();
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// The file and what is wrong with it, shortened.
fn wrong(path: &Path, options: &ReadOptions, right: &ExpectedScan) -> Option<String> {
    let why = judge(path, options, right).err()?;
    Some(format!("{}: {}", path.display(), why.chars().take(400).collect::<String>()))
}

const ROWS: &str = "1.25 2.5 0.75\n1.5 2.5 0.75\n1.75 2.5 0.75\n1.25 2.75 0.75\n1.5 2.75 1\n";

fn ply(properties: &str, rows: &str) -> String {
    format!("ply\nformat ascii 1.0\nelement vertex 5\n{properties}end_header\n{rows}")
}

fn pcd(fields: &str, kind: &str, viewpoint: &str, rows: &str) -> String {
    let count = rows.lines().count();
    format!(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS {fields}\nSIZE 4 4 4\nTYPE {kind}\nCOUNT 1 1 1\nWIDTH {count}\nHEIGHT 1\nVIEWPOINT {viewpoint}\nPOINTS {count}\nDATA ascii\n{rows}"
    )
}

/// Files of the same kinds, generated here.
#[test]
fn files_of_our_own() {
    const NONE: &str = "0 0 0 1 0 0 0";
    let floats = "property float x\nproperty float y\nproperty float z\n";
    let list = format!("property list uchar int view\n{floats}");
    let with = |edit: fn(&str) -> String| ROWS.lines().map(|l| edit(l) + "\n").collect::<String>();
    let numbered: String = ROWS.lines().enumerate().map(|(i, l)| format!("{} {l}\n", i + 1)).collect();
    let cases: Vec<(&str, String, ExpectedScan)> = vec![
        ("a.xyz", ROWS.into(), Five("")),
        ("a.dat", ROWS.replace('\n', "\r"), Five("")),
        ("comma.csv", with(|l| l.replace(' ', ",")), Five("")),
        ("quoted.csv", with(|l| format!("\"{}\"", l.replace(' ', "\",\""))), Five("")),
        ("semicolon.txt", with(|l| l.replace('.', ",").replace(' ', ";")), Five("")),
        ("pipe.asc", with(|l| l.replace(' ', "|")), Five("")),
        ("named.txt", format!("//X Y Z\n{ROWS}"), Five("")),
        ("number.txt", numbered.clone(), Refused("--columns n,x,y,z")),
        ("named_number.txt", format!("n x y z\n{numbered}"), Five("title names")),
        ("turned.txt", format!("y x z\n{ROWS}"), Refused("--columns")),
        ("points.txt", with(|l| format!("P {l}")), Refused("--columns")),
        ("ambiguous.txt", "1,234 2,345 3,456\n".into(), Refused("--decimal-comma")),
        ("short.pts", format!("6\n{ROWS}"), Refused("cut short")),
        ("long.pts", format!("4\n{ROWS}"), Five("holds 5")),
        ("words.xyz", "nothing here\n".into(), Refused("nothing here")),
        ("binary.xyz", "1 2 3\n\0\0\0".into(), Refused("no text")),
        ("a.ply", ply(floats, ROWS), Five("")),
        ("capitals.ply", ply(&floats.replace(" x", " X").replace(" y", " Y").replace(" z", " Z"), ROWS), Five("")),
        ("comma.ply", ply(floats, &ROWS.replace('.', ",")), Five("")),
        ("list.ply", ply(&list, &with(|l| format!("2 7 8 {l}"))), Five("")),
        ("cut.ply", ply(floats, "1 2 3\n"), Refused("more than the file holds")),
        ("a.pcd", pcd("x y z", "F F F", NONE, ROWS), Five("")),
        ("capitals.pcd", pcd("X Y Z", "F F F", NONE, ROWS), Five("")),
        ("whole.pcd", pcd("x y z", "I I I", NONE, "1000 2000 3000\n"), Points(&[[1000.0, 2000.0, 3000.0]], false, "")),
        (
            "zeros.pcd",
            pcd("x y z", "F F F", NONE, "1.25 2.5 0.75\n0 0 0\n1.5 2.5 0.75\n-0.0 0 0\n"),
            Points(TWO, false, "2 points at 0 0 0"),
        ),
        // A quarter turn about z: the scanner's x is the world's y.
        (
            "pose.pcd",
            pcd("x y z", "F F F", "10 20 30 0.70710678118654752 0 0 0.70710678118654752", "1 0 0\n2 0 0\n"),
            Points(&[[10.0, 21.0, 30.0], [10.0, 22.0, 30.0]], true, ""),
        ),
        (
            "place.pcd",
            pcd("x y z", "F F F", "10 20 30 1 0 0 0", "1 0 0\n"),
            Points(&[[11.0, 20.0, 30.0]], true, "scanner's frame"),
        ),
        ("no_z.pcd", pcd("x y w", "F F F", NONE, ROWS), Refused("they have x y w")),
    ];
    let folder = std::env::temp_dir().join(format!("asbuilt-field-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let judged = |(name, content, right): &(&str, String, ExpectedScan)| {
        std::fs::write(folder.join(name), content).unwrap();
        wrong(&folder.join(name), &ReadOptions::default(), right)
    };
    let wrong: Vec<String> = cases.iter().filter_map(judged).collect();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn units_that_are_given_count_where_the_file_says_none() {
    let path = std::env::temp_dir().join(format!("asbuilt-unit-{}.xyz", std::process::id()));
    std::fs::write(&path, ROWS).unwrap();
    let options = ReadOptions { file_unit: Some(super::Unit::Ft), ..ReadOptions::default() };
    let scans = read(&path, &options).unwrap();
    std::fs::remove_file(path).unwrap();
    assert!((world(&scans[0])[0] - Vec3::from(FIVE[0]) * 0.3048).norm() < 1e-12);
    assert!(scans[0].notes[0].contains("feet"));
}

/// A comma that may be either mark raises the same question wherever numbers are text, and the same option answers it.
#[test]
fn decimal_commas_are_told() {
    let rows = "1,250 2,500 0,750\n1,500 2,500 0,750\n1,750 2,500 0,750\n1,250 2,750 0,750\n1,500 2,750 1,000\n";
    // Zeros before the comma tell; here nothing does.
    let unclear = rows.replace("0,", "1,");
    let right: Vec<[f64; 3]> = FIVE.iter().map(|p| [p[0], p[1], if p[2] < 1.0 { 1.75 } else { 1.0 }]).collect();
    let floats = "property float x\nproperty float y\nproperty float z\n";
    let ptx = "5\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    let told = ReadOptions { decimal_comma: true, ..ReadOptions::default() };
    for (name, text) in [
        ("told.xyz", unclear.clone()),
        ("told.ply", ply(floats, &unclear)),
        ("told.pcd", pcd("x y z", "F F F", "0 0 0 1 0 0 0", &unclear)),
        ("told.ptx", format!("{ptx}{unclear}")),
    ] {
        let path = std::env::temp_dir().join(format!("asbuilt-{}-{name}", std::process::id()));
        std::fs::write(&path, &text).unwrap();
        let refused = read(&path, &ReadOptions::default()).err().map(|e| format!("{e:#}"));
        assert!(refused.as_ref().is_some_and(|e| e.contains("--decimal-comma")), "{name}: {refused:?}");
        let points: Vec<Vec3> = read(&path, &told).unwrap().iter().flat_map(world).collect();
        let same = points.iter().zip(&right).all(|(a, b)| (a - Vec3::from(*b)).amax() < 1e-6);
        assert!(points.len() == 5 && same, "{name}: {points:?}");
        std::fs::remove_file(path).unwrap();
    }
}

/// Writes, reads and judges texts; returns what is wrong with them.
fn wrong_texts(folder: &str, cases: &[(&str, &str, ReadOptions, ExpectedScan)]) -> String {
    let folder = std::env::temp_dir().join(format!("asbuilt-{folder}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let judged = |(name, text, options, right): &(&str, &str, ReadOptions, ExpectedScan)| {
        std::fs::write(folder.join(name), text).unwrap();
        wrong(&folder.join(name), options, right)
    };
    let wrong: Vec<String> = cases.iter().filter_map(judged).collect();
    std::fs::remove_dir_all(&folder).unwrap();
    wrong.join("\n")
}

/// Rows that do not show where their coordinates are, are refused.
#[test]
fn texts_that_may_be_read_two_ways() {
    let plain = ReadOptions::default;
    let columns = |c: &str| ReadOptions { columns: Some(c.parse().unwrap()), ..plain() };
    let decimal = ReadOptions { decimal_comma: true, ..plain() };
    let asked = || Refused("--columns");
    let unsorted = "17 1.25 2.5 0.75\n3 1.5 2.5 0.75\n";
    let long = format!("{}1 001.50 567.25 12.50\n", "998.50 567.25 12.00\n".repeat(1200));
    let cases = [
        ("unsorted.xyz", unsorted, plain(), asked()),
        ("unsorted_told.xyz", unsorted, columns("n,x,y,z"), Points(TWO, false, "")),
        ("down.xyz", "2 1.25 2.5 0.75\n1 1.5 2.5 0.75\n", plain(), asked()),
        ("decimal.xyz", "1.0 1.25 2.5 0.75\n2.0 1.5 2.5 0.75\n", plain(), asked()),
        ("rows.xyz", "0 0 1.25 2.5 0.75\n0 1 1.5 2.5 0.75\n", plain(), asked()),
        ("ints.xyz", "17 100 200 300\n3 101 200 300\n", plain(), asked()),
        ("ints.pts", "2\n17 100 200 300\n3 101 200 300\n", plain(), Count(2, "")),
        ("thousands.xyz", "1 234.50 567.25 12.00\n1 235.50 567.25 12.00\n", plain(), asked()),
        (
            "mixed.xyz",
            "998.50 567.25 12.00\n1 000.50 567.25 12.50\n",
            plain(),
            Refused("line 1 has 3 words and line 2 has 4"),
        ),
        ("long.xyz", &long, plain(), Refused("line 1 has 3 words and line 1201 has 4")),
        ("date.xyz", "2024 01 15 hall\n1.25 2.5 0.75\n", plain(), Refused("line 2 has 3")),
        ("count_behind.pts", "1\n1.25 2.5 0.75\n1\n1.5 2.5 0.75\n", plain(), Points(TWO, false, "")),
        ("end_mark.csv", "1.25;2.5;0.75;\n1.5;2.5;0.75\n", plain(), Points(TWO, false, "")),
        ("contradiction.csv", "1,25,2,50,0,75\n1,50,2,50,0,75\n", decimal, Refused("--decimal-comma is given")),
        ("two_ways.csv", "1,25,2,50,0,75\n1,50,2,50,0,75\n", plain(), asked()),
        ("tabs.txt", "x\ty\tz\ti\n1.25\t2.5\t0.75\t1\n1.5\t\t0.75\t1\n", plain(), Refused("line 2 has 4")),
        ("tabs_told.txt", "1.25\t2.5\t0.75\t1\n1.5\t\t0.75\t1\n", columns("x,y,z"), Refused("line 2 has 3")),
        ("grid.asc", "ncols 3\nnrows 1\n101.5 101.5 101.5\n", plain(), Refused("ESRI")),
        ("colons.xyz", "1.25:2.5:0.75\n", plain(), Refused("parted by blanks")),
    ];
    let wrong = wrong_texts("two-ways", &cases);
    assert!(wrong.is_empty(), "{wrong}");
}

/// Titles say which column is which, in several languages.
#[test]
fn texts_with_titles() {
    const NORTH: &[[f64; 3]] = &[[500_000.25, 5_400_000.5, 100.0], [500_001.25, 5_400_001.5, 101.0]];
    let plain = ReadOptions::default;
    let two = || Points(TWO, false, "title names");
    let north = "5400000.5,500000.25,100\n5400001.5,500001.25,101\n";
    let (northing, nez) = (format!("Northing,Easting,Elevation\n{north}"), format!("N,E,Z\n{north}"));
    let millimetres = "X[mm] Y[mm] Z[mm]\n1250 2500 750\n1500 2500 750\n";
    let feet = ReadOptions { file_unit: Some(super::Unit::Ft), ..plain() };
    let same = ReadOptions { file_unit: Some(super::Unit::Mm), ..plain() };
    let cases = [
        ("east.csv", "ID,Easting,Northing,Elevation\n17,1.25,2.5,0.75\n3,1.5,2.5,0.75\n", plain(), two()),
        ("rechts.csv", "Nr;Rechtswert;Hochwert;Höhe\n17;1,25;2,5;0,75\n3;1,5;2,5;0,75\n", plain(), two()),
        ("point.csv", "Point ID;X;Y;Z\n17;1.25;2.5;0.75\n3;1.5;2.5;0.75\n", plain(), two()),
        ("end.csv", "id;x;y;z;\n17;1.25;2.5;0.75;\n3;1.5;2.5;0.75;\n", plain(), two()),
        ("range.txt", "Intensity [0-1] X Y Z\n0.5 1.25 2.5 0.75\n0.7 1.5 2.5 0.75\n", plain(), two()),
        ("coord.csv", "intensity;coord_x;coord_y;coord_z\n0.5;1.25;2.5;0.75\n0.7;1.5;2.5;0.75\n", plain(), two()),
        ("twice.txt", "i intensity x y z\n5 0.5 1.25 2.5 0.75\n6 0.6 1.5 2.5 0.75\n", plain(), two()),
        ("name.csv", "name,x,y,z\nWall 12,1.25,2.5,0.75\nSlab,1.5,2.5,0.75\n", plain(), two()),
        ("again.csv", "x,y,z\n1.25,2.5,0.75\nx,y,z\n1.5,2.5,0.75\n", plain(), Points(TWO, false, "")),
        ("northing.csv", &northing, plain(), Points(NORTH, false, "title names")),
        ("nez.csv", &nez, plain(), Points(NORTH, false, "title names")),
        ("lat.csv", "latitude,longitude,height\n48.13,11.57,519.2\n", plain(), Refused("degrees")),
        ("lacking.csv", "id;x;y;i\n17;1.25;2.5;0.75\n", plain(), Refused("--columns")),
        ("mm.txt", millimetres, plain(), Points(TWO, false, "millimetres")),
        ("mm_same.txt", millimetres, same, Points(TWO, false, "millimetres")),
        ("units_below.txt", "X Y Z\n[mm] [mm] [mm]\n1250 2500 750\n", plain(), Refused("--file-unit")),
        ("mm_feet.txt", millimetres, feet, Refused("--file-unit")),
    ];
    let wrong = wrong_texts("titles", &cases);
    assert!(wrong.is_empty(), "{wrong}");
}

/// Points separate thousands beside decimal commas, wherever numbers are text.
#[test]
fn german_thousands() {
    const RIGHT: &[[f64; 3]] = &[[1250.5, 2004.25, 100.75], [1251.5, 2004.25, 100.75]];
    let rows = "1.250,50 2.004,25 100,75\n1.251,50 2.004,25 100,75\n";
    let plain = ReadOptions::default;
    let floats = "property float x\nproperty float y\nproperty float z\n";
    let right = || Points(RIGHT, false, "");
    let cases = [
        ("a.xyz", rows, plain(), right()),
        ("a.txt", &rows.replace(' ', "\t"), plain(), right()),
        ("a.csv", &rows.replace(' ', ";"), plain(), right()),
        ("a.pcd", &pcd("x y z", "F F F", "0 0 0 1 0 0 0", rows), plain(), right()),
        ("a.ply", &ply(floats, rows).replace("vertex 5", "vertex 2"), plain(), right()),
        ("b.xyz", "1.250 2,5 3,5\n", plain(), Refused("one mark")),
        ("c.xyz", "500.000 5.400.000 101\n", plain(), Refused("--decimal-comma")),
    ];
    let wrong = wrong_texts("german", &cases);
    assert!(wrong.is_empty(), "{wrong}");
}
