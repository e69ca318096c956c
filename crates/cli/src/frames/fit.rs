//! How well the boxes of patches and of objects lie on each other.

use asbuilt_core::geometry::Aabb;

use super::hypothesis::{AS_READ, Hypothesis};

/// A patch is near an object where their boxes are this near, metres.
const NEAR_M: f64 = 0.1;
/// A box of more than this part of the model's tells nothing: a terrain, a roof, a whole building in one.
const LARGE: f64 = 0.25;
/// What is left when this part of the patches is cut off at either end of each axis is where the scan is.
const TAIL: f64 = 0.05;
/// Of some thousand neighbouring beams, as far as half of the patches measure across, metres.
const PATCH_M: std::ops::RangeInclusive<f64> = 0.02..=20.0;

/// The boxes of a model and of scans.
pub struct Boxes {
    /// Of objects, without the large ones.
    objects: Vec<Aabb>,
    model: Aabb,
    /// Of the returns of patches.
    patches: Vec<Aabb>,
}

/// How well they lie on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Share of the patches that lie near an object.
    pub patches: f64,
    /// Share of the objects near which a patch lies.
    pub objects: f64,
}

impl Boxes {
    /// `None` where there is nothing to compare.
    pub fn new(objects: &[Aabb], patches: Vec<Aabb>) -> Option<Self> {
        let model = objects.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
        let footprint = |b: &Aabb| (b.max[0] - b.min[0]).max(NEAR_M) * (b.max[1] - b.min[1]).max(NEAR_M);
        let volume = |b: &Aabb| footprint(b) * (b.max[2] - b.min[2]).max(NEAR_M);
        let small = objects.iter().filter(|b| volume(b) <= LARGE * volume(&model)).copied().collect::<Vec<_>>();
        let objects = if small.is_empty() { objects.to_vec() } else { small };
        (!objects.is_empty() && !patches.is_empty()).then_some(Self { objects, model, patches })
    }

    /// How well they fit under a hypothesis about the scans.
    pub fn fit(&self, hypothesis: &Hypothesis) -> Fit {
        let patches: Vec<Aabb> = self.patches.iter().map(|p| hypothesis.of_box(p).expanded(NEAR_M)).collect();
        let mut hit = vec![false; self.objects.len()];
        let mut near = 0u32;
        for patch in &patches {
            let mut is_near = false;
            for (object, hit) in self.objects.iter().zip(&mut hit) {
                let meets = patch.overlaps(object);
                is_near |= meets;
                *hit |= meets;
            }
            near += u32::from(is_near);
        }
        let share = |n: usize, of: usize| n as f64 / of as f64;
        Fit {
            patches: share(near as usize, patches.len()),
            objects: share(hit.iter().filter(|h| **h).count(), hit.len()),
        }
    }

    /// The size of the scans beside the model's, under a hypothesis.
    pub fn relative_size(&self, hypothesis: &Hypothesis) -> f64 {
        self.scanned(hypothesis).diagonal() / self.model.diagonal().max(f64::MIN_POSITIVE)
    }

    /// Whether patches have a size that neighbouring beams of a scanner in or around a building have.
    pub fn are_patches_of_scanners(&self, hypothesis: &Hypothesis) -> bool {
        let mut sizes: Vec<f64> = self.patches.iter().map(|p| hypothesis.of_box(p).diagonal()).collect();
        sizes.sort_by(f64::total_cmp);
        PATCH_M.contains(&sizes[sizes.len() / 2])
    }

    /// From the middle of where the scans are, as they are read, to the model's, metres; and the model's size.
    pub fn apart(&self) -> ([f64; 3], f64) {
        let by = self.model.centre() - self.scanned(&AS_READ).centre();
        (by.into(), self.model.diagonal())
    }

    /// Where most of the patches are.
    fn scanned(&self, hypothesis: &Hypothesis) -> Aabb {
        let boxes: Vec<Aabb> = self.patches.iter().map(|p| hypothesis.of_box(p)).collect();
        let cut = (TAIL * boxes.len() as f64) as usize;
        let end = |k: usize, of: fn(&Aabb) -> [f64; 3], from_above: bool| {
            let mut all: Vec<f64> = boxes.iter().map(|b| of(b)[k]).collect();
            all.sort_by(f64::total_cmp);
            all[if from_above { all.len() - 1 - cut } else { cut }]
        };
        Aabb {
            min: std::array::from_fn(|k| end(k, |b| b.min, false)),
            max: std::array::from_fn(|k| end(k, |b| b.max, true)),
        }
    }
}
