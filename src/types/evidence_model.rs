//! `ab_evidence_model`: the parameters, in core's byte form; `name=value` words as text.

use asbuilt_core::Result;
use asbuilt_core::evidence::SensorPreset;
use asbuilt_core::num::bytes::Reader;
use asbuilt_core::verify::{EvidenceModel, IntensityNoise, ModelKind};

use crate::pg::{Args, Field, Ret, Rows, sql_functions};

const TY: &str = "ab_evidence_model";

/// Reads the stored form.
pub fn parse(bytes: &[u8]) -> Result<EvidenceModel> {
    let mut r = Reader::new(bytes, TY);
    let model = EvidenceModel::read(&mut r)?;
    r.finish()?;
    Ok(model)
}

fn ret(m: &EvidenceModel) -> Result<Ret> {
    let mut bytes = Vec::with_capacity(EvidenceModel::LEN);
    m.write(&mut bytes);
    Ok(Ret::Fixed(bytes))
}

/// The model in argument `i`; the default when it is NULL.
pub fn model_arg(args: &Args, i: usize) -> Result<EvidenceModel> {
    if args.is_null(i) { Ok(EvidenceModel::default()) } else { parse(&args.fixed::<{ EvidenceModel::LEN }>(i)) }
}

/// Level of accuracy, model name, then the numbers in the order of `EvidenceModel::names`; NULL keeps the default.
fn from_args(args: &Args) -> Result<EvidenceModel> {
    let mut m = EvidenceModel::default();
    if !args.is_null(0) {
        m.loa = args.loa(0)?;
    }
    if !args.is_null(1) {
        m.kind = ModelKind::parse(&args.text(1))?;
    }
    for (i, name) in EvidenceModel::names().enumerate() {
        if !args.is_null(2 + i) {
            m.set(name, args.f64(2 + i))?;
        }
    }
    Ok(m)
}

sql_functions! {
    fn ab_evidence_model_in(args) { ret(&EvidenceModel::from_text(&args.cstring(0))?) }

    fn ab_evidence_model_out(args) { Ok(Ret::CString(model_arg(args, 0)?.to_text())) }

    fn ab_evidence_model_recv(args) { ret(&parse(args.message(0))?) }

    fn ab_evidence_model_send(args) {
        Ok(Ret::Bytes(args.fixed::<{ EvidenceModel::LEN }>(0).to_vec()))
    }

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
        Ok(Ret::Null)
    }

    /// ab_with_sensor(model, name)
    fn ab_with_sensor(args) {
        // Not strict: a NULL would quietly be the default parameters where the result is used.
        let p = SensorPreset::named(&if args.is_null(1) { "NULL".into() } else { args.text(1) })?;
        let (sigma_range, sigma_angle, sigma_station) = (p.sigma_range, p.sigma_angle, p.sigma_station);
        ret(&EvidenceModel { sigma_range, sigma_angle, sigma_station, ..model_arg(args, 0)? })
    }

    /// ab_with_intensity(model, reference, exponent)
    fn ab_with_intensity(args) {
        let intensity = Some(IntensityNoise::new(args.i32(1), args.f64(2))?);
        ret(&EvidenceModel { intensity, ..model_arg(args, 0)? })
    }

    fn ab_evidence_model_make(args) { ret(&from_args(args)?) }
}
