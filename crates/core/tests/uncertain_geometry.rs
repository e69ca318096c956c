//! Uncertain geometry against Monte-Carlo: 20 000 draws for every construction and test, fixed seeds.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::hypothesis::{self, HypothesisTest};
use asbuilt_core::uncertain::{
    Matrix7, Stored, UncertainLine, UncertainPlane, UncertainPoint, UncertainPose, distance, fit, foot, intersect, join,
};
use nalgebra::{DMatrix, Matrix3, Matrix4, Matrix6, SMatrix, SVector, SymmetricEigen, UnitQuaternion, Vector4};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const DRAWS: usize = 20_000;
/// A place in a projected system, and one near zero.
const FAR: Vec3 = Vec3::new(600_000.0, 5_300_000.0, 500.0);

/// A random covariance with standard deviations near `sd`.
fn any_covariance<const N: usize>(rng: &mut ChaCha8Rng, sd: f64) -> SMatrix<f64, N, N> {
    let a = SMatrix::<f64, N, N>::from_fn(|_, _| rng.random_range(-1.0..1.0));
    (a * a.transpose() / N as f64 + SMatrix::identity() * 0.3) * sd * sd
}

fn root<const N: usize>(covariance: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    let e = SymmetricEigen::new(DMatrix::from_iterator(N, N, covariance.iter().copied()));
    let l = &e.eigenvectors * DMatrix::from_diagonal(&e.eigenvalues.map(|v| v.max(0.0).sqrt()));
    SMatrix::from_fn(|i, j| l[(i, j)])
}

fn draw<const N: usize>(rng: &mut ChaCha8Rng, root: &SMatrix<f64, N, N>) -> SVector<f64, N> {
    root * SVector::<f64, N>::from_fn(|_, _| StandardNormal.sample(rng))
}

/// A value that can be drawn about its mean, and whose error against the mean can be written as a vector.
trait Random: Copy {
    fn drawn(&self, rng: &mut ChaCha8Rng) -> Self;
}

impl Random for UncertainPoint {
    fn drawn(&self, rng: &mut ChaCha8Rng) -> Self {
        Self { position: self.position + draw(rng, &root(&self.covariance)), ..*self }
    }
}

impl Random for UncertainLine {
    fn drawn(&self, rng: &mut ChaCha8Rng) -> Self {
        let e = draw(rng, &root(&self.covariance));
        Self { start: self.start + e.fixed_rows::<3>(0), end: self.end + e.fixed_rows::<3>(3), ..*self }
    }
}

impl Random for UncertainPlane {
    fn drawn(&self, rng: &mut ChaCha8Rng) -> Self {
        let e: Vector4<f64> = draw(rng, &root(&self.covariance));
        let normal = (self.normal + e.fixed_rows::<3>(0)).normalize();
        Self { point: self.point + self.normal * e[3], normal, ..*self }
    }
}

impl Random for UncertainPose {
    fn drawn(&self, rng: &mut ChaCha8Rng) -> Self {
        let e = draw(rng, &root(&self.covariance));
        let turn = UnitQuaternion::from_scaled_axis(e.fixed_rows::<3>(0).into_owned());
        Self {
            rotation: turn * self.rotation,
            translation: self.translation + e.fixed_rows::<3>(3),
            scale: self.scale * e[6].exp(),
            ..*self
        }
    }
}

fn point_error(got: &UncertainPoint, nominal: &UncertainPoint) -> SVector<f64, 3> {
    got.position - nominal.position
}

fn line_error(got: &UncertainLine, nominal: &UncertainLine) -> SVector<f64, 6> {
    let (a, b) = (got.start - nominal.start, got.end - nominal.end);
    SVector::from([a.x, a.y, a.z, b.x, b.y, b.z])
}

/// (δn, δq) about the nominal plane's point.
fn plane_error(got: &UncertainPlane, nominal: &UncertainPlane) -> SVector<f64, 4> {
    let n = got.normal - nominal.normal;
    let q = got.normal.dot(&(got.point - nominal.point));
    SVector::from([n.x, n.y, n.z, q])
}

fn pose_error(got: &UncertainPose, nominal: &UncertainPose) -> SVector<f64, 7> {
    let turn = (got.rotation * nominal.rotation.inverse()).scaled_axis();
    let t = got.translation - nominal.translation;
    SVector::from([turn.x, turn.y, turn.z, t.x, t.y, t.z, (got.scale / nominal.scale).ln()])
}

