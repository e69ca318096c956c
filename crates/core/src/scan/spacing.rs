//! How far neighbouring beams of a patch are apart.

use super::origins::Origins;

/// How far neighbouring beams are apart: an angle where they start at known places, else a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spacing {
    /// Angle between neighbouring beams, radians.
    Angle(f64),
    /// Distance between neighbouring points whose origin is unknown, metres.
    Distance(f64),
}

impl Spacing {
    /// By the number that is stored or given for beams of these origins: radians, metres for points without origin.
    pub fn of(origins: Origins, number: f64) -> Self {
        match origins {
            Origins::One | Origins::Each => Self::Angle(number),
            Origins::Unknown => Self::Distance(number),
        }
    }

    /// The number that is stored: radians, metres for points without origin.
    pub fn number(self) -> f64 {
        match self {
            Self::Angle(number) | Self::Distance(number) => number,
        }
    }

    /// Angle between neighbouring beams, radians; 0 for points without origin, which are seen at no angle.
    pub fn angle(self) -> f64 {
        match self {
            Self::Angle(angle) => angle,
            Self::Distance(_) => 0.0,
        }
    }

    /// Distance between points without origin, metres; 0 for beams, which spread with their range.
    pub fn distance(self) -> f64 {
        match self {
            Self::Angle(_) => 0.0,
            Self::Distance(distance) => distance,
        }
    }

    /// After a similarity of this scale (without unit): metres grow by it, radians stay.
    pub fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Angle(_) => self,
            Self::Distance(distance) => Self::Distance(distance * scale),
        }
    }

    /// As a patch keeps it, in single precision.
    pub(super) fn stored(self) -> Self {
        match self {
            Self::Angle(number) => Self::Angle(f64::from(number as f32)),
            Self::Distance(number) => Self::Distance(f64::from(number as f32)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_is_no_distance() {
        for origins in [Origins::One, Origins::Each] {
            let s = Spacing::of(origins, 2e-3);
            assert_eq!((s.angle(), s.distance(), s.number(), s.scaled(3.0)), (2e-3, 0.0, 2e-3, s));
        }
        let s = Spacing::of(Origins::Unknown, 0.5);
        assert_eq!((s.angle(), s.distance(), s.number(), s.scaled(3.0)), (0.0, 0.5, 0.5, Spacing::Distance(1.5)));
        assert_eq!(Spacing::Angle(1e-3).stored(), Spacing::Angle(f64::from(1e-3f32)));
    }
}
