//! What is true of an object: where its surface really is, how much of it can be seen, what a verdict should say.

use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::verify::Verdict;
use asbuilt_simulate::Scene;

/// A built triangle belongs to a drawn face that points its way (cos 45°).
const MIN_TURN_COS: f64 = 0.7;
/// A surface farther away than this is not the face's, metres.
const MAX_DEVIATION_M: f64 = 0.3;
/// Least share of the visible samples that makes a face count, and least number.
const FACE_SHARE: f64 = 0.03;
const FACE_SAMPLES: usize = 10;
/// With fewer beams on it than these an object may stay unobserved.
const FEW_BEAMS: f64 = 60.0;
/// Share of every well-seen surface that must keep the tolerance (USIBD).
const KEEPS: f64 = 0.95;
/// A surface's samples are worth no more independent ones than this.
const INDEPENDENT: usize = 200;

/// The built surface of one object.
pub struct BuiltSurface {
    triangles: Vec<([Vec3; 3], Vec3)>,
}

/// What is true at a sample.
#[derive(Debug, Clone, Copy)]
pub struct SampleTruth {
    /// Where the built surface crosses the sample's normal, metres along it; `None`: it does not.
    pub deviation: Option<f64>,
    /// Distance of the sample from the built surface that points its way, metres.
    pub distance: f64,
    /// How well the stations can see it.
    pub sight: Sight,
}

/// How well a sample of a drawn face, or what stands at most 10 cm in front of it, can be seen.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sight {
    /// Stations that see it.
    pub stations: u32,
    /// Beams that meet its share of the face.
    pub beams: f64,
    /// Whether a surface is met there or behind it: a beam that returns nothing is hardly evidence.
    pub returns: bool,
}

/// A place from which a scene is seen.
pub struct Viewpoints<'a> {
    pub stations: &'a [Vec3],
    /// Angle between neighbouring beams, radians.
    pub step: f64,
    /// Steepest incidence that counts, radians.
    pub max_incidence: f64,
    /// What stands at most this far in front of a face does not hide it, metres.
    pub in_front: f64,
}

impl BuiltSurface {
    pub fn new(solid: Option<&Solid>) -> Self {
        let of = |s: &Solid| {
            let corners = (0..s.triangles().len()).map(|t| s.corners(t));
            let normal = |c: [Vec3; 3]| Some((c, (c[1] - c[0]).cross(&(c[2] - c[0])).try_normalize(1e-14)?));
            corners.filter_map(normal).collect()
        };
        Self { triangles: solid.map(of).unwrap_or_default() }
    }

    /// Truth at a sample of the drawn surface.
    pub fn at(&self, position: &Vec3, normal: &Vec3, sight: Sight) -> SampleTruth {
        let mut out = SampleTruth { deviation: None, distance: f64::INFINITY, sight };
        for (corners, n) in self.triangles.iter().filter(|(_, n)| n.dot(normal) >= MIN_TURN_COS) {
            let distance = distance_to_triangle(position, corners, n);
            out.distance = out.distance.min(distance);
            if distance > MAX_DEVIATION_M {
                continue;
            }
            let along = (corners[0] - position).dot(n) / normal.dot(n);
            let nearer = out.deviation.is_none_or(|d: f64| along.abs() < d.abs());
            if nearer && along.abs() <= MAX_DEVIATION_M && covers(&(position + normal * along), corners, n) {
                out.deviation = Some(along);
            }
        }
        out
    }
}

/// Whether a point of the triangle's plane lies in it.
fn covers(p: &Vec3, [a, b, c]: &[Vec3; 3], n: &Vec3) -> bool {
    [(a, b), (b, c), (c, a)].iter().all(|(from, to)| (*to - *from).cross(&(p - *from)).dot(n) >= -1e-9)
}

fn distance_to_triangle(p: &Vec3, corners: &[Vec3; 3], n: &Vec3) -> f64 {
    let off = (p - corners[0]).dot(n);
    if covers(&(p - n * off), corners, n) {
        return off.abs();
    }
    let [a, b, c] = corners;
    let edge = |from: &Vec3, to: &Vec3| {
        let e = to - from;
        let t = ((p - from).dot(&e) / e.norm_squared()).clamp(0.0, 1.0);
        (p - from - e * t).norm()
    };
    edge(a, b).min(edge(b, c)).min(edge(c, a))
}

/// What a survey sees of a sample that represents `area` m² of a drawn face.
pub fn sight(scene: &Scene, view: &Viewpoints, area: f64, position: &Vec3, normal: &Vec3) -> Sight {
    let mut out = Sight::default();
    for station in view.stations {
        let sight = position - station;
        let range = sight.norm();
        let cos = -sight.dot(normal) / range;
        if cos < view.max_incidence.cos() {
            continue;
        }
        let hit = scene.first_hit(station, &(sight / range));
        if hit.is_none_or(|hit| hit >= range - view.in_front / cos) {
            out.stations += 1;
            out.beams += area * cos / (view.step * range).powi(2);
            out.returns |= hit.is_some();
        }
    }
    out
}

