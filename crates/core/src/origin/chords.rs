//! A first axis. Two points of one scan line lie in a plane with the axis, which is nearly vertical: from above, the line
//! through them passes through the scanner.

use nalgebra::{Matrix2, Vector2};

use super::sequence::Sequence;
use crate::num::scatter::scattered;

/// Number of chords that are tried.
const CHORDS: usize = 4000;
/// Number of pairs of them that propose a place.
const PROPOSALS: usize = 400;
/// How many points apart the ends of a chord are: more where points lie denser.
const LAGS: [usize; 4] = [8, 32, 128, 512];
/// A shorter chord has no direction.
const MIN_CHORD_M: f64 = 0.03;
/// A chord passes through a place if it misses it by no more than this share of its distance.
const MAX_MISS: f64 = 0.02;
/// Of the chords of a tripod's scan nearly all pass through its place, of others hardly any. Two stations share them.
const MIN_SHARE: f64 = 0.6;

/// A line seen from above.
#[derive(Clone, Copy)]
struct Chord {
    through: Vector2<f64>,
    /// Unit vector across it.
    normal: Vector2<f64>,
}

impl Chord {
    fn passes(&self, place: &Vector2<f64>) -> bool {
        let away = place - self.through;
        self.normal.dot(&away).abs() <= MAX_MISS * (away.norm() + 0.1)
    }
}

/// Where the axis stands, metres from the anchor; `None` where no place is common to most chords.
pub fn first_axis(points: Sequence) -> Option<Vector2<f64>> {
    let chords = LAGS.iter().map(|&lag| chords(points, lag)).find(|c| c.len() >= CHORDS / 8)?;
    let at = |k: usize| &chords[scramble(k as u64) as usize % chords.len()];
    let proposed = (0..PROPOSALS).filter_map(|k| meeting(&[*at(2 * k), *at(2 * k + 1)]));
    let (_, mut best) = proposed
        .map(|place| (chords.iter().filter(|c| c.passes(&place)).count(), place))
        .max_by_key(|(passing, _)| *passing)?;
    for _ in 0..5 {
        let passing: Vec<Chord> = chords.iter().filter(|c| c.passes(&best)).copied().collect();
        if (passing.len() as f64) < MIN_SHARE * chords.len() as f64 {
            return None;
        }
        best = meeting(&passing)?;
    }
    Some(best)
}

fn chords(points: Sequence, lag: usize) -> Vec<Chord> {
    let starts = scattered(points.len().saturating_sub(lag), CHORDS);
    let chord = |i: usize| {
        let (a, b) = (points.point(i).xy(), points.point(i + lag).xy());
        let along = b - a;
        let length = along.norm();
        (length >= MIN_CHORD_M).then(|| Chord { through: a, normal: Vector2::new(-along.y, along.x) / length })
    };
    starts.filter_map(chord).collect()
}

/// The place nearest to lines; `None` where they are parallel.
fn meeting(chords: &[Chord]) -> Option<Vector2<f64>> {
    let (mut a, mut b) = (Matrix2::zeros(), Vector2::zeros());
    for c in chords {
        a += c.normal * c.normal.transpose();
        b += c.normal * c.normal.dot(&c.through);
    }
    // Two lines that differ by 3° or less meet anywhere.
    if a.determinant() < 2.5e-3 * (chords.len() * chords.len()) as f64 / 4.0 {
        return None;
    }
    Some(a.try_inverse()? * b)
}

/// Scrambles a number so that any sequence becomes uniform (SplitMix64).
fn scramble(n: u64) -> u64 {
    let n = n.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let n = (n ^ (n >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let n = (n ^ (n >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    n ^ (n >> 31)
}
