//! What reaches the office: scans by station, or one cloud of all points.

use asbuilt_core::geometry::Vec3;
use rustc_hash::FxHashSet;

use crate::scanner::Scan;

/// All returns as one cloud, world metres, thinned: of the points within one cube of the `cell` (metres) the first one
/// is kept. Nothing tells any more from where they were measured.
pub fn merged(scans: &[Scan], cell: f64) -> Vec<Vec3> {
    let mut taken = FxHashSet::default();
    let points =
        scans.iter().flat_map(|scan| scan.shots.iter().filter(|s| s.returned).map(move |s| scan.place + s.offset));
    points.filter(|p| taken.insert([p.x, p.y, p.z].map(|c| (c / cell).floor() as i64))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scanner::Shot;

    #[test]
    fn one_point_a_cube() {
        let shot = |x: f64, returned| Shot { offset: Vec3::new(x, 0.0, 0.0), returned, owner: None };
        let shots = vec![shot(0.0, true), shot(0.004, true), shot(0.006, true), shot(1.0, false)];
        let scan = Scan { place: Vec3::new(10.0, 0.0, 0.0), shots };
        assert_eq!(merged(&[scan], 0.005), [Vec3::new(10.0, 0.0, 0.0), Vec3::new(10.006, 0.0, 0.0)]);
    }
}
