//! The numbers of a set of cases.

use anyhow::{Result, bail};
use asbuilt_core::verify::Verdict;

use super::bins::{Bin, equal_count};
use super::cases::Case;
use super::fate::Deed;
use super::layout::Kind;
use super::patches::Delivery;
use crate::tally::{Intervals, Share, calibration_error, reliability};

/// All numbers of a set.
pub struct Score<'a> {
    pub cases: &'a [Case],
}

impl<'a> Score<'a> {
    /// Of these cases.
    pub fn of(cases: &'a [Case]) -> Self {
        Self { cases }
    }

    /// The cases of one delivery.
    pub fn of_delivery(&self, delivery: Delivery) -> impl Iterator<Item = &'a Case> + Clone {
        self.cases.iter().filter(move |c| c.delivery == delivery)
    }

    /// Each question with its answer for a delivery.
    pub fn rows(&self, delivery: Delivery) -> Vec<(String, String)> {
        let all = || self.of_delivery(delivery);
        let right = |cases: Vec<&Case>| Share::of(cases, |c| c.is_right()).text();
        let mut out = vec![("verdict right".to_string(), right(all().collect()))];
        for kind in Kind::ALL {
            out.push((format!("— {}", kind.name()), right(all().filter(|c| c.kind == kind).collect())));
        }
        for deed in [Deed::AsDrawn, Deed::Displaced, Deed::Missing, Deed::Open] {
            out.push((format!("— {}", deed.name()), right(all().filter(|c| c.deed == deed).collect())));
        }
        let count = |hit: &dyn Fn(&Case) -> bool| Share::of(all(), |c| hit(c)).text();
        let missing = all().filter(|c| c.deed == Deed::Missing);
        let as_drawn = all().filter(|c| c.deed == Deed::AsDrawn);
        let open = all().filter(|c| c.deed == Deed::Open);
        let is_off = |c: &&Case| c.said == Verdict::Deviating && !c.is_right();
        out.extend([
            ("said to be absent and is not".into(), count(&Case::is_false_absent)),
            ("missing objects that are confirmed".into(), Share::of(missing, |c| c.is_missing_confirmed()).text()),
            ("built as drawn and said to deviate".into(), Share::of(as_drawn, is_off).text()),
            ("open doors said to be absent".into(), Share::of(open, |c| c.said == Verdict::Absent).text()),
            ("unobserved, though an ideal observer could decide".into(), count(&Case::is_declined)),
            ("reason of unobserved objects right".into(), {
                Share::of(all().filter_map(|c| c.reason), |r| r.is_right()).text()
            }),
            ("object that hides them right".into(), {
                Share::of(all().filter_map(|c| c.reason?.hider_is_right), |is| *is).text()
            }),
            ("unobserved without a reason".into(), {
                let unobserved = all().filter(|c| c.said == Verdict::Unobserved);
                Share::of(unobserved, |c| c.reason.is_none()).text()
            }),
            ("expected calibration error".into(), format!("{:.4}", self.calibration(delivery))),
            ("largest error of the ten bins below".into(), format!("{:.3}", self.worst_bin(delivery))),
            ("95 % interval of the object's deviation holds".into(), self.intervals(delivery).text()),
        ]);
        out
    }

    /// Mean difference of belief and frequency.
    pub fn calibration(&self, delivery: Delivery) -> f64 {
        calibration_error(&reliability(self.of_delivery(delivery).flat_map(|c| &c.stated)))
    }

    /// Bins of belief.
    pub fn bins(&self, delivery: Delivery) -> Vec<Bin> {
        equal_count(self.of_delivery(delivery).flat_map(|c| &c.stated))
    }

    fn worst_bin(&self, delivery: Delivery) -> f64 {
        self.bins(delivery).iter().map(|b| (b.stated - b.kept).abs()).fold(0.0, f64::max)
    }

    fn intervals(&self, delivery: Delivery) -> Intervals {
        Intervals::of(self.of_delivery(delivery).filter_map(|c| c.true_deviation))
    }

    /// How often each verdict was said where these were right: a row each, in the order of [`Self::VERDICTS`].
    pub fn confusion(&self, delivery: Delivery) -> Vec<(String, [usize; 5])> {
        let mut rows = std::collections::BTreeMap::new();
        for case in self.of_delivery(delivery) {
            let mut names: Vec<&str> = case.right.verdicts.iter().map(|v| v.name()).collect();
            names.sort_unstable();
            let row = rows.entry(names.join(" or ")).or_insert([0; 5]);
            row[Self::VERDICTS.iter().position(|v| *v == case.said).unwrap_or(4)] += 1;
        }
        rows.into_iter().collect()
    }

    /// The order of columns of [`Self::confusion`].
    pub const VERDICTS: [Verdict; 5] =
        [Verdict::Confirmed, Verdict::Deviating, Verdict::Absent, Verdict::Unobserved, Verdict::Conflicting];

    /// The short set's bounds: what the verifier of the day keeps, with room for the few cases.
    pub fn check_short(&self) -> Result<()> {
        let all = || self.of_delivery(Delivery::Stations);
        let right = Share::of(all(), |c| c.is_right());
        let confirmed = Share::of(all().filter(|c| c.deed == Deed::Missing), |c| c.is_missing_confirmed());
        let absent = Share::of(all(), |c| c.is_false_absent());
        let failed: Vec<&str> = [
            ("verdicts", right.value() < 0.85 || right.all < 60),
            ("missing objects confirmed", confirmed.value() > 0.2),
            ("false absent", absent.value() > 0.06),
        ]
        .into_iter()
        .filter_map(|(what, failed)| failed.then_some(what))
        .collect();
        if failed.is_empty() { Ok(()) } else { bail!("short of what it must show: {}", failed.join(", ")) }
    }
}
