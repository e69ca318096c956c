//! Where the boxes of a table lie and how large they are, so that a planner can tell how many overlap.
//!
//! A k-d partition of a sample: cells of about equal counts over centre and size. Within a cell centres are taken as
//! uniform and sizes as their mean, for which the share of pairs that overlap has a closed form. Unlike a grid of cells
//! (as in PostGIS) it spends nothing on empty space, and unlike counting the pairs of two samples it works where one
//! pair in a million overlaps.

use super::Aabb;

/// Most cells: `CELLS`² pairs are examined to plan a join.
const CELLS: usize = 128;
/// Fewest boxes worth a cell of their own.
const MIN_IN_CELL: usize = 4;
/// Numbers of a cell.
const NUMBERS: usize = 10;

/// How one box lies relative to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoxRelation {
    /// They have a point in common.
    Overlaps,
    /// It holds the other.
    Contains,
    /// It lies in the other.
    Contained,
}

/// Boxes of one cell.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BoxCluster {
    /// Share of all boxes.
    share: f64,
    /// Box of the centres, metres.
    centres: Aabb,
    /// Mean side lengths, metres.
    sides: [f64; 3],
}

/// Statistics of a column of boxes.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxStatistics {
    cells: Vec<BoxCluster>,
}

impl BoxStatistics {
    /// The statistics of a sample; `None` without boxes.
    pub fn of(boxes: &[Aabb]) -> Option<Self> {
        let mut features: Vec<[f64; 6]> =
            boxes.iter().map(features).filter(|f| f.iter().all(|x| x.is_finite())).collect();
        let total = features.len() as f64;
        let mut cells = Vec::new();
        partition(&mut features, CELLS, &mut |own| cells.push(BoxCluster::of(own, own.len() as f64 / total)));
        (!cells.is_empty()).then_some(Self { cells })
    }

    /// Share of the boxes that lie in this relation to `query`.
    pub fn selectivity(&self, query: &Aabb, relation: BoxRelation) -> f64 {
        let Some(query) = Self::of(&[*query]) else { return 0.0 };
        self.join_selectivity(&query, relation, 0.0)
    }

    /// Share of the pairs that lie in this relation to each other; boxes no farther apart than `margin` metres overlap.
    pub fn join_selectivity(&self, others: &Self, relation: BoxRelation, margin: f64) -> f64 {
        let of = |a: &BoxCluster| {
            others.cells.iter().map(|b| a.share * b.share * a.chance(b, relation, margin)).sum::<f64>()
        };
        self.cells.iter().map(of).sum::<f64>().clamp(0.0, 1.0)
    }

    /// As plain numbers, to be stored. Metres and shares.
    pub fn to_numbers(&self) -> Vec<f64> {
        let numbers = |c: &BoxCluster| [&[c.share][..], &c.centres.min, &c.centres.max, &c.sides].concat();
        self.cells.iter().flat_map(numbers).collect()
    }

    /// The mirror of [`BoxStatistics::to_numbers`]; `None` for numbers that are no statistics. Metres and shares.
    pub fn from_numbers(numbers: &[f64]) -> Option<Self> {
        let (cells, rest) = numbers.as_chunks::<NUMBERS>();
        let cell = |&[share, x, y, z, u, v, w, a, b, c]: &[f64; NUMBERS]| BoxCluster {
            share,
            centres: Aabb { min: [x, y, z], max: [u, v, w] },
            sides: [a, b, c],
        };
        let sound = rest.is_empty() && !cells.is_empty() && numbers.iter().all(|n| n.is_finite());
        sound.then(|| Self { cells: cells.iter().map(cell).collect() })
    }
}

/// Centre and sides.
fn features(b: &Aabb) -> [f64; 6] {
    std::array::from_fn(|i| if i < 3 { 0.5 * (b.min[i] + b.max[i]) } else { b.max[i - 3] - b.min[i - 3] })
}

/// Halves the sample at the median of its widest feature until there are `cells` parts or the parts are small.
fn partition(own: &mut [[f64; 6]], cells: usize, emit: &mut impl FnMut(&[[f64; 6]])) {
    let spread = |k: usize| {
        let (lo, hi) = own.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f[k]), h.max(f[k])));
        hi - lo
    };
    let widest = (0..6).map(|k| (k, spread(k))).max_by(|a, b| a.1.total_cmp(&b.1));
    match widest {
        Some((k, wide)) if cells > 1 && own.len() >= 2 * MIN_IN_CELL && wide > 0.0 => {
            let middle = own.len() / 2;
            own.select_nth_unstable_by(middle, |a, b| a[k].total_cmp(&b[k]));
            let (low, high) = own.split_at_mut(middle);
            partition(low, cells / 2, emit);
            partition(high, cells / 2, emit);
        }
        _ if own.is_empty() => {}
        _ => emit(own),
    }
}