/// Empirical covariance of `error` over the draws against the propagated one: 3 % of the matrix, as correlations so that
/// radians and metres count alike.
fn agrees<const N: usize>(
    what: &str,
    propagated: &SMatrix<f64, N, N>,
    rng: &mut ChaCha8Rng,
    mut error: impl FnMut(&mut ChaCha8Rng) -> SVector<f64, N>,
) {
    let mut empirical = SMatrix::<f64, N, N>::zeros();
    for _ in 0..DRAWS {
        let e = error(rng);
        empirical += e * e.transpose() / DRAWS as f64;
    }
    let scale = SVector::<f64, N>::from_fn(|i, _| propagated[(i, i)].sqrt().max(1e-300));
    let scaled = |m: &SMatrix<f64, N, N>| SMatrix::<f64, N, N>::from_fn(|i, j| m[(i, j)] / (scale[i] * scale[j]));
    let off = (scaled(&empirical) - scaled(propagated)).norm() / scaled(propagated).norm();
    assert!(off < 0.03, "{what}: empirical and propagated covariance differ by {off:.4}\n{empirical}{propagated}");
}

/// Objects that touch, turn and cross as the tests need, about `base`.
struct TestObjects {
    points: [UncertainPoint; 4],
    pose: UncertainPose,
    other_pose: UncertainPose,
}

fn scene(base: Vec3, rng: &mut ChaCha8Rng) -> TestObjects {
    let mut point =
        |x: f64, y: f64, z: f64| UncertainPoint::new(base + Vec3::new(x, y, z), &any_covariance(rng, 0.002)).unwrap();
    let points = [point(0.3, 0.2, 0.1), point(4.0, 0.5, 0.3), point(1.0, 5.0, 0.9), point(2.0, 1.5, 3.0)];
    let mut pose = |axis: Vec3, t: Vec3, scale: f64| {
        let q = UnitQuaternion::from_scaled_axis(axis);
        let unit = any_covariance::<7>(rng, 1.0);
        let sd = SVector::from([1e-4, 1e-4, 1e-4, 1e-3, 1e-3, 1e-3, 1e-4]);
        let covariance: Matrix7 = SMatrix::from_fn(|i, j| unit[(i, j)] * sd[i] * sd[j]);
        UncertainPose::new([q.w, q.i, q.j, q.k], t, scale, &covariance).unwrap()
    };
    let pose_a = pose(Vec3::new(0.3, -0.4, 1.2), Vec3::new(10.0, -4.0, 2.0), 1.002);
    let pose_b = pose(Vec3::new(-0.7, 0.1, 0.5), Vec3::new(-3.0, 8.0, 1.0), 0.98);
    TestObjects { points, pose: pose_a, other_pose: pose_b }
}

