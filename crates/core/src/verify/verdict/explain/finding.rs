//! What is stated of an object, fact by fact.

use super::cause::{Cause, Shortfall};
use crate::evidence::Loa;
use crate::verify::evidence::{Evidence, Why};
use crate::verify::model::{EvidenceModel, ModelKind, Question, measures_deviations};
use crate::verify::surface::{FittedObject, FittedSurface};
use crate::verify::verdict::best_loa::best_loa;
use crate::verify::verdict::counts::Counts;
use crate::verify::verdict::inquiry::Inquiry;
use crate::verify::verdict::reason::Reason;
use crate::verify::verdict::rule::{Verdict, VerdictRule};
use crate::{Interrupt, Result};

/// One fact; shares without unit, lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// The verdict, and what was asked.
    Verdict { verdict: Verdict, question: Question },
    /// That deviations were not measured, so that tolerances mean little.
    NoDeviations { kind: ModelKind },
    /// How much was seen.
    Seen { seen: u64, samples: u64, stations: usize },
    /// That few beams told of each place, and a place counts from this belief on.
    Together { confidence: f64 },
    /// What kept the rest from being seen, the largest share first.
    Kept { shares: Vec<(Why, f64)> },
    /// How what was seen divides.
    Divided { in_place: f64, elsewhere: f64, empty: f64, silent: f64, tolerance: f64 },
    /// What decided.
    Because { verdict: Verdict, cause: Cause, tolerance: f64 },
    /// Where 95 % of the surface lies, and how well that is known.
    Accuracy { quantile: f64, sd: f64 },
    /// The finest class that holds.
    Best { loa: Loa },
    /// The next finer class, and why it is not claimed.
    NoFiner { loa: Loa, shortfall: Shortfall },
}

impl Finding {
    /// All that is to be said of an object, in the order in which it is read.
    pub fn all(
        evidence: &Evidence,
        question: &Question,
        rule: &VerdictRule,
        interrupt: Interrupt,
    ) -> Result<Vec<Self>> {
        let inquiry = Inquiry::of(evidence, question, rule, interrupt)?;
        let Inquiry { model, fitted, judgement } = &inquiry;
        let (verdict, totals, tolerance) = (judgement.verdict(), &judgement.tally.totals, question.tolerance());
        let mut all = vec![Self::Verdict { verdict, question: *question }];
        if !measures_deviations(model) {
            all.push(Self::NoDeviations { kind: model.kind });
        }
        let stations = evidence.stations().len();
        all.push(Self::Seen { seen: totals.seen, samples: totals.samples, stations });
        if model.question.confidence < question.confidence {
            all.push(Self::Together { confidence: model.question.confidence });
        }
        // Contradictions divide nothing, and of a few samples shares are no shares.
        if !matches!(judgement.reason, Reason::TooLittleSeen | Reason::Contradiction) {
            all.push(Self::divided(totals, tolerance));
        }
        all.push(Self::Because { verdict, cause: Cause::of(judgement, fitted, rule), tolerance });
        all.extend(evidence.unseen.filter(|_| verdict == Verdict::Unobserved).map(|u| Self::kept(&u.shares())));
        if measures_deviations(model) && totals.on_surface > 0 && judgement.stands(rule) {
            all.extend(Self::accuracy(fitted));
            let best = best_loa(&inquiry, question, rule, interrupt)?;
            all.extend(best.map(|loa| Self::Best { loa }));
            all.extend(Self::no_finer(best, fitted, &evidence.asked(question)));
        }
        Ok(all)
    }

    fn divided(totals: &Counts, tolerance: f64) -> Self {
        let share = |part: u64| part as f64 / totals.seen.max(1) as f64;
        Self::Divided {
            in_place: share(totals.in_place()),
            elsewhere: share(totals.out_of_tolerance),
            empty: share(totals.pierced),
            silent: share(totals.seen.saturating_sub(totals.decided())),
            tolerance,
        }
    }

    fn kept(shares: &[f64; 7]) -> Self {
        let mut shares: Vec<_> = Why::ALL.into_iter().zip(*shares).filter(|(_, share)| *share >= 0.01).collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        Self::Kept { shares }
    }

    /// Of the surface that is known least to lie where it is drawn.
    fn accuracy(fitted: &FittedObject) -> Option<Self> {
        let seen = fitted.surfaces.iter().filter(|s| s.inliers > 0);
        let worst: &FittedSurface = seen.max_by(|a, b| a.quantile.total_cmp(&b.quantile))?;
        Some(Self::Accuracy { quantile: worst.quantile, sd: worst.sd })
    }

    fn no_finer(best: Option<Loa>, fitted: &FittedObject, model: &EvidenceModel) -> Option<Self> {
        let finer = Loa::ALL.into_iter().find(|loa| best.is_none_or(|best| *loa > best))?;
        Some(Self::NoFiner { loa: finer, shortfall: Shortfall::of(fitted, finer.upper(), model) })
    }
}
