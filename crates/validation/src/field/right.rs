//! What a verdict must be, from what an ideal observer sees. Stated beside the figures in `report.md`; change both.

use asbuilt_core::verify::Verdict;

use super::fate::{Deed, Fate};
use super::layout::Object;
use super::observer::Truth;

/// From this share of an object's surface on something must be said of it; below the lower one nothing may be.
const MUST_SEE: f64 = 0.05;
const MAY_SEE: f64 = 0.01;
/// With fewer beams on it than these, or fewer a square metre, an object may stay unobserved; with fewer than the least
/// nothing may be said of it.
const FEW_BEAMS: f64 = 60.0;
const FEW_BEAMS_A_M2: f64 = 100.0;
const LEAST_BEAMS: f64 = 10.0;
/// Share of every well-seen surface that must keep the tolerance (USIBD).
const KEEPS: f64 = 0.95;
/// Least share of the seen surface, number of samples and of beams with which a face is well seen, and with which it may
/// be held to be.
const WELL: WellSeen = WellSeen { share: 0.03, samples: 10, beams: 40.0 };
const PERHAPS: WellSeen = WellSeen { share: 0.01, samples: 4, beams: 6.0 };
/// Least share of an object's visible built surface with which it can be recognised beside its place.
const RECOGNISED: f64 = 0.25;

/// What is right, and why.
#[derive(Debug, Clone)]
pub struct Right {
    /// Right verdicts.
    pub verdicts: Vec<Verdict>,
    /// Share of the surface that is seen as built and is nobody else's.
    pub seen: f64,
    /// Share of the surface whose place is seen empty.
    pub empty: f64,
    /// Share of the surface that lies on another object's.
    pub shared: f64,
    /// The worst surface's distance from its drawing that 95 % of it keeps, metres.
    pub worst_m: f64,
    /// Beams that say anything of it.
    pub beams: f64,
    /// Who hides most of what is hidden.
    pub hidden_by: Option<u32>,
}

/// The right verdicts on an object at a tolerance; what lies within `border` of the tolerance, metres, is free.
/// `returns`: of the object, at all stations.
pub fn right(object: &Object, fate: &Fate, (truths, returns): (&[Truth], usize), tolerance: f64, border: f64) -> Right {
    let answers = |t: &&Truth| !t.glass;
    let opaque = truths.iter().filter(answers).count();
    // An object of glass alone is all pane.
    let base = if opaque > 0 { opaque } else { truths.len() } as f64;
    let own: Vec<&Truth> = truths.iter().filter(|t| t.own()).collect();
    let through: Vec<&Truth> = truths.iter().filter(|t| t.beams_through > 0.0).collect();
    let shared = truths.iter().filter(|t| t.shared_with.is_some()).count();
    let mut out = Right {
        verdicts: Vec::new(),
        seen: own.len() as f64 / base,
        empty: through.len() as f64 / base,
        shared: shared as f64 / truths.len() as f64,
        worst_m: f64::NAN,
        beams: 0.0,
        hidden_by: most_frequent(truths.iter().filter_map(|t| t.hidden_by)),
    };
    match fate.deed {
        Deed::Missing => {
            // A leaf that is gone is as one that stands open: what is asked is the frame.
            let has_frame = truths.iter().any(|t| !t.leaf);
            let asked = |t: &&&Truth| !t.leaf || !has_frame;
            out.empty = through.iter().filter(asked).count() as f64 / base;
            out.beams = through.iter().filter(asked).map(|t| t.beams_through).sum();
            out.missing(opaque == 0);
        }
        Deed::Open => {
            out.beams = own.iter().map(|t| t.beams_on).sum::<f64>().min(returns as f64);
            out.verdicts = vec![Verdict::Confirmed, Verdict::Unobserved];
        }
        Deed::AsDrawn | Deed::Displaced => {
            out.beams = own.iter().map(|t| t.beams_on).sum::<f64>().min(returns as f64);
            let past = truths.iter().filter(|t| t.beams_through + t.beams_past > 0.0).count() as f64 / base;
            let is_displaced = fate.displaced.norm() > 0.0;
            out.built(&own, tolerance, border, is_displaced && past >= MAY_SEE);
            out.laid_bare(truths, base, tolerance, border);
        }
    }
    if object.twin {
        out.verdicts = ALL.to_vec();
    }
    out
}

const ALL: [Verdict; 5] =
    [Verdict::Confirmed, Verdict::Deviating, Verdict::Absent, Verdict::Unobserved, Verdict::Conflicting];

