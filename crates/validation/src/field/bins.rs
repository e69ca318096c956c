//! Whether belief means what it says: bins of equal count.

use crate::case::Stated;

/// Beliefs outside of these say "surely" and are not binned.
const BETWEEN: std::ops::Range<f64> = 0.02..0.98;
const BINS: usize = 10;

/// One bin.
#[derive(Debug, Clone, Copy)]
pub struct Bin {
    /// Smallest and largest belief in it.
    pub from: f64,
    pub to: f64,
    pub count: usize,
    /// Mean belief, and share of what was so.
    pub stated: f64,
    pub kept: f64,
}

impl Bin {
    fn of(sorted: &[Stated]) -> Self {
        let n = sorted.len().max(1) as f64;
        let stated = sorted.iter().map(|s| s.occupied).sum::<f64>() / n;
        let kept = sorted.iter().filter(|s| s.within).count() as f64 / n;
        let (from, to) = (sorted.first().map_or(0.0, |s| s.occupied), sorted.last().map_or(0.0, |s| s.occupied));
        Self { from, to, count: sorted.len(), stated, kept }
    }
}

/// Ten bins of equal count of the beliefs between 0.02 and 0.98.
pub fn equal_count<'a>(stated: impl Iterator<Item = &'a Stated>) -> Vec<Bin> {
    let mut all: Vec<Stated> = stated.filter(|s| BETWEEN.contains(&s.occupied)).copied().collect();
    all.sort_by(|a, b| a.occupied.total_cmp(&b.occupied));
    if all.len() < BINS {
        return Vec::new();
    }
    (0..BINS).map(|k| Bin::of(&all[k * all.len() / BINS..(k + 1) * all.len() / BINS])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_equal_and_the_sure_ones_left_out() {
        let stated: Vec<Stated> =
            (0..1000).map(|i| Stated { occupied: f64::from(i) / 1000.0, within: i % 2 == 0 }).collect();
        let bins = equal_count(stated.iter());
        assert_eq!(bins.len(), BINS);
        assert!(bins.iter().all(|b| b.count == 96 && (b.kept - 0.5).abs() < 1e-9), "{bins:?}");
        assert!((bins[0].from - 0.02).abs() < 1e-9 && bins[9].to < 0.98);
    }
}
