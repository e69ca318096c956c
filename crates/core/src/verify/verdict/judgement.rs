//! How the counts of an object's faces become a verdict.

use super::reason::Reason;
use super::rule::{Verdict, VerdictRule};
use super::tally::VerdictTally;
use super::thresholds::{MIN_CONFIRMED_OF_SEEN, MIN_DECIDED, MIN_INDEPENDENT};
use crate::verify::model::{EvidenceModel, measures_deviations};
use crate::verify::surface::FittedObject;
use crate::{Interrupt, Result};

/// A verdict with all that it was made from.
pub struct Judgement {
    pub reason: Reason,
    pub tally: VerdictTally,
}

impl Judgement {
    /// Judges at the tolerance and confidence of `model`.
    pub fn of(fitted: &FittedObject, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Self> {
        let tally = VerdictTally::of(fitted, model, rule, interrupt)?;
        let reason = decide(&tally, measures_deviations(model), rule);
        let elsewhere = tally.found_elsewhere(model.question.tolerance()).map(Reason::Elsewhere);
        let reason = elsewhere.filter(|_| reason != Reason::Contradiction).unwrap_or(reason);
        Ok(Self { reason, tally })
    }

    pub fn verdict(&self) -> Verdict {
        self.reason.verdict()
    }

    /// Whether the object stands where its faces tell: surfaces met where an absent object should stand are not its
    /// own, and what stands beside its place does not tell how far off it is.
    pub fn stands(&self, rule: &VerdictRule) -> bool {
        let is_here = !matches!(self.reason, Reason::Empty | Reason::Elsewhere(_)) && !self.tally.is_beside();
        is_here && self.tally.totals.cover(rule)
    }

    /// The face whose deviation stands for the object, with that and its σ, metres: one that was found elsewhere where
    /// none at its place has a number.
    pub fn face_meant(&self, stands: bool) -> Option<(usize, Option<(f64, f64)>)> {
        let here = self.tally.face_meant().filter(|_| stands).map(|i| (i, self.tally.faces[i].deviation));
        let has_none = here.is_none_or(|(_, deviation)| deviation.is_none());
        let may_be_elsewhere = has_none && self.verdict() == Verdict::Deviating;
        let elsewhere = self.tally.found.filter(|_| may_be_elsewhere);
        elsewhere.map(|f| (f.face as usize, Some((f.deviation, f.sd)))).or(here)
    }
}

/// The first reason that holds.
fn decide(tally: &VerdictTally, measures_deviations: bool, rule: &VerdictRule) -> Reason {
    let totals = &tally.totals;
    let (seen, decided) = (totals.seen as f64, totals.decided() as f64);
    if !totals.cover(rule) {
        return Reason::TooLittleSeen;
    }
    // Before "undecided": contradiction is what leaves samples open. The conflict of a model that measures no
    // deviations says nothing of this kind.
    if measures_deviations && totals.conflict > rule.max_conflict * seen {
        return Reason::Contradiction;
    }
    if decided == 0.0 || decided < MIN_DECIDED * seen {
        return Reason::TooLittleDecided;
    }
    if tally.is_empty() {
        return if tally.is_beside() { Reason::Beside } else { Reason::Empty };
    }
    if let Some(surface) = tally.displaced.iter().position(|d| *d) {
        return Reason::Displaced(surface);
    }
    if let Some(surface) = tally.surfaces.iter().position(|s| tally.is_mostly_seen_through(s)) {
        return Reason::SeenThrough(surface);
    }
    if (totals.in_place() as f64) < rule.min_present * decided {
        return Reason::OutOfPlace;
    }
    // Too rough or too noisy for this tolerance; a model that measures no deviations leaves most open by its nature.
    let unsure = !tally.known_to_hold && (totals.confirmed as f64) < MIN_CONFIRMED_OF_SEEN * seen;
    let few = tally.independent < MIN_INDEPENDENT.min(totals.samples as f64);
    match () {
        () if measures_deviations && unsure => Reason::TooUnsure,
        () if measures_deviations && few => Reason::TooFewMeasured,
        () => Reason::InPlace,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::Counts;

    /// An object of 1000 samples in two surfaces, half of them seen, all of these in place.
    fn in_place() -> VerdictTally {
        let half = Counts { samples: 500, seen: 250, confirmed: 250, on_surface: 250, ..Counts::default() };
        let mut totals = half;
        totals.add(&half);
        VerdictTally {
            faces: Vec::new(),
            totals,
            surfaces: vec![half; 2],
            displaced: vec![false; 2],
            known_to_hold: true,
            independent: 100.0,
            is_slim: false,
            in_front_unexplained: 0,
            found: None,
        }
    }

    /// What is seen, refuted as seen through, is on the surface, and is confirmed.
    fn counted(seen: u64, pierced: u64, on_surface: u64, confirmed: u64) -> VerdictTally {
        let tally = in_place();
        let totals = Counts { seen, refuted: pierced, pierced, on_surface, confirmed, ..tally.totals };
        VerdictTally { totals, surfaces: Vec::new(), ..tally }
    }

    #[test]
    fn a_case_for_each_reason() {
        let rule = VerdictRule::default();
        let slim =
            |in_front_unexplained| VerdictTally { is_slim: true, in_front_unexplained, ..counted(500, 450, 10, 0) };
        let contradicting = |conflict| {
            let tally = in_place();
            VerdictTally { totals: Counts { conflict, ..tally.totals }, ..tally }
        };
        let half_through = || {
            let tally = in_place();
            let through = Counts { samples: 500, seen: 250, refuted: 200, pierced: 200, ..Counts::default() };
            VerdictTally { surfaces: vec![tally.surfaces[0], through], ..tally }
        };
        let few = VerdictTally { independent: 1.9, ..in_place() };
        let unsure = |known_to_hold| VerdictTally { known_to_hold, ..counted(500, 0, 500, 200) };
        let far_off = {
            let tally = counted(500, 180, 300, 0);
            VerdictTally { totals: Counts { out_of_tolerance: 280, ..tally.totals }, ..tally }
        };
        let cases = [
            (counted(4, 0, 4, 4), Reason::TooLittleSeen, Verdict::Unobserved),
            (counted(19, 0, 19, 19), Reason::TooLittleSeen, Verdict::Unobserved),
            (counted(20, 0, 20, 20), Reason::InPlace, Verdict::Confirmed),
            (contradicting(151.0), Reason::Contradiction, Verdict::Conflicting),
            (contradicting(149.0), Reason::InPlace, Verdict::Confirmed),
            (counted(500, 0, 99, 0), Reason::TooLittleDecided, Verdict::Unobserved),
            (counted(500, 0, 0, 0), Reason::TooLittleDecided, Verdict::Unobserved),
            (counted(500, 450, 10, 0), Reason::Empty, Verdict::Absent),
            (slim(539), Reason::Empty, Verdict::Absent),
            (slim(540), Reason::Beside, Verdict::Deviating),
            (VerdictTally { displaced: vec![false, true], ..in_place() }, Reason::Displaced(1), Verdict::Deviating),
            (half_through(), Reason::SeenThrough(1), Verdict::Deviating),
            (far_off, Reason::OutOfPlace, Verdict::Deviating),
            (unsure(false), Reason::TooUnsure, Verdict::Unobserved),
            (unsure(true), Reason::InPlace, Verdict::Confirmed),
            (few, Reason::TooFewMeasured, Verdict::Unobserved),
            (in_place(), Reason::InPlace, Verdict::Confirmed),
        ];
        for (i, (tally, reason, verdict)) in cases.iter().enumerate() {
            let found = decide(tally, true, &rule);
            assert_eq!((found, found.verdict()), (*reason, *verdict), "case {i}");
        }
    }

    #[test]
    fn without_deviations_neither_conflict_nor_roughness_decide() {
        let rule = VerdictRule::default();
        let open = VerdictTally { known_to_hold: false, ..counted(500, 0, 0, 200) };
        let conflicting = VerdictTally { totals: Counts { conflict: 400.0, ..open.totals }, ..open };
        assert_eq!(decide(&conflicting, false, &rule), Reason::InPlace);
        assert_eq!(decide(&conflicting, true, &rule), Reason::Contradiction);
    }
}