impl Right {
    /// Absent, which is true; where little of its place is seen empty, or no more than panes, nothing need be said.
    fn missing(&mut self, only_glass: bool) {
        let (seen, few) = (self.empty, self.beams < FEW_BEAMS);
        self.verdicts.push(Verdict::Absent);
        if seen < MUST_SEE || few || only_glass {
            self.verdicts.push(Verdict::Unobserved);
        }
    }

    /// Confirmed or deviating by the worst surface, if enough of what was built is seen. `has_left`: it is displaced, and
    /// beams passed some of its place.
    fn built(&mut self, own: &[&Truth], tolerance: f64, border: f64, has_left: bool) {
        let area: f64 = own.iter().map(|t| t.area).sum();
        let few = self.beams < FEW_BEAMS || self.beams < FEW_BEAMS_A_M2 * area;
        if self.seen < MUST_SEE || few {
            self.verdicts.push(Verdict::Unobserved);
        }
        if self.seen >= MAY_SEE && self.beams >= LEAST_BEAMS {
            let (most, sure) = worst(own, &WELL);
            self.worst_m = most;
            if sure <= tolerance + border {
                self.verdicts.push(Verdict::Confirmed);
            }
            if worst(own, &PERHAPS).0.max(most) > tolerance - border {
                self.verdicts.push(Verdict::Deviating);
            }
        }
        // Too little of it beside its empty place to recognise it, or none.
        let keeps = self.worst_m <= tolerance - border;
        if has_left && self.seen < RECOGNISED && !keeps {
            self.verdicts.push(Verdict::Absent);
        }
    }

    /// Where what covers it is not there, what is seen may be it, or the other, displaced: it may be taken for what it
    /// is.
    fn laid_bare(&mut self, truths: &[Truth], base: f64, tolerance: f64, border: f64) {
        let is_seen = |t: &&Truth| t.beams_on > 0.0 && !t.turned;
        let bare = truths.iter().filter(is_seen).filter(|t| t.covered).count() as f64 / base;
        if bare < MAY_SEE {
            return;
        }
        let seen: Vec<&Truth> = truths.iter().filter(is_seen).filter(|t| t.covered || t.own()).collect();
        let keeps = worst(&seen, &WELL).1 <= tolerance + border;
        let may_be_off = worst(&seen, &PERHAPS).0 > tolerance - border;
        for (verdict, is_right) in [(Verdict::Confirmed, keeps), (Verdict::Deviating, may_be_off)] {
            if is_right && !self.verdicts.contains(&verdict) {
                self.verdicts.push(verdict);
            }
        }
    }
}

/// What makes a face well seen.
struct WellSeen {
    share: f64,
    samples: usize,
    beams: f64,
}

/// The distance that 95 % of the worst well-seen surface keep, metres, and the one that they keep less two standard
/// deviations of chance: at 200 samples, 92 %.
fn worst(own: &[&Truth], well: &WellSeen) -> (f64, f64) {
    let faces = own.iter().map(|t| t.face).max().unwrap_or(0) + 1;
    let mut by_face: Vec<Vec<&Truth>> = vec![Vec::new(); faces];
    own.iter().for_each(|t| by_face[t.face].push(t));
    let is_well_seen = |face: &Vec<&Truth>| {
        let least = well.samples.min(own.len());
        let beams: f64 = face.iter().map(|t| t.beams_on).sum();
        face.len() >= least && face.len() as f64 >= well.share * own.len() as f64 && beams >= well.beams
    };
    let all = own.to_vec();
    let kept = by_face.into_iter().filter(is_well_seen).chain([all]).map(|face| {
        let mut d: Vec<f64> = face.iter().map(|t| t.distance).collect();
        d.sort_by(f64::total_cmp);
        let chance = 2.0 * (KEEPS * (1.0 - KEEPS) / d.len().min(200) as f64).sqrt();
        let at = |share: f64| d[((d.len() as f64 * share) as usize).min(d.len() - 1)];
        (at(KEEPS), at((KEEPS - chance).max(0.0)))
    });
    kept.fold((0.0, 0.0), |(a, b), (x, y)| (a.max(x), b.max(y)))
}

fn most_frequent(owners: impl Iterator<Item = u32>) -> Option<u32> {
    let mut counts = std::collections::BTreeMap::new();
    owners.for_each(|o| *counts.entry(o).or_insert(0usize) += 1);
    counts.into_iter().max_by_key(|(_, n)| *n).map(|(o, _)| o)
}