#[test]
fn constructions_propagate_covariance() {
    let rng = &mut ChaCha8Rng::seed_from_u64(1);
    let TestObjects { points: [a, b, c, d], .. } = scene(Vec3::zeros(), rng);
    let line = join::line_through(&a, &b).unwrap();
    agrees("line through points", &line.covariance, rng, |r| {
        line_error(&join::line_through(&a.drawn(r), &b.drawn(r)).unwrap(), &line)
    });
    let reference = Vec3::new(1.0, 2.0, 0.5);
    let (plucker, covariance) = line.plucker(&reference);
    agrees("Plücker line", &covariance, rng, |r| line.drawn(r).plucker(&reference).0 - plucker);
    let inside = |p: &UncertainPoint, r: &mut ChaCha8Rng| {
        let e = p.drawn(r).position - p.position;
        let axes = p.ellipsoid(0.95).unwrap();
        axes.iter().map(|(half, axis)| (e.dot(axis) / half).powi(2)).sum::<f64>() <= 1.0
    };
    let held = (0..DRAWS).filter(|_| inside(&a, rng)).count() as f64 / DRAWS as f64;
    assert!((0.945..=0.955).contains(&held), "the 95 % ellipsoid held {held}");
    let plane = join::plane_through(&a, &b, &c).unwrap();
    agrees("plane through points", &plane.covariance, rng, |r| {
        plane_error(&join::plane_through(&a.drawn(r), &b.drawn(r), &c.drawn(r)).unwrap(), &plane)
    });
    let by_line = join::plane_through_line(&line, &c).unwrap();
    assert!((by_line.covariance - plane.covariance).norm() < 1e-15);
    agrees("plane through line and point", &by_line.covariance, rng, |r| {
        plane_error(&join::plane_through_line(&line.drawn(r), &c.drawn(r)).unwrap(), &by_line)
    });
    let second = join::plane_through(&a, &b, &d).unwrap();
    let third = join::plane_through(&b, &c, &d).unwrap();
    let edge = intersect::planes(&plane, &second).unwrap();
    agrees("line of two planes", &edge.covariance, rng, |r| {
        let got = intersect::planes(&plane.drawn(r), &second.drawn(r)).unwrap();
        // Where it crosses the planes across the nominal line at its ends.
        let at = |end: &Vec3| {
            let cross = UncertainPlane::tilted(*end, edge.direction(), 0.0, 0.0).unwrap();
            intersect::line_plane(&got, &cross).unwrap().position
        };
        line_error(&UncertainLine { start: at(&edge.start), end: at(&edge.end), ..edge }, &edge)
    });
    let corner = intersect::three_planes([&plane, &second, &third]).unwrap();
    agrees("point of three planes", &corner.covariance, rng, |r| {
        point_error(&intersect::three_planes([&plane.drawn(r), &second.drawn(r), &third.drawn(r)]).unwrap(), &corner)
    });
    let through = join::line_through(&d, &UncertainPoint { position: Vec3::new(2.5, 2.0, -1.0), ..a }).unwrap();
    let pierced = intersect::line_plane(&through, &plane).unwrap();
    agrees("point of line and plane", &pierced.covariance, rng, |r| {
        point_error(&intersect::line_plane(&through.drawn(r), &plane.drawn(r)).unwrap(), &pierced)
    });
    let on_plane = foot::on_plane(&d, &plane);
    agrees("foot on plane", &on_plane.covariance, rng, |r| {
        point_error(&foot::on_plane(&d.drawn(r), &plane.drawn(r)), &on_plane)
    });
    let on_line = foot::on_line(&d, &line);
    agrees("foot on line", &on_line.covariance, rng, |r| {
        point_error(&foot::on_line(&d.drawn(r), &line.drawn(r)), &on_line)
    });
    let middle = join::midpoint(&a, &b);
    agrees("midpoint", &middle.covariance, rng, |r| point_error(&join::midpoint(&a.drawn(r), &b.drawn(r)), &middle));
}

#[test]
fn distances_know_their_deviation() {
    let rng = &mut ChaCha8Rng::seed_from_u64(2);
    let TestObjects { points: [a, b, c, d], .. } = scene(Vec3::zeros(), rng);
    let line = join::line_through(&a, &b).unwrap();
    let skew = join::line_through(&c, &d).unwrap();
    let plane = join::plane_through(&a, &b, &c).unwrap();
    type Measure<'a> = (&'a str, Box<dyn Fn(Option<&mut ChaCha8Rng>) -> distance::UncertainDistance + 'a>);
    fn of<T: Random>(x: &T, rng: &mut Option<&mut ChaCha8Rng>) -> T {
        rng.as_mut().map_or(*x, |r| x.drawn(r))
    }
    let measures: [Measure; 4] = [
        ("points", Box::new(|mut r| distance::points(&of(&a, &mut r), &of(&d, &mut r)))),
        ("point and plane", Box::new(|mut r| distance::point_plane(&of(&d, &mut r), &of(&plane, &mut r)))),
        ("point and line", Box::new(|mut r| distance::point_line(&of(&d, &mut r), &of(&line, &mut r)))),
        ("lines", Box::new(|mut r| distance::lines(&of(&line, &mut r), &of(&skew, &mut r)))),
    ];
    for (what, measure) in &measures {
        let nominal = measure(None);
        let variance = SMatrix::<f64, 1, 1>::new(nominal.sd.powi(2));
        agrees(what, &variance, rng, |r| SVector::<f64, 1>::new(measure(Some(r)).distance - nominal.distance));
    }
}

