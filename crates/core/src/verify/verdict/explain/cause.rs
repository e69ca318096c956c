//! The fact that decided.

use crate::geometry::Vec3;
use crate::verify::model::EvidenceModel;
use crate::verify::surface::FittedObject;
use crate::verify::verdict::counts::Counts;
use crate::verify::verdict::judgement::Judgement;
use crate::verify::verdict::reason::Reason;
use crate::verify::verdict::rule::VerdictRule;
use crate::verify::verdict::tally::allowed_out_of_tolerance;
use crate::verify::verdict::thresholds::{MIN_CONFIRMED_OF_SEEN, MIN_DECIDED, MIN_EMPTY, MIN_INDEPENDENT, MIN_SEEN};

/// What decided, with its numbers beside what the rule asks; shares without unit, lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// Nothing was seen.
    NothingSeen,
    /// So few samples were seen.
    FewSeen { seen: u64, asked: u64 },
    /// So small a share was seen.
    LittleSeen { share: f64, asked: f64 },
    /// Stations contradict each other: mean conflict.
    Contradiction { conflict: f64, most: f64 },
    /// So small a share of what was seen tells anything.
    LittleDecided { share: f64, asked: f64 },
    /// So large a share of what tells anything was seen empty.
    Empty { share: f64, most: f64 },
    /// The same, and something that no other object explains stands beside it.
    Beside { share: f64 },
    /// More of a face was found elsewhere: so far off, and its σ; so many samples of it.
    Elsewhere { normal: Vec3, deviation: f64, sd: f64, share: f64 },
    /// So little of a surface keeps the tolerance; `enough` would have been, by what chance explains.
    Displaced { surface: SurfaceMeant, within: f64, asked: f64, enough: f64 },
    /// So much of a surface was seen empty.
    SeenThrough { surface: SurfaceMeant, empty: f64 },
    /// So little of what tells anything is in place.
    OutOfPlace { share: f64, asked: f64 },
    /// In place, but not known well enough: σ of where it is.
    TooUnsure { sd: f64, certain: f64, asked: f64 },
    /// What was seen lies where it is drawn, but too few measurements tell.
    TooFewMeasured { independent: f64, asked: f64 },
    /// Every well-seen surface keeps the tolerance in as much of it as is asked.
    InPlace { asked: f64 },
}

/// Which surface is meant.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceMeant {
    /// All as one.
    All,
    /// A smooth surface of so many faces, by its best seen one.
    Smooth {
        faces: usize,
        /// Outward unit normal.
        normal: Vec3,
        /// Median deviation along it, metres, and its standard deviation.
        deviation: Option<(f64, f64)>,
    },
}

impl Cause {
    /// Of a judgement.
    pub fn of(judgement: &Judgement, fitted: &FittedObject, rule: &VerdictRule) -> Self {
        let tally = &judgement.tally;
        let totals = &tally.totals;
        let (seen, decided) = (totals.seen.max(1) as f64, totals.decided().max(1) as f64);
        let (empty, in_place) = (totals.pierced as f64 / decided, totals.in_place() as f64 / decided);
        match judgement.reason {
            Reason::TooLittleSeen => Self::too_little_seen(totals, rule),
            Reason::Contradiction => Self::Contradiction { conflict: totals.conflict / seen, most: rule.max_conflict },
            Reason::TooLittleDecided => {
                Self::LittleDecided { share: totals.decided() as f64 / seen, asked: MIN_DECIDED }
            }
            Reason::Empty => Self::Empty { share: empty, most: MIN_EMPTY },
            Reason::Beside => Self::Beside { share: empty },
            Reason::Elsewhere(face) => Self::elsewhere(judgement, face),
            Reason::Displaced(surface) => Self::displaced(judgement, fitted, surface, rule.min_within),
            Reason::SeenThrough(surface) => {
                let counts = &tally.surfaces[surface];
                let decided = counts.confirmed.max(counts.on_surface) + counts.pierced;
                let empty = counts.pierced as f64 / decided.max(1) as f64;
                Self::SeenThrough { surface: SurfaceMeant::of(judgement, surface), empty }
            }
            Reason::OutOfPlace => Self::OutOfPlace { share: in_place, asked: rule.min_present },
            Reason::TooUnsure => Self::TooUnsure {
                sd: fitted.whole.sd,
                certain: totals.confirmed as f64 / seen,
                asked: MIN_CONFIRMED_OF_SEEN,
            },
            Reason::TooFewMeasured => {
                Self::TooFewMeasured { independent: fitted.whole.independent, asked: MIN_INDEPENDENT }
            }
            Reason::InPlace => Self::InPlace { asked: rule.min_within },
        }
    }

