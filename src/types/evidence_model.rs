//! `ab_evidence_model`: the parameters that were given, as `name=value` words; the others have their defaults where they
//! are used.

use asbuilt_core::Result;
use asbuilt_core::evidence::SensorPreset;
use asbuilt_core::num::words::Words;
use asbuilt_core::verify::{EvidenceModel, IntensityNoise, ModelKind};

use crate::pg::{Args, Field, Rows, SqlValue, sql_functions};

const WORDS: Words = Words { ty: "ab_evidence_model", letter: b'M' };

/// Parameters, and the names of those that were given.
#[derive(Debug, Default)]
pub struct Given {
    /// With the defaults of the others.
    pub model: EvidenceModel,
    names: Vec<String>,
}

/// The name of a word; a level of accuracy need not be named.
fn name_of(word: &str) -> &str {
    word.split_once('=').map_or("loa", |(name, _)| name)
}

impl Given {
    /// All of them.
    pub fn all(model: EvidenceModel) -> Self {
        Self { model, names: model.to_text().split(' ').map(|w| name_of(w).to_owned()).collect() }
    }

    /// Level of accuracy, model name, then the numbers in the order of `EvidenceModel::names`, where they are not NULL.
    pub fn from_args(args: &Args) -> Result<Self> {
        let mut given = Self::default();
        if !args.is_null(0) {
            given.model.loa = args.loa(0)?;
            given.names.push("loa".into());
        }
        if !args.is_null(1) {
            given.model.kind = ModelKind::parse(&args.text(1))?;
            given.names.push("model".into());
        }
        for (i, name) in EvidenceModel::names().enumerate() {
            if !args.is_null(2 + i) {
                given.set(name, args.f64(2 + i))?;
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

/// What was given in argument `i`: nothing when it is NULL.
fn given_arg(args: &Args, i: usize) -> Result<Given> {
    if args.is_null(i) { Ok(Given::default()) } else { WORDS.decode(args.bytes(i), Given::from_text) }
}

/// The model in argument `i`; the default when it is NULL.
pub fn model_arg(args: &Args, i: usize) -> Result<EvidenceModel> {
    Ok(given_arg(args, i)?.model)
}

/// Reads the stored form.
pub fn parse(bytes: &[u8]) -> Result<EvidenceModel> {
    Ok(WORDS.decode(bytes, Given::from_text)?.model)
}

sql_functions! {
    fn ab_model_in(args) { Given::from_text(&args.cstring(0))?.ret() }

    fn ab_model_out(args) { Ok(SqlValue::CString(given_arg(args, 0)?.to_text())) }

    fn ab_model_recv(args) { WORDS.decode(args.message(0), Given::from_text)?.ret() }

    fn ab_model_send(args) { Ok(args.copied(0)) }

    /// ab_evidence_model(loa, model, …)
    fn ab_model_make(args) { Given::from_args(args)?.ret() }

    /// ab_sensor(name): one preset, or all of them without a name.
    fn ab_sensor(args) {
        let mut rows = Rows::new(args)?;
        let all = if args.is_null(0) { SensorPreset::ALL.to_vec() } else { vec![SensorPreset::named(&args.text(0))?] };
        for p in all {
            let numbers = [p.sigma_range, p.sigma_angle, p.sigma_station, p.max_range].map(Field::F64);
            let mut row = vec![Field::Text(p.name.into())];
            row.extend(numbers);
            row.push(Field::Text(p.description.into()));
            rows.push(&row);
        }
        Ok(SqlValue::Null)
    }

    /// ab_with_sensor(model, name)
    fn ab_with_sensor(args) {
        // Not strict: a NULL would quietly be the default parameters where the result is used.
        let p = SensorPreset::named(&if args.is_null(1) { "NULL".into() } else { args.text(1) })?;
        let mut given = given_arg(args, 0)?;
        given.set("sigma_range", p.sigma_range)?;
        given.set("sigma_angle", p.sigma_angle)?;
        given.set("sigma_station", p.sigma_station)?;
        given.ret()
    }

    /// ab_with_intensity(model, reference, exponent)
    fn ab_with_intensity(args) {
        let mut given = given_arg(args, 0)?;
        given.model.intensity = Some(IntensityNoise::new(args.i32(1), args.f64(2))?);
        given.names.push("intensity".into());
        given.ret()
    }
}
