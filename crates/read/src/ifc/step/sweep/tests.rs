//! Volumes in closed form: a profile whose centroid lies on the line sweeps its area times the line's length
//! (Pappus), mitres included; frustums by Simpson's rule, exact for them.

use ifc_lite_geometry::{Point2, Point3, Vector3};

use super::path::Path;
use super::rings::mitred;
use super::roll::Roll;
use super::section::Section;
use super::skin::Skin;

fn path(points: &[[f64; 3]]) -> Path {
    Path::new(points.iter().map(|p| Point3::from(*p)).collect()).unwrap()
}

fn rectangle(w: f64, h: f64) -> Section {
    let corners = [[-w, -h], [w, -h], [w, h], [-w, h]].map(|[x, y]| Point2::new(x / 2.0, y / 2.0));
    Section::new(&corners, &[]).unwrap()
}

fn swept(section: &Section, path: &Path, roll: &Roll) -> Option<Vec<Skin>> {
    let runs = mitred(section, path, roll)?;
    Some(runs.iter().map(|run| Skin::new([section, section], &run.rings, run.is_closed)).collect())
}

fn volume(skins: &[Skin]) -> f64 {
    skins.iter().map(Skin::volume).sum()
}

/// Every edge is matched by its reverse once.
fn is_closed(skin: &Skin) -> bool {
    let edges = || skin.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let all: std::collections::HashSet<_> = edges().collect();
    all.len() == edges().count() && all.iter().all(|&(a, b)| all.contains(&(b, a)))
}

#[test]
fn corners_are_mitred() {
    let beam = rectangle(0.3, 0.5);
    let up = Roll::Fixed(Vector3::z());
    let u = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]];
    let skew = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [6.0, 3.0, 0.0], [9.0, 3.0, 0.0]];
    let space = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 1.0], [2.0, 5.0, 3.0]];
    let frame = [u[0], u[1], u[2], u[3], u[0]];
    let length = |p: &[[f64; 3]]| p.windows(2).map(|w| (Vector3::from(w[0]) - Vector3::from(w[1])).norm()).sum::<f64>();
    // Told to stand upright in space the profile is turned at the corners: a prism a segment.
    let cases = [(&u[..], &up, 1), (&skew, &up, 1), (&frame, &up, 1), (&space, &Roll::Carried, 1), (&space, &up, 3)];
    for (points, roll, runs) in cases {
        let skins = swept(&beam, &path(points), roll).unwrap();
        assert!((volume(&skins) - 0.15 * length(points)).abs() < 1e-9, "{points:?}: {}", volume(&skins));
        assert!(skins.len() == runs && skins.iter().all(is_closed), "{points:?}: {}", skins.len());
    }
    let pipe = Section::disk(0.2, Some(0.1)).unwrap();
    let area = 36.0 / 2.0 * (std::f64::consts::TAU / 36.0).sin() * (0.04 - 0.01);
    let skins = swept(&pipe, &path(&space), &Roll::Carried).unwrap();
    assert!((volume(&skins) - area * length(&space)).abs() < 1e-9 && skins.iter().all(is_closed));
}

#[test]
fn what_cannot_be_followed_is_left() {
    let beam = rectangle(0.3, 0.5);
    let back = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.01, 0.0]];
    let short = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 0.1, 0.0], [0.0, 0.1, 0.0]];
    let rising = [[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [4.0, 0.0, 4.0]];
    for points in [&back[..], &short, &rising] {
        assert!(swept(&beam, &path(points), &Roll::Fixed(Vector3::z())).is_none(), "{points:?}");
    }
    assert!(path(&short[..3]).rounded(0.2).is_none());
}

#[test]
fn rounded_corners_keep_their_radius() {
    let line = path(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0]]).rounded(0.5).unwrap();
    let length: f64 = (0..line.segments()).map(|i| line.segment(i)).map(|[a, b]| (b - a).norm()).sum();
    assert!((length - (7.0 - 1.0 + 0.25 * std::f64::consts::PI)).abs() < 1e-3, "{length}");
    assert_eq!(line.corners(), 0);
}
