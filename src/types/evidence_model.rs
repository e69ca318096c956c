//! `ab_evidence_model`: the parameters that were given, as `name=value` words; the others have their defaults where they
//! are used.

use asbuilt_core::Result;
use asbuilt_core::evidence::{Loa, SensorPreset};
use asbuilt_core::num::words::Words;
use asbuilt_core::verify::{EvidenceModel, IntensityNoise, ModelKind};

use super::box_bytes;
use super::solid::SolidArg;
use crate::pg::{Message, RowField, SqlValue, TextInput, Varlena, sql_functions};

const WORDS: Words = Words { ty: "ab_evidence_model", letter: b'M' };

/// Parameters, and the names of those that were given.
#[derive(Debug, Default)]
pub struct GivenParameters {
    /// With the defaults of the others.
    pub model: EvidenceModel,
    names: Vec<String>,
}

/// The name of a word; a level of accuracy need not be named.
fn name_of(word: &str) -> &str {
    word.split_once('=').map_or("loa", |(name, _)| name)
}

impl GivenParameters {
    /// All of them.
    pub fn all(model: EvidenceModel) -> Self {
        Self { model, names: model.to_text().split(' ').map(|w| name_of(w).to_owned()).collect() }
    }

    /// Level of accuracy, model name, and the numbers in the order of `EvidenceModel::names`.
    pub fn of(loa: Option<Loa>, kind: Option<String>, numbers: &[Option<f64>]) -> Result<Self> {
        let mut given = Self::default();
        if let Some(loa) = loa {
            given.model.question.loa = loa;
            given.names.push("loa".into());
        }
        if let Some(kind) = kind {
            given.model.kind = ModelKind::parse(&kind)?;
            given.names.push("model".into());
        }
        for (name, number) in EvidenceModel::names().zip(numbers) {
            if let Some(number) = number {
                given.set(name, *number)?;
            }
        }
        Ok(given)
    }

    fn from_text(text: &str) -> Result<Self> {
        let mut model = EvidenceModel::from_text(text)?;
        // Zero has no sign: equal values are equal bytes.
        for (name, value) in EvidenceModel::names().zip(model.numbers()) {
            model.set(name, value + 0.0)?;
        }
        Ok(Self { model, names: text.split_whitespace().map(|w| name_of(w).to_owned()).collect() })
    }

    /// The words of what was given, in the order of the parameters.
    fn to_text(&self) -> String {
        let all = self.model.to_text();
        let given = |word: &&str| self.names.iter().any(|n| n == name_of(word));
        all.split(' ').filter(given).collect::<Vec<_>>().join(" ")
    }

    fn set(&mut self, name: &str, value: f64) -> Result<()> {
        self.model.set(name, value + 0.0)?;
        self.names.push(name.into());
        Ok(())
    }

    /// As SQL has it.
    pub fn ret(&self) -> Result<SqlValue> {
        Ok(SqlValue::Bytes(WORDS.encode(&self.to_text())?))
    }
}

/// Parameters.
pub type ModelArg<'a> = Varlena<'a, EvidenceModel>;

impl ModelArg<'_> {
    fn given(&self) -> Result<GivenParameters> {
        WORDS.decode(self.bytes(), GivenParameters::from_text)
    }
}

/// The model of an argument; the default when it is NULL.
pub fn model_or_default(model: Option<&ModelArg>) -> Result<EvidenceModel> {
    Ok(model.map(ModelArg::given).transpose()?.unwrap_or_default().model)
}

/// Reads the stored form.
pub fn parse(bytes: &[u8]) -> Result<EvidenceModel> {
    Ok(WORDS.decode(bytes, GivenParameters::from_text)?.model)
}

sql_functions! {
    fn ab_model_in(text: TextInput) { GivenParameters::from_text(&text.text())?.ret() }

    /// The box of a solid, grown by what its evidence looks for around it.
    fn ab_model_reach(solid: Option<SolidArg>, model: Option<ModelArg>) {
        let Some(solid) = solid else { return Ok(SqlValue::Null) };
        let reach = model_or_default(model.as_ref())?.farthest();
        Ok(SqlValue::Fixed(box_bytes(&solid.header()?.bounds.expanded(reach))))
    }

    fn ab_model_out(model: ModelArg) { Ok(SqlValue::CString(model.given()?.to_text())) }

    fn ab_model_recv(message: Message) { WORDS.decode(message.rest(), GivenParameters::from_text)?.ret() }

    fn ab_model_send(model: ModelArg) { Ok(model.copied()) }

    fn ab_model_make(
        loa: Option<Loa>, model: Option<String>, spacing: Option<f64>, sigma_range: Option<f64>,
        sigma_angle: Option<f64>, sigma_station: Option<f64>, sigma_model: Option<f64>, confidence: Option<f64>,
        reliability: Option<f64>, max_incidence: Option<f64>, no_return_range: Option<f64>,
        no_return_weight: Option<f64>, kappa: Option<f64>, lambda: Option<f64>, c: Option<f64>, reach: Option<f64>,
    ) {
        let numbers = [
            spacing, sigma_range, sigma_angle, sigma_station, sigma_model, confidence, reliability, max_incidence,
            no_return_range, no_return_weight, kappa, lambda, c,
        ];
        let mut given = GivenParameters::of(loa, model, &numbers)?;
        reach.map(|reach| given.set("reach", reach)).transpose()?;
        given.ret()
    }

    /// One preset, or all of them without a name.
    fn ab_sensor(rows: Rows; name: Option<String>) {
        let all = match name {
            None => SensorPreset::ALL.to_vec(),
            Some(name) => vec![SensorPreset::named(&name)?],
        };
        for p in all {
            let numbers = [p.sigma_range, p.sigma_angle, p.sigma_station, p.max_range].map(RowField::F64);
            let mut row = vec![RowField::Text(p.name.into())];
            row.extend(numbers);
            row.push(RowField::Text(p.description.into()));
            rows.push(&row);
        }
        Ok(SqlValue::Null)
    }

    fn ab_with_sensor(model: Option<ModelArg>, name: Option<String>) {
        // Not strict: a NULL would quietly be the default parameters where the result is used.
        let p = SensorPreset::named(name.as_deref().unwrap_or("NULL"))?;
        let mut given = model.map(|m| m.given()).transpose()?.unwrap_or_default();
        given.set("sigma_range", p.sigma_range)?;
        given.set("sigma_angle", p.sigma_angle)?;
        given.set("sigma_station", p.sigma_station)?;
        given.ret()
    }

    fn ab_with_intensity(model: ModelArg, reference: i32, exponent: f64) {
        let mut given = model.given()?;
        given.model.intensity = Some(IntensityNoise::new(reference, exponent)?);
        given.names.push("intensity".into());
        given.ret()
    }
}