impl BoxCluster {
    fn of(own: &[[f64; 6]], share: f64) -> Self {
        let mut centres = Aabb::EMPTY;
        own.iter().for_each(|f| centres.grow(&[f[0], f[1], f[2]].into()));
        let mean = |k: usize| own.iter().map(|f| f[k]).sum::<f64>() / own.len() as f64;
        Self { share, centres, sides: [mean(3), mean(4), mean(5)] }
    }

    /// Probability that a box of this cell lies in this relation to one of the other.
    fn chance(&self, o: &Self, relation: BoxRelation, margin: f64) -> f64 {
        (0..3)
            .map(|i| {
                let (mine, theirs) = (self.sides[i], o.sides[i]);
                let reach = match relation {
                    BoxRelation::Overlaps => 0.5 * (mine + theirs) + margin,
                    BoxRelation::Contains => 0.5 * (mine - theirs),
                    BoxRelation::Contained => 0.5 * (theirs - mine),
                };
                let interval = |c: &Self| [c.centres.min[i], c.centres.max[i]];
                near(interval(self), interval(o), reach)
            })
            .try_fold(1.0, |all, chance| (chance > 0.0).then_some(all * chance))
            .unwrap_or(0.0)
    }
}

/// Probability that two numbers, uniform in the intervals `a` and `b`, differ by at most `reach`.
fn near(a: [f64; 2], b: [f64; 2], reach: f64) -> f64 {
    if reach < 0.0 {
        return 0.0;
    }
    // Their difference is below t with the chance F(t) = (r(t-a0+b1) - r(t-a1+b1) - r(t-a0+b0) + r(t-a1+b0)) / (la lb),
    // r(x) = max(x, 0)²/2, a trapezium's. An interval is at least this wide, so that a point is one.
    let least_width = a.iter().chain(&b).fold(1e-4, |w: f64, c| w.max(1e-12 * c.abs()));
    let widen = |[lo, hi]: [f64; 2]| {
        let more = (0.5 * (least_width - (hi - lo))).max(0.0);
        [lo - more, hi + more]
    };
    let ([a0, a1], [b0, b1]) = (widen(a), widen(b));
    let below = |t: f64| {
        if t >= a1 - b0 {
            return 1.0;
        }
        if t <= a0 - b1 {
            return 0.0;
        }
        let r = |x: f64| x.max(0.0).powi(2) / 2.0;
        (r(t - a0 + b1) - r(t - a1 + b1) - r(t - a0 + b0) + r(t - a1 + b0)) / ((a1 - a0) * (b1 - b0))
    };
    // Beyond what single coordinates can tell apart, nothing overlaps.
    let chance = below(reach) - below(-reach);
    if chance.is_nan() { 0.0 } else { chance.clamp(0.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn chance_of_uniform_numbers() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..40 {
            let interval = |rng: &mut ChaCha8Rng| {
                let low = rng.random_range(-3.0..3.0);
                [low, low + rng.random_range(0.0..4.0)]
            };
            let (a, b, reach) = (interval(&mut rng), interval(&mut rng), rng.random_range(0.0..3.0));
            let hits = (0..20_000)
                .filter(|_| f64::abs(rng.random_range(a[0]..=a[1]) - rng.random_range(b[0]..=b[1])) <= reach)
                .count();
            let counted = hits as f64 / 20_000.0;
            assert!((near(a, b, reach) - counted).abs() < 0.015, "{a:?} {b:?} {reach}: {counted}");
        }
        assert_eq!(near([5.0; 2], [5.1; 2], 0.2), 1.0);
        assert_eq!(near([5.0; 2], [5.1; 2], 0.05), 0.0);
        assert_eq!(near([6e6; 2], [6e6 - 1.0, 6e6 + 1.0], -0.1), 0.0);
    }

    /// Scan patches as a project has them: long boxes that fan out of stations; and small boxes, some clustered.
    fn tables(n: usize) -> [Vec<Aabb>; 2] {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let around = |c: [f64; 3], s: [f64; 3]| Aabb {
            min: std::array::from_fn(|i| c[i] - 0.5 * s[i]),
            max: std::array::from_fn(|i| c[i] + 0.5 * s[i]),
        };
        let fan = |rng: &mut ChaCha8Rng| {
            let station = [6e5 + 10.0 * f64::from(rng.random_range(0..5u8)), 5.3e6, 500.0];
            let end: [f64; 3] =
                std::array::from_fn(|i| station[i] + rng.random_range(-8.0..8.0) * if i == 2 { 0.2 } else { 1.0 });
            let mut b = Aabb::EMPTY;
            b.grow(&station.into());
            b.grow(&end.into());
            b.expanded(0.25)
        };
        let small = |rng: &mut ChaCha8Rng| {
            let spread = if rng.random_bool(0.3) { 0.5 } else { 25.0 };
            let c = [6e5 + 20.0 + rng.random_range(-spread..spread), 5.3e6 + rng.random_range(-8.0..8.0), 500.0];
            around(c, [rng.random_range(0.05..3.0), rng.random_range(0.05..3.0), 0.2])
        };
        [(0..n).map(|_| fan(&mut rng)).collect(), (0..n).map(|_| small(&mut rng)).collect()]
    }

    fn counted(a: &[Aabb], b: &[Aabb], lies: impl Fn(&Aabb, &Aabb) -> bool) -> f64 {
        let hits = a.iter().map(|x| b.iter().filter(|y| lies(x, y)).count()).sum::<usize>();
        hits as f64 / (a.len() * b.len()) as f64
    }

    #[test]
    fn joins_are_estimated() {
        let [patches, objects] = tables(3000);
        let [p, o] = [&patches, &objects].map(|t| BoxStatistics::of(t).unwrap());
        assert_eq!(BoxStatistics::from_numbers(&p.to_numbers()).unwrap(), p);
        // Containment follows the spread of sizes, of which a cell knows only the mean.
        for (relation, truth, within) in [
            (BoxRelation::Overlaps, counted(&patches, &objects, Aabb::overlaps), 0.3),
            (BoxRelation::Contains, counted(&patches, &objects, Aabb::contains), 0.5),
        ] {
            let estimate = p.join_selectivity(&o, relation, 0.0);
            assert!(truth > 0.0 && (estimate / truth).ln().abs() < within, "{relation:?}: {estimate} for {truth}");
        }
        let mirrored = o.join_selectivity(&p, BoxRelation::Contained, 0.0);
        assert!((mirrored - p.join_selectivity(&o, BoxRelation::Contains, 0.0)).abs() < 1e-12);
    }

    #[test]
    fn one_box_is_estimated_and_rare_overlaps_too() {
        let [patches, objects] = tables(20_000);
        let p = BoxStatistics::of(&patches[..2000]).unwrap();
        let (mut sum, mut truth) = (0.0, 0.0);
        for query in &objects[..200] {
            sum += p.selectivity(query, BoxRelation::Overlaps);
            truth += counted(&patches, &[*query], Aabb::overlaps);
        }
        assert!((sum / truth).ln().abs() < 0.3, "{sum} for {truth}");
        // Boxes of a millimetre in a hall: one pair in ten thousand million.
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let tiny: Vec<Aabb> = (0..3000)
            .map(|_| {
                let c: [f64; 3] = std::array::from_fn(|_| rng.random_range(0.0..10.0));
                Aabb { min: c, max: c.map(|x| x + 0.0025) }
            })
            .collect();
        let t = BoxStatistics::of(&tiny).unwrap();
        let expected = (0.005f64 / 10.0).powi(3);
        let got = t.join_selectivity(&t, BoxRelation::Overlaps, 0.0);
        assert!((got / expected).ln().abs() < 0.3, "{got} for {expected}");
    }

    #[test]
    fn degenerate_tables() {
        let b = Aabb { min: [1.0; 3], max: [2.0; 3] };
        let all = BoxStatistics::of(&[b; 1000]).unwrap();
        assert_eq!(all.selectivity(&b, BoxRelation::Overlaps), 1.0);
        assert_eq!(all.selectivity(&b.expanded(1.0), BoxRelation::Contained), 1.0);
        assert_eq!(all.selectivity(&b.expanded(1.0), BoxRelation::Contains), 0.0);
        assert_eq!(all.selectivity(&Aabb { min: [3.0; 3], max: [4.0; 3] }, BoxRelation::Overlaps), 0.0);
        let far = Aabb { min: [1e300; 3], max: [1.1e300; 3] };
        let mixed = BoxStatistics::of(&[b, far, far, b, b, far, b, far, b]).unwrap();
        for other in [&all, &mixed] {
            assert!((0.0..=1.0).contains(&mixed.join_selectivity(other, BoxRelation::Overlaps, 0.0)));
        }
        assert!(BoxStatistics::of(&[]).is_none() && BoxStatistics::of(&[Aabb::EMPTY]).is_none());
        assert!(
            BoxStatistics::from_numbers(&[1.0; 11]).is_none() && BoxStatistics::from_numbers(&[f64::NAN; 10]).is_none()
        );
    }
}
