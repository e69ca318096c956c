//! How many beams pass between much nearer returns on all sides of them.
//!
//! Over a surface seen from a true position the range is a function of direction: at its edges the nearer returns lie
//! to one side, and in its hollows they are nearer by little. From a wrong position near and far are mixed. That can
//! only be seen where returns lie close together, so some windows of the sphere are examined with all returns in them.

use std::f64::consts::{PI, TAU};

use asbuilt_core::geometry::Vec3;
use asbuilt_core::num::scatter::scattered;
use asbuilt_core::scan::Beam;
use kd_tree::{KdPoint, KdTree};
use rustc_hash::{FxBuildHasher, FxHashSet};

/// What the beams say about the place that they supposedly come from.
#[derive(Debug, PartialEq)]
pub enum Passing {
    /// The share that passes between nearer returns: of all beams, and of those where returns lie close together.
    Shares { overall: f64, close: f64 },
    /// Returns follow one another on one beam, as the echoes of a pulse do, which is only so as seen from where the
    /// scanner stood.
    Echoes,
    /// Too few returns lie close enough together.
    Unknown,
}

/// Numbers of returns in the sample, in all windows, and in one window; of beams that are tried; of neighbours of each.
const COMPARED: usize = 100_000;
const OF_WINDOWS: usize = 40_000;
const OF_WINDOW: usize = 1000;
const TRIED: usize = 2000;
const NEIGHBOURS: usize = 16;
/// With fewer beams nothing can be told.
const MIN_BEAMS: u32 = 100;
/// Where a smaller share passes among returns close together, the sample, which costs four times as much, is not
/// examined.
const DOUBTFUL: f64 = 0.01;
/// A beam passes a return that is nearer to it than this, metres; a beam can be tried where most neighbours are.
const BESIDE_M: f64 = 0.1;
/// Returns nearer to one another than this count as one, metres: copies would hide the others.
const COPY_M: f64 = 1e-3;
const ONE_M: f64 = 0.04;
/// Returns closer to a beam than this are echoes of its own pulse, metres.
const SAME_PULSE_M: f64 = 0.002;
/// Returns nearer than this are the scanner itself, metres.
const OWN_PLATFORM_M: f64 = 0.3;

/// A direction, and the range of the return there.
#[derive(Clone, Copy)]
struct Direction {
    unit: [f64; 3],
    range: f64,
}

impl KdPoint for Direction {
    type Scalar = f64;
    type Dim = <[f64; 3] as KdPoint>::Dim;

    fn at(&self, axis: usize) -> f64 {
        self.unit[axis]
    }
}

pub fn passing(beams: &[Beam]) -> Passing {
    if beams.len() as u64 <= u64::from(MIN_BEAMS) {
        return Passing::Unknown;
    }
    if are_echoes(beams) {
        return Passing::Echoes;
    }
    let windows = tally(thinned(windows(beams), ONE_M));
    if windows.close as usize > TRIED / 2 && windows.share_close() < DOUBTFUL {
        return Passing::Shares { overall: 0.0, close: windows.share_close() };
    }
    let sample = scattered(beams.len(), COMPARED).filter_map(|i| direction(&beams[i])).collect();
    let sample = tally(thinned(sample, COPY_M));
    if sample.close.max(windows.close) < MIN_BEAMS {
        return Passing::Unknown;
    }
    Passing::Shares { overall: share(sample.passing, sample.counted), close: windows.share_close() }
}

/// Beams that were tried, those among returns close together, and how many of each pass.
#[derive(Default)]
struct Tally {
    counted: u32,
    close: u32,
    passing: u32,
    passing_close: u32,
}

impl Tally {
    fn share_close(&self) -> f64 {
        share(self.passing_close, self.close)
    }
}

fn share(passing: u32, of: u32) -> f64 {
    if of < MIN_BEAMS { 0.0 } else { f64::from(passing) / f64::from(of) }
}

fn tally(some: Vec<Direction>) -> Tally {
    let tried: Vec<Direction> = scattered(some.len(), TRIED).map(|i| some[i]).collect();
    let tree = KdTree::build_by_ordered_float(some);
    let mut tally = Tally::default();
    for (passes, is_close) in tried.iter().filter_map(|beam| passes(&tree, beam)) {
        tally.counted += 1;
        tally.close += u32::from(is_close);
        tally.passing += u32::from(passes);
        tally.passing_close += u32::from(passes && is_close);
    }
    tally
}

/// The direction and range of a return that is not the scanner itself.
fn range(beam: &Beam) -> Option<f64> {
    let range = beam.offset.norm();
    (beam.returned && range > OWN_PLATFORM_M).then_some(range)
}

