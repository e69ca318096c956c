//! What may be said of an object between two epochs, from what an ideal observer sees in both. Stated beside the figures
//! in `report.md`; change both.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::verify::ObjectChangeClass as Class;

use super::deed::{Deed, Done};
use crate::field::observer::Truth;
use crate::field::samples::Sample;

/// From this share of an object's surface on, seen in both epochs, something must be said.
const MUST_SEE: f64 = 0.05;
/// With fewer beams than these in either epoch, or fewer a square metre, nothing need be.
const FEW_BEAMS: f64 = 60.0;
const FEW_BEAMS_A_M2: f64 = 100.0;
/// A part smaller than this, of what is seen of the object in both epochs, need not be told.
const PART: f64 = 0.2;
/// Least share of what an object showed with which it can be recognised beside its place.
const RECOGNISED: f64 = 0.25;
/// Least samples of a face by which a displacement is told.
const FACE: usize = 10;
/// Registrations of two epochs, and what construction leaves, decide below this many σ of their difference.
const REGISTRATION_SIGMAS: f64 = 4.5;

/// What an ideal observer sees of an object in one epoch.
pub struct Seen {
    pub truths: Vec<Truth>,
    /// Returns from it.
    pub returns: usize,
}

/// What may be said, and why.
#[derive(Debug, Clone)]
pub struct Right {
    pub classes: Vec<Class>,
    /// Shares of the surface: there in both, in the old epoch alone, in the new one alone, in neither.
    pub kept: f64,
    pub lost: f64,
    pub won: f64,
    pub empty: f64,
    /// Beams on these in the epoch that has fewer.
    pub beams: f64,
    /// The largest displacement along the normal of a face that both epochs see, metres.
    pub visible_m: f64,
}

/// The classes that may be said. `common_sd`: of the registrations of both epochs and of ranges, metres.
pub fn right(deed: &Deed, samples: &[Sample], [old, new]: &[Seen; 2], common_sd: f64) -> Right {
    let (mut out, only_glass) = shares(old, new);
    let whole = match deed.done {
        Done::Stands | Done::Moved | Done::Turned => out.kept,
        Done::Missing => out.empty,
        Done::Appeared => out.won,
        Done::Gone => out.lost,
        Done::Partly => out.kept + out.lost + out.won,
    };
    let part = (out.lost + out.won) / (out.kept + out.lost + out.won).max(1e-9);
    let by = deed.fates[1].shift - deed.fates[0].shift;
    out.visible_m = if deed.done == Done::Moved { visible(samples, old, new, &by) } else { 0.0 };
    out.classes = match deed.done {
        Done::Stands | Done::Missing => vec![Class::Unchanged],
        Done::Appeared => vec![Class::Appeared],
        Done::Gone => vec![Class::Gone],
        Done::Turned => vec![Class::Unchanged, Class::Partly, Class::Moved],
        Done::Moved => moved(&out, REGISTRATION_SIGMAS * common_sd),
        Done::Partly => {
            let mut classes = vec![Class::Partly];
            if part < PART || out.lost + out.won < MUST_SEE {
                classes.push(Class::Unchanged);
            }
            if part > 1.0 - PART || out.kept < MUST_SEE {
                classes.push(if out.lost > out.won { Class::Gone } else { Class::Appeared });
            }
            classes
        }
    };
    let area: f64 = whole * samples.iter().map(|s| s.area).sum::<f64>();
    if whole < MUST_SEE || out.beams < FEW_BEAMS || out.beams < FEW_BEAMS_A_M2 * area || only_glass {
        out.classes.push(Class::NotComparable);
    }
    out
}

/// Moved; unchanged where no face shows so much of it; and where too little of it is beside its empty place to be
/// recognised, gone or appeared.
fn moved(seen: &Right, border: f64) -> Vec<Class> {
    let mut classes = vec![Class::Moved];
    if seen.visible_m < border {
        classes.push(Class::Unchanged);
    }
    let recognised = RECOGNISED * (seen.kept + seen.lost + seen.won);
    if seen.kept < recognised {
        classes.push(if seen.lost > seen.won { Class::Gone } else { Class::Appeared });
    }
    classes
}

fn shares(old: &Seen, new: &Seen) -> (Right, bool) {
    let opaque = old.truths.iter().filter(|t| !t.glass).count();
    let base = if opaque > 0 { opaque } else { old.truths.len() }.max(1) as f64;
    let mut out = Right { classes: Vec::new(), kept: 0.0, lost: 0.0, won: 0.0, empty: 0.0, beams: 0.0, visible_m: 0.0 };
    let mut beams = [0.0; 2];
    for (a, b) in old.truths.iter().zip(&new.truths) {
        let is_through = |t: &Truth| t.beams_through > 0.0;
        let to = match () {
            () if a.own() && b.own() => &mut out.kept,
            () if a.own() && is_through(b) => &mut out.lost,
            () if is_through(a) && b.own() => &mut out.won,
            () if is_through(a) && is_through(b) => &mut out.empty,
            () => continue,
        };
        *to += 1.0 / base;
        for (sum, t) in beams.iter_mut().zip([a, b]) {
            *sum += if t.own() { t.beams_on } else { t.beams_through };
        }
    }
    let limited = |sum: f64, seen: &Seen| if seen.returns > 0 { sum.min(seen.returns as f64) } else { sum };
    out.beams = limited(beams[0], old).min(limited(beams[1], new));
    (out, opaque == 0)
}

/// The largest part of a displacement along the normal of a face of which both epochs see enough, metres.
fn visible(samples: &[Sample], old: &Seen, new: &Seen, by: &Vec3) -> f64 {
    let faces = samples.iter().map(|s| s.face).max().unwrap_or(0) + 1;
    let mut count = vec![0; faces];
    let mut along = vec![0f64; faces];
    for ((s, a), b) in samples.iter().zip(&old.truths).zip(&new.truths) {
        if a.own() && b.own() {
            count[s.face] += 1;
            along[s.face] = along[s.face].max(s.normal.dot(by).abs());
        }
    }
    along.iter().zip(count).filter(|(_, n)| *n >= FACE).map(|(d, _)| *d).fold(0.0, f64::max)
}
