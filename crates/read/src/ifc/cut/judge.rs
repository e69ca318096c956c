//! Is a cut right? Along many lines through every opening, what is left of the host must be the host without its
//! openings.

use asbuilt_core::geometry::Vec3;

use super::line::{ProbeLine, union, without};
use crate::ifc::soup::Soup;

/// Shorter stretches are rounding, metres: the geometry library's grid of 1/65536 m, crossed at a slant.
const TOLERANCE_M: f64 = 2e-3;
/// A stretch thinner than this is a skin that closes an opening, metres: no part of a building is as thin.
const SKIN_M: f64 = 1e-4;
const NOTHING_M: f64 = 1e-6;
/// A single line may graze an edge; this many that find a skin do not.
const SKINS: usize = 3;
/// Lines through all openings of a host.
const LINES_OF_HOST: usize = 480;

/// What was found about a cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Finding {
    Right,
    /// This much too little or too much along a line, metres.
    Wrong(f64),
    /// The host or an opening is not a closed solid.
    Open,
}

/// Judges what is left of a host along this many lines through each of its openings, the `tools`.
pub fn judge(host: &Soup, tools: &[Soup], left: &Soup, lines: usize) -> Finding {
    // The same lines every time.
    let mut random = SplitMix64(0x1FC);
    let lines = (LINES_OF_HOST / tools.len().max(1)).clamp(4, lines);
    let (mut judged, mut open, mut skins) = (0, 0, 0);
    for tool in tools {
        let (low, high) = common(host, tool);
        for _ in 0..lines {
            let point = Vec3::from([0, 1, 2].map(|k| low[k] + (high[k] - low[k]) * random.number()));
            let direction = Vec3::from([0, 1, 2].map(|_| random.number() - 0.5)).normalize();
            let Some((off, is_skin)) = compare(host, tools, left, &ProbeLine::new(point, direction)) else {
                open += 1;
                continue;
            };
            judged += 1;
            skins += usize::from(is_skin);
            if off > TOLERANCE_M || skins >= SKINS {
                return Finding::Wrong(off);
            }
        }
    }
    if open > judged / 20 { Finding::Open } else { Finding::Right }
}

/// The box that two meshes have in common.
pub fn common(a: &Soup, b: &Soup) -> ([f64; 3], [f64; 3]) {
    let (a, b) = (a.bounds(), b.bounds());
    (std::array::from_fn(|k| a.0[k].max(b.0[k])), std::array::from_fn(|k| a.1[k].min(b.1[k])))
}

/// The longest stretch that is wrong along a line, and whether there is a skin; `None` where host or openings are
/// open.
fn compare(host: &Soup, tools: &[Soup], left: &Soup, line: &ProbeLine) -> Option<(f64, bool)> {
    let whole = line.inside(host, true)?;
    let mut removed = Vec::new();
    for tool in tools {
        removed.extend(line.inside(tool, false)?);
    }
    let right = without(&whole, &union(removed));
    // What was closed and is not any more is wrong.
    let Some(left) = line.inside(left, true) else { return Some((f64::INFINITY, false)) };
    let missing = without(&right, &left).into_iter().chain(without(&left, &right));
    let worst = missing.map(|s| s[1] - s[0]).fold(0.0, f64::max);
    let is_real = |s: &&[f64; 2]| s[1] - s[0] > NOTHING_M;
    let is_skin = |s: &[f64; 2]| {
        s[1] - s[0] < SKIN_M
            && !right.iter().filter(is_real).any(|r| r[0] < s[1] + TOLERANCE_M && r[1] > s[0] - TOLERANCE_M)
    };
    Some((worst, left.iter().any(is_skin)))
}

/// SplitMix64: the same lines every time.
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    /// The next number between 0 and 1.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::super::line::tests::cuboid;
    use super::*;

    fn joined(a: &Soup, b: &Soup) -> Soup {
        let mut all = a.clone();
        let first = a.vertices.len() as u32;
        all.vertices.extend(&b.vertices);
        all.triangles.extend(b.triangles.iter().map(|t| t.map(|i| i + first)));
        all
    }

    #[test]
    fn right_wrong_and_open() {
        let (host, tool) = (cuboid([0.0; 3], [4.0, 1.0, 3.0]), cuboid([1.0, -1.0, -1.0], [2.0, 2.0, 4.0]));
        let left = joined(&cuboid([0.0; 3], [1.0, 1.0, 3.0]), &cuboid([2.0, 0.0, 0.0], [4.0, 1.0, 3.0]));
        assert_eq!(judge(&host, std::slice::from_ref(&tool), &left, 40), Finding::Right);
        assert!(matches!(judge(&host, std::slice::from_ref(&tool), &host, 40), Finding::Wrong(_)));
        let skin = joined(&left, &cuboid([1.0, 0.0, 0.0], [2.0, 2e-5, 3.0]));
        assert!(matches!(judge(&host, std::slice::from_ref(&tool), &skin, 40), Finding::Wrong(_)));
        let mut open = host.clone();
        open.triangles.drain(6..8);
        assert_eq!(judge(&open, &[tool], &left, 40), Finding::Open);
    }
}
