//! What is asked of every object, and how the scans were surveyed.

use asbuilt_core::evidence::Loa;

use crate::commands::load::parse_loa;

/// The question, as `verify` and `explain` take it.
#[derive(clap::Args, Debug)]
pub struct QuestionArgs {
    /// Epoch of the scans
    #[arg(long, default_value_t = 1, value_name = "N", allow_hyphen_values = true)]
    pub epoch: i32,
    /// Judge every object at this level of accuracy, instead of at its own
    #[arg(long, value_parser = parse_loa)]
    pub loa: Option<Loa>,
    /// Evidence model: surface, or meyer2022 (as published; for comparison)
    #[arg(long, default_value = "surface")]
    pub model: String,
    /// Distance between samples on the objects, metres
    #[arg(long, default_value_t = 0.02, value_name = "M")]
    pub spacing: f64,
    /// Kind of scanner, for its standard uncertainties: phase, hybrid, pulse, compact, handheld or tablet
    #[arg(long, value_name = "NAME")]
    pub sensor: Option<String>,
    /// Standard deviation of a range, metres
    #[arg(long, value_name = "M")]
    pub sigma_range: Option<f64>,
    /// Standard deviation of a station's registration, metres
    #[arg(long, value_name = "M")]
    pub sigma_station: Option<f64>,
    /// How far from its drawn place an object is looked for that is not there, metres [default: 0.3]
    #[arg(long, value_name = "M")]
    pub reach: Option<f64>,
    /// Belief from which a sample counts as confirmed or refuted
    #[arg(long, value_name = "P")]
    pub confidence: Option<f64>,
}
