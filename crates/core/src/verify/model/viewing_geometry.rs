//! How a station looks at a sample.

/// From where, and with which beams, a station sees one sample.
#[derive(Debug, Clone, Copy)]
pub struct ViewingGeometry {
    /// Distance of the station, metres; 0 where it has not one place.
    pub range: f64,
    /// Cosine of the incidence; 1 where the station has not one place.
    pub cos: f64,
    /// Whether the station stands on the side to which the outward normal points.
    pub from_outside: bool,
    /// Widest angle between neighbouring beams, radians; 0 where it is not known.
    pub step: f64,
    /// Whether beams came from somewhere: points without rays cannot tell of emptiness.
    pub has_rays: bool,
}
