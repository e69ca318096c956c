//! The verdict on an object with its numbers.

use super::best_loa::best_loa;
use super::counts::Counts;
use super::inquiry::Inquiry;
use super::rule::{Verdict, VerdictRule};
use crate::evidence::Loa;
use crate::geometry::Vec3;
use crate::verify::evidence::{Evidence, Unseen};
use crate::verify::model::Question;
use crate::verify::surface::{Shift, shift_of};
use crate::{Interrupt, Result};

/// Verdict with the numbers that led to it: SQL's `ab_summary`.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The verdict at the asked level of accuracy.
    pub verdict: Verdict,
    /// The finest level of accuracy at which the object would be confirmed.
    pub best_loa: Option<Loa>,
    /// All samples.
    pub samples: u64,
    /// Share of all samples that were seen.
    pub coverage: f64,
    /// Shares of the seen samples; `None` when none was seen. They add up to 1.
    pub shares: Option<Shares>,
    /// Median deviation of the face that stands for the object, along its outward normal, metres, and its σ.
    pub deviation: Option<(f64, f64)>,
    /// That face, its number counted from 1, and its normal.
    pub deviation_face: Option<(usize, Vec3)>,
    /// Rigid offset.
    pub shift: Option<Shift>,
    /// Why it is unobserved, where somebody looked a second time.
    pub unseen: Option<Unseen>,
}

/// How the seen samples divide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Belief in "built here" reaches the confidence.
    pub confirmed: f64,
    /// Belief in "not built here" reaches it.
    pub refuted: f64,
    /// Neither.
    pub open: f64,
    /// Mean conflict between stations.
    pub conflict: f64,
}

/// Less than this share of an object that was seen leaves it open, as no number does.
const LITTLE: f64 = 0.1;

impl Summary {
    /// Whether a second look may tell more: what was met, if anything, gives no number, or little was.
    pub fn is_open(&self) -> bool {
        self.verdict != Verdict::Conflicting && (self.deviation.is_none() || self.coverage < LITTLE)
    }
}

impl Shares {
    fn of(totals: &Counts) -> Option<Self> {
        let seen = totals.seen as f64;
        (totals.seen > 0).then(|| Self {
            confirmed: totals.confirmed as f64 / seen,
            refuted: totals.refuted as f64 / seen,
            open: totals.open() as f64 / seen,
            conflict: totals.conflict / seen,
        })
    }
}

impl Evidence {
    /// Verdict, shares, deviation, rigid offset and best level of accuracy.
    pub fn summary(&self, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<Summary> {
        let inquiry = Inquiry::of(self, question, rule, interrupt)?;
        let Inquiry { fitted, judgement, .. } = &inquiry;
        let (totals, stands) = (&judgement.tally.totals, judgement.stands(rule));
        let face = judgement.face_meant(stands);
        Ok(Summary {
            verdict: judgement.verdict(),
            best_loa: best_loa(&inquiry, question, rule, interrupt)?,
            samples: totals.samples,
            coverage: if totals.samples > 0 { totals.seen as f64 / totals.samples as f64 } else { 0.0 },
            shares: Shares::of(totals),
            deviation: face.and_then(|f| f.1),
            deviation_face: face.map(|(number, _)| (number + 1, judgement.tally.faces[number].normal)),
            shift: if stands { shift_of(self, &fitted.faces, interrupt)? } else { None },
            unseen: self.unseen.filter(|_| judgement.verdict() == Verdict::Unobserved),
        })
    }
}
