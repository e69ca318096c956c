//! Dividing boxes over two index pages.

use super::Aabb;

/// How much `key` must grow to include `new`: by volume, or by edge lengths where the volume is zero.
///
/// The square root keeps differences visible in the single-precision penalty that GiST compares. Metres.
pub fn penalty(key: &Aabb, new: &Aabb) -> f32 {
    let union = key.union(new);
    let volume = (union.volume() - key.volume()).max(0.0);
    let margin = (union.margin() - key.margin()).max(0.0);
    (volume.sqrt() + 1e-3 * margin) as f32
}

/// Splits boxes into two groups after the R*-tree (Beckmann et al. 1990): along the axis with the least sum of
/// margins, at the place with the least overlap, ties by volume; each side gets at least 40 %.
pub fn split(boxes: &[Aabb]) -> (Vec<usize>, Vec<usize>) {
    let least = (boxes.len() * 2 / 5).max(1);
    let best_axis = (0..3).min_by(|&a, &b| {
        let cost = |axis| Sweep::along(boxes, axis).cuts(least).map(|c| c.margins).sum::<f64>();
        cost(a).total_cmp(&cost(b))
    });
    let sweep = Sweep::along(boxes, best_axis.unwrap_or(0));
    let cut = sweep
        .cuts(least)
        .min_by(|a, b| a.overlap.total_cmp(&b.overlap).then(a.volumes.total_cmp(&b.volumes)))
        .map_or(boxes.len() / 2, |c| c.at);
    let (left, right) = sweep.order.split_at(cut);
    (left.to_vec(), right.to_vec())
}

/// Boxes sorted along an axis, with the union of every head and every tail.
struct Sweep {
    order: Vec<usize>,
    heads: Vec<Aabb>,
    tails: Vec<Aabb>,
}

struct SplitCandidate {
    at: usize,
    margins: f64,
    overlap: f64,
    volumes: f64,
}

impl Sweep {
    fn along(boxes: &[Aabb], axis: usize) -> Self {
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        let centre = |i: usize| boxes[i].min[axis] + boxes[i].max[axis];
        order.sort_by(|&a, &b| centre(a).total_cmp(&centre(b)));
        let running = |it: &mut dyn Iterator<Item = &usize>| {
            it.scan(Aabb::EMPTY, |u, &i| {
                *u = u.union(&boxes[i]);
                Some(*u)
            })
            .collect::<Vec<_>>()
        };
        let heads = running(&mut order.iter());
        let mut tails = running(&mut order.iter().rev());
        tails.reverse();
        Self { order, heads, tails }
    }

    fn cuts(&self, least: usize) -> impl Iterator<Item = SplitCandidate> + '_ {
        let last = self.order.len().saturating_sub(least).max(least);
        (least..=last).filter(|&at| at < self.order.len()).map(|at| {
            let (l, r) = (&self.heads[at - 1], &self.tails[at]);
            let common = |i: usize| (l.max[i].min(r.max[i]) - l.min[i].max(r.min[i])).max(0.0);
            SplitCandidate {
                at,
                margins: l.margin() + r.margin(),
                overlap: common(0) * common(1) * common(2),
                volumes: l.volume() + r.volume(),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_clusters_are_parted_and_every_box_is_in_one_group() {
        let boxes: Vec<Aabb> = (0..50)
            .map(|i| {
                let x = f64::from(i % 2) * 100.0 + f64::from(i) * 0.1;
                Aabb::new([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]).unwrap()
            })
            .collect();
        let (l, r) = split(&boxes);
        let mut all: Vec<usize> = l.iter().chain(&r).copied().collect();
        all.sort_unstable();
        assert_eq!(all, (0..50).collect::<Vec<_>>());
        let side = |g: &[usize]| g.iter().map(|i| i % 2).collect::<std::collections::HashSet<_>>().len();
        assert_eq!((side(&l), side(&r)), (1, 1));
    }

    #[test]
    fn equal_and_few_boxes_are_split_too() {
        let same = vec![Aabb::new([0.0; 3], [1.0; 3]).unwrap(); 7];
        for n in 2..=7 {
            let (l, r) = split(&same[..n]);
            assert!(!l.is_empty() && !r.is_empty() && l.len() + r.len() == n);
        }
    }

    #[test]
    fn growing_costs_more_than_holding() {
        let b = Aabb::new([0.0; 3], [2.0; 3]).unwrap();
        let inside = Aabb::new([0.5; 3], [1.0; 3]).unwrap();
        let outside = Aabb::new([5.0; 3], [6.0; 3]).unwrap();
        assert_eq!(penalty(&b, &inside), 0.0);
        assert!(penalty(&b, &outside) > 0.0);
    }
}
