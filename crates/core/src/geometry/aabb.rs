//! Axis-aligned boxes.

use super::Vec3;
use crate::error::{Error, Result};
use crate::num::text::{number, numbers};

/// An axis-aligned box, `min ≤ max` on every axis, metres. May be flat.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Aabb {
    /// Lower corner.
    pub min: [f64; 3],
    /// Upper corner.
    pub max: [f64; 3],
}

impl Aabb {
    /// A box that holds nothing; the neutral element of [`Aabb::grow`].
    pub const EMPTY: Self = Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// The box between two corners given in any order; both finite. World metres.
    pub fn new(a: [f64; 3], b: [f64; 3]) -> Result<Self> {
        if let Some(v) = a.iter().chain(&b).find(|v| !v.is_finite()) {
            return Err(Error::argument("a box coordinate", "finite", v));
        }
        Ok(Self { min: [0, 1, 2].map(|i| a[i].min(b[i])), max: [0, 1, 2].map(|i| a[i].max(b[i])) })
    }

    /// The smallest box around `points`; [`Aabb::EMPTY`] for none. Metres, in the frame of the points.
    pub fn around<'a>(points: impl IntoIterator<Item = &'a Vec3>) -> Self {
        let mut b = Self::EMPTY;
        points.into_iter().for_each(|p| b.grow(p));
        b
    }

    /// Grows to include a point. Metres, in the frame of the box.
    pub fn grow(&mut self, p: &Vec3) {
        for i in 0..3 {
            self.min[i] = self.min[i].min(p[i]);
            self.max[i] = self.max[i].max(p[i]);
        }
    }

    /// Its corners; bit k of a corner's number tells whether it is the upper one along axis k.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| Vec3::from_fn(|k, _| if i >> k & 1 == 1 { self.max[k] } else { self.min[k] }))
    }

    /// The box grown by `margin` on every side. Metres.
    pub fn expanded(&self, margin: f64) -> Self {
        Self { min: self.min.map(|v| v - margin), max: self.max.map(|v| v + margin) }
    }

    /// The smallest box that holds both.
    pub fn union(&self, o: &Self) -> Self {
        Self { min: [0, 1, 2].map(|i| self.min[i].min(o.min[i])), max: [0, 1, 2].map(|i| self.max[i].max(o.max[i])) }
    }

    /// Whether the boxes share a point (touching counts).
    pub fn overlaps(&self, o: &Self) -> bool {
        (0..3).all(|i| self.min[i] <= o.max[i] && o.min[i] <= self.max[i])
    }

    /// Whether a point lies inside (the border counts). Metres, in the frame of the box.
    pub fn holds(&self, p: &Vec3) -> bool {
        (0..3).all(|i| (self.min[i]..=self.max[i]).contains(&p[i]))
    }

    /// Whether `o` lies within this box (touching counts).
    pub fn contains(&self, o: &Self) -> bool {
        (0..3).all(|i| self.min[i] <= o.min[i] && o.max[i] <= self.max[i])
    }

    /// Volume, m³; 0 for a flat box.
    pub fn volume(&self) -> f64 {
        (0..3).map(|i| self.max[i] - self.min[i]).product()
    }

    /// Sum of the three edge lengths, the R*-tree's margin. Metres.
    pub fn margin(&self) -> f64 {
        (0..3).map(|i| self.max[i] - self.min[i]).sum()
    }

    /// Distance between the nearest points of both boxes; 0 when they overlap. Metres.
    pub fn distance(&self, o: &Self) -> f64 {
        let gap = |i: usize| (self.min[i] - o.max[i]).max(o.min[i] - self.max[i]).max(0.0);
        (gap(0).powi(2) + gap(1).powi(2) + gap(2).powi(2)).sqrt()
    }

    /// Midpoint. Metres, in the frame of the box.
    pub fn centre(&self) -> Vec3 {
        Vec3::from_fn(|i, _| 0.5 * (self.min[i] + self.max[i]))
    }

    /// Length of the diagonal. Metres.
    pub fn diagonal(&self) -> f64 {
        Vec3::from_fn(|i, _| self.max[i] - self.min[i]).norm()
    }

    /// Text form, as PostGIS prints a box3d: `BOX3D(x y z,x y z)`.
    pub fn to_text(&self) -> String {
        let corner = |c: [f64; 3]| c.map(number).join(" ");
        format!("BOX3D({},{})", corner(self.min), corner(self.max))
    }

    /// Reads [`Aabb::to_text`]'s form, case-insensitively, corners in any order.
    pub fn from_text(text: &str) -> Result<Self> {
        let bad = || Error::syntax("ab_box", text);
        let t = text.trim();
        let body = t
            .get(..5)
            .filter(|p| p.eq_ignore_ascii_case("BOX3D"))
            .and_then(|_| t[5..].trim().strip_prefix('('))
            .and_then(|b| b.strip_suffix(')'))
            .ok_or_else(bad)?;
        let (a, b) = body.split_once(',').ok_or_else(bad)?;
        let corner = |c: &str| numbers::<3>(c).ok_or_else(bad);
        Self::new(corner(a)?, corner(b)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_box() -> impl Strategy<Value = Aabb> {
        let c = || prop::array::uniform3(-1e7..1e7f64);
        (c(), c()).prop_map(|(a, b)| Aabb::new(a, b).unwrap())
    }

    proptest! {
        #[test]
        fn text_round_trips(b in any_box()) {
            prop_assert_eq!(Aabb::from_text(&b.to_text()).unwrap(), b);
        }

        #[test]
        fn union_contains_both_and_distance_agrees_with_overlap(a in any_box(), b in any_box()) {
            let u = a.union(&b);
            prop_assert!(u.contains(&a) && u.contains(&b));
            prop_assert_eq!(a.overlaps(&b), a.distance(&b) == 0.0);
        }

        #[test]
        fn any_text_is_read_or_refused(t in "\\PC*") {
            let _ = Aabb::from_text(&t);
        }
    }

    #[test]
    fn refuses_what_is_no_box() {
        for bad in ["", "BOX3D", "BOX3D(1 2 3)", "BOX3D(1 2 3,4 5 nan)", "BOX3D(1 2 3,4 5 6", "box2d(1 2,3 4)"] {
            assert!(Aabb::from_text(bad).is_err(), "{bad}");
        }
        assert!(Aabb::new([0.0; 3], [f64::INFINITY; 3]).is_err());
        assert_eq!(Aabb::from_text("box3d( 4 5 6 , 1 2 3 )").unwrap().to_text(), "BOX3D(1 2 3,4 5 6)");
    }
}
