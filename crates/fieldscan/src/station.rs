//! Where a scanner stands, and where registration believes it.

use asbuilt_core::geometry::Vec3;
use nalgebra::{Rotation3, Unit};
use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

/// How well stations are registered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Registration {
    /// Standard deviation of a station's place, metres per axis.
    pub sigma_place_m: f64,
    /// Standard deviation of its turn about each axis, radians: tilt, and error of the heading.
    pub sigma_turn: f64,
    /// What all stations of the epoch have wrong in common, metres.
    pub datum: Vec3,
}

/// A station with its error of registration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Where it stands, world metres.
    pub place: Vec3,
    /// The scanner's axes in the world.
    pub world_from_scanner: Rotation3<f64>,
    /// Where registration believes it to stand, world metres.
    pub registered_place: Vec3,
    /// The axes as registration believes them.
    pub registered_rotation: Rotation3<f64>,
}

impl Station {
    /// A station at a place, with a random heading and random errors.
    pub fn new(place: Vec3, registration: &Registration, rng: &mut impl Rng) -> Self {
        let heading = rng.random_range(0.0..std::f64::consts::TAU);
        let registered_rotation = Rotation3::from_axis_angle(&Vec3::z_axis(), heading);
        let mut normal = |sigma: f64| -> Vec3 {
            Vec3::from_fn(|_, _| sigma * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng))
        };
        let off = normal(registration.sigma_place_m) + registration.datum;
        let turn = normal(registration.sigma_turn);
        let tilt = Unit::try_new(turn, 1e-15)
            .map_or_else(Rotation3::identity, |axis| Rotation3::from_axis_angle(&axis, turn.norm()));
        let world_from_scanner = tilt * registered_rotation;
        Self { place, world_from_scanner, registered_place: place + off, registered_rotation }
    }
}
