//! How samples divide at a tolerance.

use super::rule::VerdictRule;
use super::thresholds::{MIN_SEEN, WELL_SEEN_SAMPLES, WELL_SEEN_SHARE};

/// How samples divide, those of one face or of several.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Counts {
    /// All samples.
    pub samples: u64,
    /// Samples that enough beams told of; confirmed, refuted and open ones add up to these.
    pub seen: u64,
    /// Belief in occupied reaches the confidence.
    pub confirmed: u64,
    /// Belief in empty reaches the confidence, or the sample shares the face's displacement.
    pub refuted: u64,
    /// Of the refuted: nothing of the object there, the space was seen empty (seen through).
    pub pierced: u64,
    /// Samples at which the object's own surface was seen.
    pub on_surface: u64,
    /// Of these the ones beyond the tolerance.
    pub out_of_tolerance: u64,
    /// Samples at which any surface was seen within the search band.
    pub with_surface: u64,
    /// Sum over seen samples of the conflict between stations.
    pub conflict: f64,
}

impl Counts {
    /// Adds those of another face.
    pub(super) fn add(&mut self, other: &Self) {
        self.samples += other.samples;
        self.seen += other.seen;
        self.confirmed += other.confirmed;
        self.refuted += other.refuted;
        self.pierced += other.pierced;
        self.on_surface += other.on_surface;
        self.out_of_tolerance += other.out_of_tolerance;
        self.with_surface += other.with_surface;
        self.conflict += other.conflict;
    }

    /// Seen samples that are neither confirmed nor refuted.
    pub fn open(&self) -> u64 {
        self.seen - self.confirmed - self.refuted
    }

    /// Whether enough was seen to judge at all.
    pub(super) fn cover(&self, rule: &VerdictRule) -> bool {
        self.seen > 0
            && self.seen >= MIN_SEEN.min(self.samples)
            && self.seen as f64 >= rule.min_coverage * self.samples as f64
    }

    /// Samples that show the object where it was drawn; [`Counts::out_of_tolerance`] show it elsewhere,
    /// [`Counts::pierced`] that it is not there.
    pub(super) fn in_place(&self) -> u64 {
        (self.on_surface - self.out_of_tolerance).max(self.confirmed)
    }

    /// Samples that say one of the three.
    pub(super) fn decided(&self) -> u64 {
        self.in_place() + self.out_of_tolerance + self.pierced
    }
}

/// Whether a part of the object's samples is enough to count as well seen.
pub fn is_well_seen(part: u64, whole: u64) -> bool {
    part >= WELL_SEEN_SAMPLES.min(whole) && part as f64 >= WELL_SEEN_SHARE * whole as f64
}
