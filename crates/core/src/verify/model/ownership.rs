//! Whose surface a beam met: the object's that it was aimed at, or another one's that is drawn nearer to it.

use super::parameters::EvidenceModel;

/// A beam met an object where it is drawn within this, or within 3 σ, metres: what two trades build, and what a survey
/// can tell apart.
const AS_DESIGNED_M: f64 = 0.01;
/// What stands farther in front of a face than this, or than 3 σ, and is rather another object's hides it, metres.
pub const HIDDEN_M: f64 = 0.005;
/// It is another object's where it lies so many times nearer to that one's drawn surface.
pub const RATHER: f64 = 2.0;

/// What another object makes of a surface that was met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ownership {
    /// Nothing: it may be the object's own.
    MayBeOwn,
    /// One of both is there, and nobody can tell which: it says nothing of either alone.
    Shared,
    /// It is the other's, and hides the face.
    Hides,
    /// It is the other's, and the beam passed the face on its way to it.
    SeenThrough,
}

/// The three sigmas of a beam's range and registration, metres.
pub fn three_sigma(model: &EvidenceModel) -> f64 {
    3.0 * model.sigma_range.hypot(model.sigma_station)
}

/// An object stands as designed within this, metres.
pub fn as_designed(model: &EvidenceModel) -> f64 {
    three_sigma(model).max(AS_DESIGNED_M)
}

/// Whose a surface is that was met `deviation` metres in front of the face, and `other` metres in front of another
/// object's; `noise` is [`three_sigma`].
pub fn ownership(deviation: f64, other: f64, noise: f64) -> Ownership {
    let as_designed = noise.max(AS_DESIGNED_M);
    if (deviation - other).abs() <= as_designed {
        return Ownership::Shared;
    }
    // Rather the other's; or at its surface or farther out, where that is drawn before the face: it would have to be gone.
    if -deviation < RATHER * other && other < deviation && deviation > noise.max(HIDDEN_M) {
        return Ownership::Hides;
    }
    let is_at_other = other.abs() <= as_designed;
    if is_at_other && RATHER * other.abs() < -deviation && -deviation > as_designed {
        return Ownership::SeenThrough;
    }
    // Between two layers, hardly nearer to either: the one displaced as well as the other.
    let is_between = is_at_other && other.abs() < RATHER * deviation.abs();
    if is_between { Ownership::Shared } else { Ownership::MayBeOwn }
}

/// Whether a return that no beam was aimed with, `own` metres from where an object is drawn and `other` from where
/// another one is, may be the other's: it lies hardly farther from that one than from this.
pub fn may_be_anothers(own: f64, other: f64, model: &EvidenceModel) -> bool {
    other.abs() < (RATHER * own.abs()).max(own.abs() + as_designed(model))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_nearer_to_another_object_is_that_ones() {
        let noise = 0.004;
        for (deviation, other, whose) in [
            (0.03, f64::INFINITY, Ownership::MayBeOwn),
            (0.03, 0.01, Ownership::Hides),
            (0.03, -0.01, Ownership::Hides),
            (0.0301, 0.02, Ownership::Hides),
            (0.03, -0.02, Ownership::MayBeOwn),
            (0.085, 0.07, Ownership::Hides),
            (0.03, 0.021, Ownership::Shared),
            (0.004, 0.001, Ownership::Shared),
            (-0.05, 0.005, Ownership::SeenThrough),
            (-0.05, 0.02, Ownership::MayBeOwn),
            (-0.05, -0.041, Ownership::Shared),
            (-0.015, 0.001, Ownership::SeenThrough),
            (-0.009, 0.002, Ownership::Shared),
            (0.0065, -0.006, Ownership::Shared),
            (0.003, -0.0095, Ownership::MayBeOwn),
            (-0.0075, 0.005, Ownership::Shared),
            (0.005, -0.02, Ownership::MayBeOwn),
        ] {
            assert_eq!(ownership(deviation, other, noise), whose, "{deviation} {other}");
        }
    }
}
