//! Which objects a beam may have met: what stands near where another object is drawn is that object's.

use super::crossing::BeamCrossing;
use super::target::Target;
use crate::scan::RangeImage;

/// What is met within this of where an object is drawn may be it, metres.
const MAX_CLAIM_M: f32 = 0.1;

/// For each return of a patch how near to where objects are drawn it lies: the nearest object and the next one.
#[derive(Debug)]
pub struct Claims {
    nearest: Vec<Claim>,
    /// Of the next object, as in [`Claim`].
    next: Vec<f32>,
}

#[derive(Debug, Clone, Copy)]
struct Claim {
    object: u32,
    /// How far in front of the drawn face the return lies, metres along its normal on the side it was met from; infinite
    /// without a claim.
    deviation: f32,
}

impl Claims {
    /// Nobody claims any of so many returns.
    pub fn none(beams: usize) -> Self {
        let none = Claim { object: u32::MAX, deviation: f32::INFINITY };
        Self { nearest: vec![none; beams], next: vec![f32::INFINITY; beams] }
    }

    /// Claims for `object` the beams that met something near where it is drawn.
    pub fn stake_all(&mut self, view: &RangeImage, target: &Target, crossings: &[BeamCrossing], object: u32) {
        for crossing in crossings {
            let slot = crossing.slot as usize;
            let cos = -view.directions[slot].dot(&crossing.normal(target));
            self.stake(slot, object, ((crossing.distance - view.ranges[slot]) * cos) as f32);
        }
    }

    /// An object is drawn this far behind what the beam met, metres; farther than [`MAX_CLAIM_M`] is none of its business.
    pub fn stake(&mut self, slot: usize, object: u32, deviation: f32) {
        if deviation.abs() > MAX_CLAIM_M || deviation.is_nan() {
            return;
        }
        let nearest = &mut self.nearest[slot];
        if deviation.abs() < nearest.deviation.abs() {
            if nearest.object != object {
                self.next[slot] = nearest.deviation;
            }
            *nearest = Claim { object, deviation };
        } else if nearest.object == object {
            // One body drawn twice.
        } else if deviation.abs() < self.next[slot].abs() {
            self.next[slot] = deviation;
        }
    }

    /// The claims of all objects but one.
    pub fn of_others_than(&self, object: u32) -> OtherObjects<'_> {
        OtherObjects { claims: self, object }
    }

    fn of_others(&self, slot: usize, object: u32) -> f32 {
        let nearest = &self.nearest[slot];
        if nearest.object == object { self.next[slot] } else { nearest.deviation }
    }
}

/// What the other objects claim, as one object asks for it.
#[derive(Debug, Clone, Copy)]
pub struct OtherObjects<'a> {
    claims: &'a Claims,
    object: u32,
}

impl OtherObjects<'_> {
    /// How far in front of the nearest other object this return lies, metres; infinite where none is near.
    pub fn deviation(&self, slot: usize) -> f64 {
        f64::from(self.claims.of_others(slot, self.object))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_does_not_stand_in_its_own_way() {
        let mut claims = Claims::none(2);
        for (object, deviation) in [(7, 0.03), (8, -0.01), (9, 0.02), (10, -0.2), (11, f32::NAN)] {
            claims.stake(1, object, deviation);
        }
        assert_eq!([7, 8, 9, 1].map(|o| claims.of_others(1, o)), [-0.01, 0.02, -0.01, -0.01]);
        assert_eq!(claims.of_others(0, 7), f32::INFINITY);
    }
}