#[test]
fn poses_carry_everything() {
    let rng = &mut ChaCha8Rng::seed_from_u64(3);
    let TestObjects { points: [a, b, c, d], pose, other_pose } = scene(Vec3::zeros(), rng);
    let line = join::line_through(&a, &b).unwrap();
    let plane = join::plane_through(&a, &b, &c).unwrap();
    let image = pose.point(&d).unwrap();
    agrees("point through pose", &image.covariance, rng, |r| {
        point_error(&pose.drawn(r).point(&d.drawn(r)).unwrap(), &image)
    });
    let image = pose.line(&line).unwrap();
    agrees("line through pose", &image.covariance, rng, |r| {
        line_error(&pose.drawn(r).line(&line.drawn(r)).unwrap(), &image)
    });
    let image = pose.plane(&plane).unwrap();
    agrees("plane through pose", &image.covariance, rng, |r| {
        plane_error(&pose.drawn(r).plane(&plane.drawn(r)).unwrap(), &image)
    });
    let both = pose.after(&other_pose).unwrap();
    agrees("composition", &both.covariance, rng, |r| {
        pose_error(&pose.drawn(r).after(&other_pose.drawn(r)).unwrap(), &both)
    });
    let back = pose.inverse().unwrap();
    agrees("inverse", &back.covariance, rng, |r| pose_error(&pose.drawn(r).inverse().unwrap(), &back));
    let x = Vec3::new(1.0, 2.0, 3.0);
    assert!((back.apply(&pose.apply(&x)) - x).norm() < 1e-12);
    assert!((both.apply(&x) - pose.apply(&other_pose.apply(&x))).norm() < 1e-12);
}

#[test]
fn best_fits() {
    let rng = &mut ChaCha8Rng::seed_from_u64(4);
    let truth = |u: f64, v: f64| Vec3::new(u, v, 0.3 * u - 0.2 * v);
    let mut cloud: Vec<UncertainPoint> = Vec::new();
    for i in 0..36 {
        let at = truth(f64::from(i % 6) * 0.7, f64::from(i / 6) * 0.5);
        cloud.push(UncertainPoint::new(at, &any_covariance(rng, 0.002)).unwrap());
    }
    let drawn = |cloud: &[UncertainPoint], r: &mut ChaCha8Rng| cloud.iter().map(|p| p.drawn(r)).collect::<Vec<_>>();
    let plane = fit::plane(&cloud, NEVER).unwrap();
    agrees("best-fit plane", &plane.covariance, rng, |r| {
        plane_error(&fit::plane(&drawn(&cloud, r), NEVER).unwrap(), &plane)
    });
    let row: Vec<UncertainPoint> = (0..12)
        .map(|i| UncertainPoint::new(Vec3::new(0.5, 0.2, -0.1) * f64::from(i), &any_covariance(rng, 0.002)).unwrap())
        .collect();
    let line = fit::line(&row, NEVER).unwrap();
    // Across the line; along it the ends are those of the extreme points.
    agrees("best-fit line", &line.covariance, rng, |r| line_error(&fit::line(&drawn(&row, r), NEVER).unwrap(), &line));
    // Without any uncertainty given, it comes from the residuals.
    let (mut sum, n) = (0.0, 400);
    for _ in 0..n {
        let bare: Vec<UncertainPoint> =
            drawn(&cloud, rng).into_iter().map(|p| UncertainPoint { covariance: Matrix3::zeros(), ..p }).collect();
        sum += fit::plane(&bare, NEVER).unwrap().covariance[(3, 3)] / f64::from(n);
    }
    assert!((sum / plane.covariance[(3, 3)]).sqrt().max((plane.covariance[(3, 3)] / sum).sqrt()) < 1.3);
}

/// A test of the objects at `base`, one of them moved off, with errors drawn.
type Trial = Box<dyn Fn(&mut ChaCha8Rng, f64, Vec3) -> HypothesisTest>;

/// One relation: the objects where it holds, drawn anew, and the same with one of them moved off.
struct Relation {
    name: &'static str,
    dof: u32,
    trial: Trial,
}