    fn too_little_seen(totals: &Counts, rule: &VerdictRule) -> Self {
        let least = MIN_SEEN.min(totals.samples);
        match totals.seen {
            0 => Self::NothingSeen,
            seen if seen < least => Self::FewSeen { seen, asked: least },
            seen => Self::LittleSeen { share: seen as f64 / totals.samples as f64, asked: rule.min_coverage },
        }
    }

    fn elsewhere(judgement: &Judgement, face: usize) -> Self {
        let face = &judgement.tally.faces[face];
        let (deviation, sd, samples) = judgement.tally.found.map_or((0.0, 0.0, 0), |f| (f.deviation, f.sd, f.samples));
        let share = (f64::from(samples) / face.counts.samples.max(1) as f64).min(1.0);
        Self::Elsewhere { normal: face.normal, deviation, sd, share }
    }

    /// Where no surface is off by itself, all as one are.
    fn displaced(judgement: &Judgement, fitted: &FittedObject, surface: usize, asked: f64) -> Self {
        let tally = &judgement.tally;
        let off = |counts: &Counts, allowed: f64| counts.out_of_tolerance as f64 > allowed * counts.on_surface as f64;
        let one = (&tally.surfaces[surface], allowed_out_of_tolerance(&fitted.surfaces[surface], asked));
        let all = (&tally.totals, allowed_out_of_tolerance(&fitted.whole, asked));
        let ((counts, allowed), surface) =
            if off(one.0, one.1) { (one, SurfaceMeant::of(judgement, surface)) } else { (all, SurfaceMeant::All) };
        let within = 1.0 - counts.out_of_tolerance as f64 / counts.on_surface.max(1) as f64;
        Self::Displaced { surface, within, asked, enough: 1.0 - allowed }
    }
}

impl SurfaceMeant {
    fn of(judgement: &Judgement, surface: usize) -> Self {
        let faces = judgement.tally.faces.iter().filter(|f| f.smooth_surface as usize == surface);
        let best = faces.clone().max_by_key(|f| f.counts.seen);
        let normal = best.map_or_else(Vec3::zeros, |f| f.normal);
        let is_found = |face: u32| judgement.tally.faces[face as usize].smooth_surface as usize == surface;
        let found = judgement.tally.found.filter(|f| is_found(f.face)).map(|f| (f.deviation, f.sd));
        Self::Smooth { faces: faces.count(), normal, deviation: best.and_then(|f| f.deviation).or(found) }
    }
}

/// Why the next finer class is not claimed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shortfall {
    /// The survey proves it with this probability only.
    Unproven { probability: f64, asked: f64 },
    /// It would not be confirmed.
    NotKept,
}

impl Shortfall {
    /// Of `tolerance` metres, which were not confirmed as the finest class.
    pub fn of(fitted: &FittedObject, tolerance: f64, model: &EvidenceModel) -> Self {
        let surfaces = fitted.surfaces.iter().filter(|s| s.inliers > 0);
        let least = surfaces.map(|s| s.holds(tolerance)).fold(fitted.whole.holds(tolerance), f64::min);
        let asked = model.question.confidence;
        if least < asked { Self::Unproven { probability: least, asked } } else { Self::NotKept }
    }
}
