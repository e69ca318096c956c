//! Sums over outcomes.

use asbuilt_core::evidence::Loa;
use asbuilt_core::verify::Verdict;

use crate::case::{Estimate, Outcome, Stated};

/// Bins of the reliability diagram.
pub const BINS: usize = 10;
/// Half-width of a 95 % interval in σ.
const Z95: f64 = 1.959_964;

/// A count out of a total.
#[derive(Debug, Clone, Copy, Default)]
pub struct Share {
    pub hits: usize,
    pub all: usize,
}

impl Share {
    pub fn of<T>(items: impl IntoIterator<Item = T>, hit: impl Fn(&T) -> bool) -> Self {
        let mut out = Self::default();
        for item in items {
            out.all += 1;
            out.hits += usize::from(hit(&item));
        }
        out
    }

    pub fn value(self) -> f64 {
        self.hits as f64 / self.all.max(1) as f64
    }

    /// `98.8 % (585 of 592)`.
    pub fn text(self) -> String {
        if self.all == 0 {
            return "-".into();
        }
        format!("{:.1} % ({} of {})", 100.0 * self.value(), self.hits, self.all)
    }
}

/// Stated belief and observed frequency, by tenths of belief.
#[derive(Debug, Clone, Copy, Default)]
pub struct Bin {
    pub count: f64,
    pub stated: f64,
    pub kept: f64,
}

/// The reliability diagram of the belief "built within ±T here" over the seen samples.
pub fn reliability<'a>(stated: impl Iterator<Item = &'a Stated>) -> [Bin; BINS] {
    let mut bins = [Bin::default(); BINS];
    for s in stated {
        let bin = &mut bins[((s.occupied * BINS as f64) as usize).min(BINS - 1)];
        bin.count += 1.0;
        bin.stated += s.occupied;
        bin.kept += f64::from(u8::from(s.within));
    }
    bins
}

/// Expected calibration error: the mean difference of belief and frequency (Naeini et al. 2015).
pub fn calibration_error(bins: &[Bin; BINS]) -> f64 {
    let all: f64 = bins.iter().map(|b| b.count).sum();
    bins.iter().map(|b| (b.stated - b.kept).abs()).sum::<f64>() / all.max(1.0)
}

/// Intervals of ±1.96 σ compared with the truth.
#[derive(Debug)]
pub struct Intervals {
    pub holds: Share,
    pub bias_mm: f64,
    /// Errors in σ, sorted by size.
    pub z: Vec<f64>,
}

impl Intervals {
    pub fn of(estimates: impl Iterator<Item = Estimate>) -> Self {
        let all: Vec<Estimate> = estimates.collect();
        let mut z: Vec<f64> = all.iter().map(|e| (e.value - e.truth) / e.sd).collect();
        z.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let bias_mm = 1e3 * all.iter().map(|e| e.value - e.truth).sum::<f64>() / all.len().max(1) as f64;
        Self { holds: Share::of(&z, |z| z.abs() <= Z95), bias_mm, z }
    }

    pub fn text(&self) -> String {
        let median = self.z.get(self.z.len() / 2).map_or(0.0, |z| z.abs());
        format!("{}; bias {:+.2} mm; median error {median:.2} σ (0.67 if exact)", self.holds.text(), self.bias_mm)
    }
}

/// Whether the verdict is right.
pub fn right(o: &Outcome) -> bool {
    o.expected.verdicts.contains(&o.verdict)
}

/// Whether it is said to be absent, and is not.
pub fn false_absent(o: &Outcome) -> bool {
    o.verdict == Verdict::Absent && !right(o)
}

/// Whether best LOA is evaluated for this case at all: the object exists and something was seen of it.
pub fn has_loa(o: &Outcome) -> bool {
    o.expected.verdicts.iter().all(|v| *v != Verdict::Unobserved) && o.verdict != Verdict::Unobserved
}

/// Whether the best class is right or one more cautious; `capped`: no finer than this registration can prove.
pub fn loa_right(o: &Outcome, capped: bool) -> bool {
    let rank = |l: Option<Loa>| l.map_or(-1, |l| l as i32);
    let truth = if capped { rank(o.expected.loa).min(o.provable as i32) } else { rank(o.expected.loa) };
    (truth - 1..=truth).contains(&rank(o.best_loa))
}
