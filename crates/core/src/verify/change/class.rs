//! What became of an object.

use super::displacement::Displacement;
use super::paired::PairedSamples;
use super::thresholds::{MIN_COMPARED, MIN_COMPARED_SHARE, MIN_DISPLACED, MIN_LEFT, MIN_PART, MIN_SHOWN, MIN_WHOLE};

/// What became of an object between two epochs: SQL's `ab_change_class`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ObjectChangeClass {
    /// It stands where it stood, or stood and stands nowhere near its place.
    Unchanged,
    /// Its place was empty.
    Appeared,
    /// Its place is empty now.
    Gone,
    /// It stands elsewhere than before, by more than chance and registration.
    Moved,
    /// Part of it appeared, or is gone.
    Partly,
    /// Too little of it was seen in both epochs.
    NotComparable,
}

impl ObjectChangeClass {
    /// All, in the order of the SQL type.
    pub const ALL: [Self; 6] =
        [Self::Unchanged, Self::Appeared, Self::Gone, Self::Moved, Self::Partly, Self::NotComparable];

    /// SQL text.
    pub fn name(self) -> &'static str {
        ["unchanged", "appeared", "gone", "moved", "partly", "not_comparable"][self as usize]
    }
}

/// The class that follows from the counts of the samples and from how far the object moved: the first that holds.
pub fn decide(samples: &PairedSamples, displacement: Option<&Displacement>) -> ObjectChangeClass {
    let (compared, shown) = (samples.compared(), samples.shown());
    let least = MIN_COMPARED.min(samples.samples);
    if compared < least.max(1) || (compared as f64) < MIN_COMPARED_SHARE * samples.samples as f64 {
        return ObjectChangeClass::NotComparable;
    }
    if (shown as f64) < MIN_SHOWN * compared as f64 {
        return ObjectChangeClass::Unchanged;
    }
    let [lost, won] = [samples.lost, samples.won].map(|n| n as f64 / shown as f64);
    if lost >= MIN_WHOLE {
        return ObjectChangeClass::Gone;
    }
    if won >= MIN_WHOLE {
        return ObjectChangeClass::Appeared;
    }
    // Tilted or bent it has no offset of its own, and its samples are displaced all the same.
    let has_bent = samples.displaced as f64 >= MIN_DISPLACED * shown as f64;
    let has_moved = has_bent || displacement.is_some_and(Displacement::is_certain);
    if has_moved || lost >= MIN_LEFT && won >= MIN_LEFT {
        return ObjectChangeClass::Moved;
    }
    if lost >= MIN_PART || won >= MIN_PART { ObjectChangeClass::Partly } else { ObjectChangeClass::Unchanged }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use super::*;
    use crate::geometry::Vec3;
    use crate::verify::surface::Shift;

    /// A thousand samples, half of them seen in both: kept, lost, won, in neither.
    fn counted([kept, lost, won, empty]: [u64; 4]) -> PairedSamples {
        PairedSamples { samples: 1000, seen_in_both: 500, kept, lost, won, empty, ..PairedSamples::default() }
    }

    fn displaced(metres: f64, chance: f64) -> Displacement {
        let shift = Shift { vector: Vec3::x() * metres, covariance: Matrix3::zeros(), undetermined: Vec::new() };
        Displacement { shift, chance, floor: 0.004 }
    }

    #[test]
    fn the_first_that_holds() {
        use ObjectChangeClass::*;
        let bent = |displaced| PairedSamples { displaced, ..counted([400, 0, 0, 0]) };
        let small = |kept| PairedSamples { samples: 6, seen_in_both: 6, kept, ..PairedSamples::default() };
        for (i, (samples, displacement, class)) in [
            (counted([9, 0, 0, 0]), None, NotComparable),
            (counted([10, 0, 0, 0]), None, Unchanged),
            (PairedSamples { samples: 2000, ..counted([19, 0, 0, 0]) }, None, NotComparable),
            (small(6), None, Unchanged),
            (small(5), None, NotComparable),
            (counted([0, 0, 0, 400]), None, Unchanged),
            (counted([0, 50, 9, 400]), None, Unchanged),
            (counted([0, 90, 0, 400]), None, Gone),
            (counted([100, 300, 0, 0]), Some(displaced(0.1, 0.0)), Gone),
            (counted([101, 299, 0, 0]), None, Partly),
            (counted([100, 0, 300, 0]), None, Appeared),
            (counted([400, 0, 0, 0]), Some(displaced(0.005, 9e-5)), Moved),
            (counted([400, 0, 0, 0]), Some(displaced(0.005, 2e-4)), Unchanged),
            (counted([400, 0, 0, 0]), Some(displaced(0.003, 0.0)), Unchanged),
            (bent(120), None, Moved),
            (bent(119), None, Unchanged),
            (counted([200, 100, 100, 0]), None, Moved),
            (counted([204, 98, 98, 0]), None, Partly),
            (counted([340, 60, 0, 0]), None, Partly),
            (counted([341, 59, 0, 0]), None, Unchanged),
        ]
        .into_iter()
        .enumerate()
        {
            assert_eq!(decide(&samples, displacement.as_ref()), class, "case {i}");
        }
    }
}