/// All relations, exact about `base`; `off` breaks each, in units of about one standard deviation.
fn relations() -> Vec<Relation> {
    const SD: f64 = 0.002;
    fn point(rng: &mut ChaCha8Rng, base: Vec3, x: Vec3) -> UncertainPoint {
        UncertainPoint::new(base + x, &any_covariance(rng, SD)).unwrap()
    }
    fn line(rng: &mut ChaCha8Rng, base: Vec3, a: Vec3, b: Vec3) -> UncertainLine {
        UncertainLine::new(base + a, base + b, &any_covariance::<6>(rng, SD)).unwrap()
    }
    fn plane(rng: &mut ChaCha8Rng, base: Vec3, at: Vec3, normal: Vec3) -> UncertainPlane {
        let c: Matrix4<f64> = any_covariance::<4>(rng, SD);
        UncertainPlane::new(base + at, normal, &c).unwrap()
    }
    // Objects are the same in every trial (seed 9); only their errors differ.
    fn with<T>(
        name: &'static str,
        dof: u32,
        make: fn(&mut ChaCha8Rng, Vec3, f64) -> T,
        test: fn(&T, &mut ChaCha8Rng) -> HypothesisTest,
    ) -> Relation
    where
        T: 'static,
    {
        Relation {
            name,
            dof,
            trial: Box::new(move |rng, off, base| {
                let objects = make(&mut ChaCha8Rng::seed_from_u64(9), base, off);
                test(&objects, rng)
            }),
        }
    }
    vec![
        with(
            "same point",
            3,
            |r, o, off| (point(r, o, Vec3::x()), point(r, o, Vec3::x() + Vec3::y() * off * SD)),
            |(a, b), r| hypothesis::same_point(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "point on line",
            2,
            |r, o, off| {
                let across = Vec3::new(-0.8, 0.48, 0.36) * off * SD;
                (
                    point(r, o, Vec3::new(0.6, 0.64, 0.48) * 1.7 + across),
                    line(r, o, Vec3::zeros(), Vec3::new(1.8, 1.92, 1.44)),
                )
            },
            |(a, b), r| hypothesis::point_on_line(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "point on plane",
            1,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                (point(r, o, Vec3::new(-0.8, 0.48, 0.36) * 2.0 + n * off * SD), plane(r, o, Vec3::zeros(), n))
            },
            |(a, b), r| hypothesis::point_on_plane(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "line in plane",
            2,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                let (a, b) = (Vec3::new(-0.8, 0.48, 0.36), Vec3::new(0.0, -0.6, 0.8) * 2.0);
                (line(r, o, a + n * off * SD, b), plane(r, o, Vec3::zeros(), n))
            },
            |(a, b), r| hypothesis::line_in_plane(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "same plane",
            3,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                let other = Vec3::new(-0.8, 0.48, 0.36) * 1.5 + n * off * SD;
                (plane(r, o, Vec3::zeros(), n), plane(r, o, other, -n))
            },
            |(a, b), r| hypothesis::same_plane(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "parallel lines",
            2,
            |r, o, off| {
                let d = Vec3::new(1.8, 1.92, 1.44);
                let q = Vec3::new(0.3, 2.0, 1.0);
                (line(r, o, Vec3::zeros(), d), line(r, o, q, q - d + Vec3::new(-0.8, 0.48, 0.36) * off * SD))
            },
            |(a, b), r| hypothesis::parallel_lines(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "parallel planes",
            2,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                (plane(r, o, Vec3::zeros(), n), plane(r, o, n * 3.0, -n + Vec3::new(-0.8, 0.48, 0.36) * off * SD))
            },
            |(a, b), r| hypothesis::parallel_planes(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "line parallel to plane",
            1,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                (line(r, o, n, n * (1.0 + off * SD) + Vec3::new(-1.6, 0.96, 0.72)), plane(r, o, Vec3::zeros(), n))
            },
            |(a, b), r| hypothesis::line_parallel_plane(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "orthogonal lines",
            1,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                let b = Vec3::new(-1.6, 0.96, 0.72);
                (line(r, o, Vec3::zeros(), n), line(r, o, Vec3::x(), Vec3::x() + b + n * off * SD))
            },
            |(a, b), r| hypothesis::orthogonal_lines(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "orthogonal planes",
            1,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                (plane(r, o, Vec3::zeros(), n), plane(r, o, Vec3::x(), Vec3::new(-0.8, 0.48, 0.36) + n * off * SD))
            },
            |(a, b), r| hypothesis::orthogonal_planes(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "line orthogonal to plane",
            2,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                (
                    line(r, o, Vec3::x(), Vec3::x() - n * 2.0 + Vec3::new(-0.8, 0.48, 0.36) * off * SD),
                    plane(r, o, Vec3::zeros(), n),
                )
            },
            |(a, b), r| hypothesis::line_orthogonal_plane(&a.drawn(r), &b.drawn(r)),
        ),
        with(
            "coplanar lines",
            1,
            |r, o, off| {
                let n = Vec3::new(0.6, 0.64, 0.48);
                let (u, v) = (Vec3::new(-0.8, 0.48, 0.36), Vec3::new(0.0, -0.6, 0.8));
                (line(r, o, u, u + v * 2.0), line(r, o, v * 3.0 - u + n * off * SD, v + u * 2.0))
            },
            |(a, b), r| hypothesis::coplanar(&a.drawn(r), &b.drawn(r)),
        ),
    ]
}

#[test]
fn false_alarms_are_as_often_as_stated() {
    println!("relation | dof | false alarms at 0.05 | power at 1, 3, 6 sd");
    for (k, relation) in relations().iter().enumerate() {
        let rate = |off: f64, seed: u64| {
            let rng = &mut ChaCha8Rng::seed_from_u64(seed);
            let rejected = (0..DRAWS).filter(|_| {
                let t = (relation.trial)(rng, off, Vec3::zeros());
                assert_eq!(t.dof, relation.dof, "{}", relation.name);
                !t.holds(0.05)
            });
            rejected.count() as f64 / DRAWS as f64
        };
        let alarms = rate(0.0, 100 + k as u64);
        let power = [1.0, 3.0, 6.0].map(|off| rate(off, 200 + k as u64));
        println!(
            "{} | {} | {alarms:.4} | {:.3}, {:.3}, {:.3}",
            relation.name, relation.dof, power[0], power[1], power[2]
        );
        assert!((0.045..=0.055).contains(&alarms), "{}: {alarms}", relation.name);
        assert!(power[0] > alarms && power[1] > power[0] && power[2] > power[1], "{}: {power:?}", relation.name);
    }
}

/// The same errors in a projected system give the same p-values.
#[test]
fn projected_coordinates_lose_nothing() {
    for relation in relations() {
        for seed in 0..200 {
            let p = |base: Vec3| (relation.trial)(&mut ChaCha8Rng::seed_from_u64(seed), 0.5, base).p_value;
            let (near, far) = (p(Vec3::zeros()), p(FAR));
            assert!((near - far).abs() < 1e-6, "{}: {near} near zero, {far} far from it", relation.name);
        }
    }
}

#[test]
fn exact_objects_contradict_or_agree() {
    let exact = |x: f64| UncertainPoint::isotropic(Vec3::new(x, 0.0, 0.0), 0.0).unwrap();
    let same = hypothesis::same_point(&exact(1.0), &exact(1.0));
    assert_eq!((same.statistic, same.dof, same.p_value), (0.0, 0, 1.0));
    let apart = hypothesis::same_point(&exact(1.0), &exact(1.1));
    assert!(apart.statistic.is_infinite() && apart.p_value == 0.0);
    // Uncertain along x alone: one degree of freedom, and a step along y is a contradiction.
    let along = Matrix3::from_diagonal(&Vec3::new(1e-6, 0.0, 0.0));
    let p = UncertainPoint::new(Vec3::zeros(), &along).unwrap();
    let t = hypothesis::same_point(&p, &exact(0.002));
    assert!(t.dof == 1 && (t.statistic - 4.0).abs() < 1e-9, "{t:?}");
    let t = hypothesis::same_point(&p, &UncertainPoint::isotropic(Vec3::y() * 0.001, 0.0).unwrap());
    assert!(t.statistic.is_infinite());
}

/// What a construction gives is a value that can be written and read again, however large its lever.
#[test]
fn results_can_be_read_again() {
    let rng = &mut ChaCha8Rng::seed_from_u64(5);
    let mut again = 0;
    for _ in 0..2000 {
        let mut place = |size: f64| Vec3::from_fn(|_, _| rng.random_range(0.0..size));
        let (a, b, c, t) = (place(20.0), place(20.0), place(20.0), place(20.0));
        let exact = |p: Vec3| UncertainPoint::isotropic(FAR + p, 0.0).unwrap();
        let third = UncertainPoint::isotropic(FAR + c, 0.01).unwrap();
        let Ok(plane) = join::plane_through(&exact(a), &exact(b), &third) else { continue };
        let q = UnitQuaternion::from_scaled_axis(t);
        let pose =
            UncertainPose::new([q.w, q.i, q.j, q.k], FAR + t, 1.0, &UncertainPose::diagonal(1e-3, 0.0, 0.0).unwrap())
                .unwrap();
        let line = join::line_through(&exact(a), &third).unwrap();
        let back = pose.inverse().unwrap();
        fn reread<T: Stored<N>, const N: usize>(x: &T) {
            assert_eq!(T::from_text(&x.to_text()).unwrap().to_numbers(), x.to_numbers());
        }
        reread(&plane);
        reread(&back.inverse().unwrap());
        reread(&back.point(&exact(a)).unwrap());
        reread(&back.line(&line).unwrap());
        reread(&back.plane(&plane).unwrap());
        again += 1;
    }
    assert!(again > 1900, "{again}");
}

#[test]
fn what_is_no_covariance_is_refused() {
    for bad in [
        [[-9e-10, 0.0, 0.0], [0.0, 1e-6, 0.0], [0.0, 0.0, 1e-6]],
        [[0.0, 9e-10, 0.0], [9e-10, 0.0, 0.0], [0.0, 0.0, 0.0]],
        [[0.0, 2e-8, 0.0], [2e-8, 1e-6, 0.0], [0.0, 0.0, 0.0]],
        [[1e-300, 1e300, 0.0], [1e300, 1e-300, 0.0], [0.0, 0.0, 0.0]],
        [[1.0, f64::INFINITY, 0.0], [f64::INFINITY, 1.0, 0.0], [0.0, 0.0, 0.0]],
    ] {
        let m = Matrix3::from_fn(|i, j| bad[i][j]);
        assert!(UncertainPoint::new(Vec3::zeros(), &m).is_err(), "{m}");
    }
    let tiny = Matrix3::identity() * 1e-300;
    assert!(UncertainPoint::new(Vec3::zeros(), &tiny).is_ok());
    let apart = hypothesis::same_point(
        &UncertainPoint::new(Vec3::zeros(), &tiny).unwrap(),
        &UncertainPoint::new(Vec3::x() * 1e5, &tiny).unwrap(),
    );
    assert!(apart.p_value == 0.0 && !apart.holds(0.05), "{apart:?}");
    // Fewer digits of a unit quaternion or normal are made a unit again.
    let q = UncertainPose::from_text("(0.7071068,0,0,0.7071068,0,0,0,1)").unwrap();
    assert!((q.rotation.quaternion().norm() - 1.0).abs() < 1e-15);
    assert!(UncertainPose::from_text("(0.7,0,0,0.7,0,0,0,1)").is_err());
}

#[test]
fn what_does_not_determine_is_refused() {
    let p = |x: f64, y: f64| UncertainPoint::isotropic(FAR + Vec3::new(x, y, 0.0), 0.001).unwrap();
    assert!(join::line_through(&p(0.0, 0.0), &p(0.0, 0.0)).is_err());
    let e = join::plane_through(&p(0.0, 0.0), &p(1.0, 1.0), &p(3.0, 3.0)).unwrap_err();
    assert_eq!(e.to_string(), "the plane is undetermined: the three points lie on one line");
    let row: Vec<UncertainPoint> = (0..9).map(|i| p(f64::from(i), 0.0)).collect();
    assert!(fit::plane(&row, NEVER).is_err() && fit::plane(&row[..2], NEVER).is_err());
    assert!(fit::line(&[p(1.0, 1.0), p(1.0, 1.0)], NEVER).is_err() && fit::line(&[], NEVER).is_err());
    let floor = UncertainPlane::tilted(FAR, Vec3::z(), 0.001, 1e-4).unwrap();
    let other = UncertainPlane::tilted(FAR + Vec3::z(), Vec3::z(), 0.001, 1e-4).unwrap();
    assert!(intersect::planes(&floor, &other).is_err());
    let level = join::line_through(&p(0.0, 0.0), &p(1.0, 0.0)).unwrap();
    assert!(intersect::line_plane(&level, &floor).is_err());
    let negative = Matrix3::from_diagonal(&Vec3::new(1e-6, 1e-6, -1e-8));
    let e = UncertainPoint::new(Vec3::zeros(), &negative).unwrap_err();
    assert!(e.to_string().contains("smallest eigenvalue is -1e-8"), "{e}");
    assert!(UncertainLine::new(Vec3::zeros(), Vec3::x(), &-Matrix6::identity()).is_err());
}