/// What a right verdict is.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// Right verdicts; several where too little is visible, or too little of it is displaced, to insist on one.
    pub verdicts: Vec<Verdict>,
    /// The finest class that 95 % of every visible face keeps; `None` where there is no object.
    pub loa: Option<Loa>,
    /// Distance of the deciding quantity from the tolerance, metres: near 0 no survey can tell.
    pub margin: f64,
}

/// The right answer from the truth at samples `(face, truth)`. An object whose worst face keeps the tolerance in 95 %
/// of its places is as drawn, one that keeps it in less is not (USIBD); within two standard deviations of chance, of
/// [`INDEPENDENT`] samples, both may be said.
pub fn expected(samples: &[(usize, SampleTruth)], missing: bool, tolerance: f64, min_coverage: f64) -> Expected {
    let seen: Vec<&(usize, SampleTruth)> = samples.iter().filter(|(_, t)| t.sight.stations > 0).collect();
    let share = |n: usize| n as f64 / samples.len().max(1) as f64;
    let returning = share(seen.iter().filter(|(_, t)| t.sight.returns).count());
    let beams: f64 = seen.iter().map(|(_, t)| t.sight.beams).sum();
    let [most, surely] = [0.0, 2.0].map(|sd| if missing { f64::INFINITY } else { worst_face(&seen, sd) });
    let mut verdicts = Vec::new();
    if share(seen.len()) >= min_coverage {
        match () {
            () if missing => verdicts.push(Verdict::Absent),
            () if most <= tolerance => verdicts.push(Verdict::Confirmed),
            () if surely > tolerance => verdicts.push(Verdict::Deviating),
            () => verdicts.extend([Verdict::Confirmed, Verdict::Deviating]),
        }
    }
    // Little to see, few beams to see it with, or no return to see it by.
    if returning < 2.5 * min_coverage || seen.len() < 2 * FACE_SAMPLES || beams < FEW_BEAMS {
        verdicts.push(Verdict::Unobserved);
    }
    let finest = Loa::ALL.into_iter().rev().find(|l| most <= l.upper());
    let margin = (most - tolerance).abs().min((surely - tolerance).abs());
    Expected { verdicts, loa: if missing { None } else { finest }, margin }
}

/// The distance that [`KEEPS`] of the worst of the faces that count keep, or of all, less so many standard deviations of
/// chance.
fn worst_face(seen: &[&(usize, SampleTruth)], sd: f64) -> f64 {
    if seen.is_empty() {
        return 0.0;
    }
    let faces = seen.iter().map(|(f, _)| f + 1).max().unwrap_or(0);
    let mut by_face = vec![Vec::new(); faces];
    seen.iter().for_each(|(f, t)| by_face[*f].push(t.distance));
    let counts =
        |d: &Vec<f64>| d.len() >= FACE_SAMPLES.min(seen.len()) && d.len() as f64 >= FACE_SHARE * seen.len() as f64;
    let quantile = |mut d: Vec<f64>| {
        d.sort_by(f64::total_cmp);
        let chance = (KEEPS * (1.0 - KEEPS) / d.len().min(INDEPENDENT) as f64).sqrt();
        d[((d.len() as f64 * (KEEPS - sd * chance).max(0.0)) as usize).min(d.len() - 1)]
    };
    let all = quantile(seen.iter().map(|(_, t)| t.distance).collect());
    by_face.into_iter().filter(counts).map(quantile).fold(all, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moved_and_a_missing_cube() {
        let cube = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap();
        let moved = Solid::cuboid([0.01, 0.0, 0.0], [1.01, 1.0, 1.0]).unwrap();
        let built = BuiltSurface::new(Some(&moved));
        let front = built.at(&Vec3::new(1.0, 0.5, 0.5), &Vec3::x(), Sight::default());
        assert!((front.deviation.unwrap() - 0.01).abs() < 1e-12 && (front.distance - 0.01).abs() < 1e-12);
        // Near the edge of a face that moved along itself there is nothing behind the sample, but the face is near.
        let edge = built.at(&Vec3::new(0.004, 0.5, 1.0), &Vec3::z(), Sight::default());
        assert!(edge.deviation.is_none() && (edge.distance - 0.006).abs() < 1e-12);
        let none = BuiltSurface::new(None).at(&Vec3::new(1.0, 0.5, 0.5), &Vec3::x(), Sight::default());
        assert!(none.deviation.is_none() && none.distance.is_infinite());
        let scene = Scene::new(&[cube]);
        let view = Viewpoints { stations: &[Vec3::new(5.0, 0.5, 0.5)], step: 1e-3, max_incidence: 1.4, in_front: 0.1 };
        let front = sight(&scene, &view, 1e-4, &Vec3::new(1.0, 0.4, 0.4), &Vec3::x());
        assert!(front.stations == 1 && front.returns && (front.beams / 6.2 - 1.0).abs() < 0.02, "{front:?}");
        assert_eq!(sight(&scene, &view, 1e-4, &Vec3::new(0.0, 0.4, 0.4), &-Vec3::x()).stations, 0);
    }
}