fn direction(beam: &Beam) -> Option<Direction> {
    range(beam).map(|range| Direction { unit: (beam.offset / range).into(), range })
}

/// All returns in some windows that are scattered over the sphere.
fn windows(beams: &[Beam]) -> Vec<Direction> {
    let across = (beams.len() as f64 / OF_WINDOW as f64 / 6.0).sqrt().ceil();
    let part = if beams.len() <= COMPARED { 1.0 } else { OF_WINDOWS as f64 / beams.len() as f64 };
    let limit = (part * u64::MAX as f64) as u64;
    let is_chosen = |b: &&Beam| b.returned && scramble(window(&b.offset, across)) <= limit;
    // Where nearly everything lies in one window, it must not be everything.
    beams.iter().filter(is_chosen).take(4 * OF_WINDOWS).filter_map(direction).collect()
}

/// The number of the window, on a cube around the scanner, through which a direction passes.
fn window(offset: &Vec3, across: f64) -> u64 {
    let axis = offset.iamax();
    let (largest, u, v) = (offset[axis], offset[(axis + 1) % 3], offset[(axis + 2) % 3]);
    let place = |w: f64| ((w / largest.abs() + 1.0) / 2.0 * across) as u64;
    (place(u) << 34) | (place(v) << 4) | (axis as u64) << 1 | u64::from(largest > 0.0)
}

/// Scrambles a number so that any sequence becomes uniform and without a period (SplitMix64's last step).
fn scramble(n: u64) -> u64 {
    let n = (n ^ (n >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let n = (n ^ (n >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    n ^ (n >> 31)
}

/// One return per cube of this size.
fn thinned(some: Vec<Direction>, size: f64) -> Vec<Direction> {
    let mut seen = FxHashSet::with_capacity_and_hasher(some.len(), FxBuildHasher);
    // Twenty-one bits per axis: cubes that share a number lie kilometres apart.
    let number = |c: f64| (c / size).floor() as i64 as u64 & 0x1f_ffff;
    let cube = |d: &Direction| d.unit.iter().fold(0, |cube, c| cube << 21 | number(c * d.range));
    some.into_iter().filter(|d| seen.insert(cube(d))).collect()
}

/// Whether returns that follow one another lie on one beam. By chance three times as many would lie in the ring around
/// it.
fn are_echoes(beams: &[Beam]) -> bool {
    let (mut pairs, mut on_beam, mut beside_it) = (0, 0, 0);
    for i in scattered(beams.len() - 1, COMPARED) {
        let (Some(a), Some(b)) = (range(&beams[i]), range(&beams[i + 1])) else { continue };
        pairs += 1;
        if a.min(b) >= 0.95 * a.max(b) - 0.05 {
            continue;
        }
        let apart = (beams[i].offset / a - beams[i + 1].offset / b).norm() * a.min(b);
        on_beam += usize::from(apart < SAME_PULSE_M);
        beside_it += usize::from((SAME_PULSE_M..2.0 * SAME_PULSE_M).contains(&apart));
    }
    on_beam * 100 > pairs && on_beam > 2 * beside_it
}

/// Whether a beam passes between nearer returns, and whether the returns around it lie close together; `None` for the
/// later echoes of a pulse.
fn passes(tree: &KdTree<Direction>, beam: &Direction) -> Option<(bool, bool)> {
    let (direction, range) = (Vec3::from(beam.unit), beam.range);
    let aside = if direction.z.abs() < 0.9 { Vec3::z() } else { Vec3::x() };
    let u = direction.cross(&aside).normalize();
    let v = direction.cross(&u);
    let (mut headings, mut close) = (Vec::with_capacity(NEIGHBOURS), 0);
    // The first is the beam itself.
    for found in tree.nearests(&beam.unit, NEIGHBOURS + 1).iter().skip(1) {
        let other = found.item;
        let offset = Vec3::from(other.unit) - direction;
        let apart = offset.norm();
        close += usize::from(apart * other.range.min(range) <= BESIDE_M);
        let beside = apart * other.range;
        if other.range >= 0.95 * range - 0.05 || beside > BESIDE_M {
            continue;
        }
        if beside < SAME_PULSE_M {
            return None;
        }
        headings.push(offset.dot(&v).atan2(offset.dot(&u)));
    }
    Some((surround(&mut headings), 2 * close >= NEIGHBOURS))
}

/// Whether directions in a plane leave no half-plane free.
fn surround(headings: &mut [f64]) -> bool {
    if headings.len() < 3 {
        return false;
    }
    headings.sort_by(f64::total_cmp);
    let around = headings[0] + TAU - headings[headings.len() - 1];
    headings.windows(2).map(|w| w[1] - w[0]).fold(around, f64::max) < PI
}
