//! How well kinds of scanners measure.

use crate::error::{Error, Result};

/// Standard uncertainties of a kind of scanner: the order of magnitude that manufacturers state and field tests by ISO
/// 17123-9 find at 10 to 20 m on matt surfaces. A test of one's own instrument is better.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorPreset {
    /// Name in SQL and on the command line.
    pub name: &'static str,
    /// Standard deviation of a range, metres.
    pub sigma_range: f64,
    /// Standard deviation of a direction, radians.
    pub sigma_angle: f64,
    /// Standard deviation of a position after registration, metres per axis: targets or cloud to cloud, as is usual
    /// with it.
    pub sigma_station: f64,
    /// Range up to which this holds, metres.
    pub max_range: f64,
    /// What kind it is, in words.
    pub description: &'static str,
}

impl SensorPreset {
    /// All presets.
    pub const ALL: [Self; 6] = [
        Self::new("phase", 0.0005, 3.9e-5, 0.001, 80.0, "terrestrial scanner, phase shift (8 arc seconds)"),
        Self::new(
            "hybrid",
            0.0012,
            3.9e-5,
            0.001,
            150.0,
            "terrestrial scanner, wave-form digitising (1.2 mm, 8 arc seconds)",
        ),
        Self::new("pulse", 0.003, 3.9e-5, 0.002, 600.0, "terrestrial scanner, long range, time of flight"),
        Self::new("compact", 0.004, 1.9e-4, 0.002, 45.0, "imaging scanner (4 mm at 10 m, 40 arc seconds)"),
        Self::new("handheld", 0.008, 1e-3, 0.01, 50.0, "hand-held or mobile scanner, trajectory by SLAM"),
        Self::new("tablet", 0.01, 3e-3, 0.02, 5.0, "solid-state lidar of a tablet or telephone"),
    ];

    const fn new(
        name: &'static str,
        sigma_range: f64,
        sigma_angle: f64,
        sigma_station: f64,
        max_range: f64,
        description: &'static str,
    ) -> Self {
        Self { name, sigma_range, sigma_angle, sigma_station, max_range, description }
    }

    /// The preset of this name.
    pub fn named(name: &str) -> Result<Self> {
        let expected = "'phase', 'hybrid', 'pulse', 'compact', 'handheld' or 'tablet'";
        let found = Self::ALL.into_iter().find(|p| p.name == name);
        found.ok_or_else(|| Error::argument("the sensor", expected, format!("'{name}'")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_found_and_the_error_names_them_all() {
        for p in SensorPreset::ALL {
            assert_eq!(SensorPreset::named(p.name), Ok(p));
            assert!(p.sigma_range > 0.0 && p.sigma_angle > 0.0 && p.sigma_station > 0.0);
            assert!(SensorPreset::named("x").unwrap_err().to_string().contains(p.name));
        }
    }
}
