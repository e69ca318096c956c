//! What became of each object between two epochs, by the server's `ab_change_table`.

use std::collections::HashMap;

use anyhow::Result;
use asbuilt_core::evidence::SensorPreset;
use postgres::Transaction;
use postgres::types::ToSql;
use serde_json::{Map, Value};

use crate::commands::verify::query::OBJECTS;
use crate::commands::verify::shift::{NumbersByAxis, shift, shift_columns};
use crate::database::connect::explain;
use crate::database::names::Names;
use crate::output::{Format, LengthUnit, rounded, spinner};

/// How objects are sampled and how both epochs were surveyed.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Objects")]
pub struct SurveyArgs {
    /// Distance between samples on the objects, metres
    #[arg(long, default_value_t = 0.02, value_name = "M")]
    spacing: f64,
    /// Kind of scanner, for its standard uncertainties: phase, hybrid, pulse, compact, handheld or tablet
    #[arg(long, value_name = "NAME")]
    sensor: Option<String>,
    /// Standard deviation of a range, metres
    #[arg(long, value_name = "M")]
    sigma_range: Option<f64>,
    /// Standard deviation of a station's registration, metres: the floor under what counts as moved
    #[arg(long, value_name = "M")]
    sigma_station: Option<f64>,
}

/// What became of an object.
#[derive(Debug, Clone)]
pub struct ObjectClass {
    class: Option<String>,
    seen_in_both: Option<f64>,
    shift: NumbersByAxis,
    shift_sd: NumbersByAxis,
}

impl ObjectClass {
    /// The columns' names.
    pub fn columns(format: Format, unit: LengthUnit) -> Vec<String> {
        ["change", "seen_in_both"].map(String::from).into_iter().chain(shift_columns(format, unit)).collect()
    }

    /// What stands in them; an object without a solid cannot be compared.
    pub fn cells(of: Option<&Self>, format: Format, unit: LengthUnit) -> Vec<Value> {
        let Some(own) = of else { return vec![Value::Null; Self::columns(format, unit).len()] };
        let class = own.class.clone().unwrap_or_else(|| "not_comparable".into());
        let mut out = vec![class.into(), rounded(own.seen_in_both, 3)];
        out.extend(shift(format, unit, own.shift.clone(), own.shift_sd.clone()));
        out
    }

    /// The same as parts of a JSON object.
    pub fn json(of: Option<&Self>, unit: LengthUnit) -> Map<String, Value> {
        Self::columns(Format::Json, unit).into_iter().zip(Self::cells(of, Format::Json, unit)).collect()
    }
}

const CHANGES: &str = "
SELECT c.id, c.change::text, c.seen_in_both, c.shift, c.shift_sd
FROM   @ext.ab_change_table(
           pg_catalog.format($1::text, NULL::text, 'surface'::text, $4::float8, $5::float8, $6::float8, $7::float8, NULL::float8,
           NULL::float8),
           $2::text, $3::text, NULL::@ext.ab_evidence_model, NULL::@ext.ab_evidence_model) c";

/// The class of every object by its id.
pub fn classes(
    tx: &mut Transaction,
    names: &Names,
    survey: &SurveyArgs,
    epochs: [i32; 2],
) -> Result<HashMap<i64, ObjectClass>> {
    let objects = names.for_format().sql(OBJECTS);
    let [old, new] = epochs.map(|e| format!("{} WHERE epoch = '{e}'::int4", names.sql("SELECT patch FROM @scan")));
    let preset = survey.sensor.as_deref().map(SensorPreset::named).transpose()?;
    let range = survey.sigma_range.or(preset.map(|p| p.sigma_range));
    let station = survey.sigma_station.or(preset.map(|p| p.sigma_station));
    let angle = preset.map(|p| p.sigma_angle);
    let bar = spinner("comparing objects");
    let parameters: [&(dyn ToSql + Sync); 7] = [&objects, &old, &new, &survey.spacing, &range, &angle, &station];
    let rows = tx.query(&names.sql(CHANGES), &parameters).map_err(explain)?;
    let own = |row: &postgres::Row| ObjectClass {
        class: row.get(1),
        seen_in_both: row.get(2),
        shift: row.get(3),
        shift_sd: row.get(4),
    };
    let out = rows.iter().map(|row| (row.get(0), own(row))).collect();
    bar.finish_and_clear();
    Ok(out)
}
