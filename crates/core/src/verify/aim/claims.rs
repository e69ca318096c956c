//! Which objects a beam may have met: what stands near where another object is drawn is that object's.

use super::crossing::BeamCrossing;
use super::target::Target;
use crate::scan::RangeImage;

/// What is met within this of where an object is drawn may be it, metres.
const MAX_CLAIM_M: f32 = 0.1;

/// For each beam of a patch how near to where objects are drawn it met something: the nearest object and the next one.
#[derive(Debug)]
pub struct Claims {
    nearest: Vec<Claim>,
    next: Vec<f32>,
}

#[derive(Debug, Clone, Copy)]
struct Claim {
    object: u32,
    /// Metres along the drawn face's normal; infinite without a claim.
    distance: f32,
}

impl Claims {
    /// Nobody claims any of so many beams.
    pub fn none(beams: usize) -> Self {
        let none = Claim { object: u32::MAX, distance: f32::INFINITY };
        Self { nearest: vec![none; beams], next: vec![f32::INFINITY; beams] }
    }

    /// Claims for `object` the beams that met something near where it is drawn.
    pub fn stake_all(&mut self, view: &RangeImage, target: &Target, crossings: &[BeamCrossing], object: u32) {
        for crossing in crossings {
            let slot = crossing.slot as usize;
            let cos = -view.directions[slot].dot(&crossing.normal(target));
            let distance = ((crossing.distance - view.ranges[slot]) * cos).abs() as f32;
            if distance <= MAX_CLAIM_M {
                self.stake(slot, object, distance);
            }
        }
    }

    /// An object is drawn this far from what the beam met. Each object claims a beam once.
    fn stake(&mut self, slot: usize, object: u32, distance: f32) {
        let nearest = &mut self.nearest[slot];
        if distance < nearest.distance {
            self.next[slot] = nearest.distance;
            *nearest = Claim { object, distance };
        } else {
            self.next[slot] = self.next[slot].min(distance);
        }
    }

    /// The claims of all objects but one.
    pub fn of_others_than(&self, object: u32) -> OtherObjects<'_> {
        OtherObjects { claims: self, object }
    }

    /// The distance of the nearest of the other objects, metres; infinite where none is near.
    fn of_others(&self, slot: usize, object: u32) -> f32 {
        let nearest = &self.nearest[slot];
        if nearest.object == object { self.next[slot] } else { nearest.distance }
    }
}

/// What the other objects claim, as one object asks for it.
#[derive(Debug, Clone, Copy)]
pub struct OtherObjects<'a> {
    claims: &'a Claims,
    object: u32,
}

impl OtherObjects<'_> {
    /// How far from what this beam met the nearest other object is drawn, metres; infinite where none is near.
    pub fn distance(&self, slot: usize) -> f64 {
        f64::from(self.claims.of_others(slot, self.object))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_does_not_stand_in_its_own_way() {
        let mut claims = Claims::none(2);
        for (object, distance) in [(7, 0.03), (8, 0.01), (9, 0.02)] {
            claims.stake(1, object, distance);
        }
        assert_eq!([7, 8, 9, 1].map(|o| claims.of_others(1, o)), [0.01, 0.02, 0.01, 0.01]);
        assert_eq!(claims.of_others(0, 7), f32::INFINITY);
    }
}
