//! How surfaces answer light.

/// Refractive index of glass.
const GLASS: f64 = 1.5;
/// Refractive index of water.
const WATER: f64 = 1.33;

/// A surface's material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Share of the light that it scatters in all directions (Lambert), 0 to 1, at the scanner's wavelength.
    pub reflectivity: f64,
    /// By how much ranges to it are too long, metres: light that enters before it returns, and the receiver's answer to
    /// dark and bright.
    pub range_bias_m: f64,
    /// What else happens to light there.
    pub optics: Optics,
}

/// What happens to light at a surface, besides being scattered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Optics {
    /// Nothing.
    Matt,
    /// A pane: light passes, a part is mirrored; it returns only near the normal.
    Glass,
    /// All light that is not scattered is mirrored.
    Mirror,
    /// Dark with water, which mirrors the more the flatter light comes.
    Wet,
}

impl Material {
    /// A surface that scatters only.
    pub fn matt(reflectivity: f64, range_bias_m: f64) -> Self {
        Self { reflectivity, range_bias_m, optics: Optics::Matt }
    }

    /// A window's pane.
    pub fn glass() -> Self {
        Self { reflectivity: 0.0, range_bias_m: 0.0, optics: Optics::Glass }
    }

    /// A mirror.
    pub fn mirror() -> Self {
        Self { reflectivity: 0.01, range_bias_m: 0.0, optics: Optics::Mirror }
    }

    /// The same surface under water.
    pub fn wet(self) -> Self {
        Self { reflectivity: 0.2 * self.reflectivity, optics: Optics::Wet, ..self }
    }

    /// Share of the light that is mirrored, by the cosine of the angle of incidence.
    pub fn mirrored(&self, cos: f64) -> f64 {
        match self.optics {
            Optics::Matt => 0.0,
            Optics::Glass => fresnel(GLASS, cos),
            Optics::Mirror => 0.9,
            Optics::Wet => fresnel(WATER, cos),
        }
    }
}

/// Unpolarised light mirrored by a medium of this refractive index, as a share.
fn fresnel(index: f64, cos: f64) -> f64 {
    let sin_inside = (1.0 - cos * cos).max(0.0).sqrt() / index;
    let cos_inside = (1.0 - sin_inside * sin_inside).sqrt();
    let across = (cos - index * cos_inside) / (cos + index * cos_inside);
    let along = (index * cos - cos_inside) / (index * cos + cos_inside);
    0.5 * (across * across + along * along)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glass_mirrors_four_percent_and_all_at_grazing_incidence() {
        let glass = Material::glass();
        assert!((glass.mirrored(1.0) - 0.04).abs() < 1e-12);
        assert!((glass.mirrored(0.0) - 1.0).abs() < 1e-12);
        // At Brewster's angle, tan θ = n, one polarisation is not mirrored: half of ((n² − 1)/(n² + 1))².
        let brewster = 1.5f64.atan().cos();
        assert!((glass.mirrored(brewster) - 0.5 * (1.25f64 / 3.25).powi(2)).abs() < 1e-12);
    }
}
