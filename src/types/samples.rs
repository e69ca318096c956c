//! `ab_samples(evidence)`, `ab_faces(evidence)`, `ab_stations(evidence)`: what is believed where, and who saw it.

use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::verify::StationOrigin;

use super::evidence::EvidenceArg;
use super::mass_bytes;
use super::summary::question;
use crate::pg::{Account, Backend, RowField, SqlValue, sql_functions};

fn vector(v: &Vec3) -> RowField {
    RowField::Vector((*v).into())
}

sql_functions! {
    on Account::Evidence;

    fn ab_samples(rows: Rows; evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>) {
        let e = evidence.read()?;
        let question = question(&e, loa, confidence)?;
        e.for_each_sample(&question, &Backend, |position, normal, b| {
            rows.push(&[
                vector(position),
                vector(normal),
                RowField::Fixed(mass_bytes(&b.mass)),
                RowField::or_null(b.deviation, |d| RowField::F64(d.0)),
                RowField::or_null(b.deviation, |d| RowField::F64(d.1)),
                RowField::I32(b.beams.min(i32::MAX as u32) as i32),
            ]);
        })?;
        Ok(SqlValue::Null)
    }

    fn ab_faces(rows: Rows; evidence: EvidenceArg, loa: Option<Loa>, confidence: Option<f64>) {
        let e = evidence.read()?;
        let question = question(&e, loa, confidence)?;
        for f in e.faces(&question, &Backend)? {
            rows.push(&[
                vector(&f.normal),
                RowField::I64(f.counts.samples as i64),
                RowField::I64(f.counts.seen as i64),
                RowField::I64(f.counts.confirmed as i64),
                RowField::I64(f.counts.refuted as i64),
                RowField::I64(f.counts.open() as i64),
                RowField::I64(f.counts.pierced as i64),
                RowField::or_null(f.deviation, |d| RowField::F64(d.0)),
                RowField::or_null(f.deviation, |d| RowField::F64(d.1)),
            ]);
        }
        Ok(SqlValue::Null)
    }

    fn ab_stations(rows: Rows; evidence: Option<EvidenceArg>) {
        let Some(evidence) = evidence else { return Ok(SqlValue::Null) };
        let e = evidence.read()?;
        for c in e.contributions(&Backend)? {
            let origin = if let StationOrigin::At(origin) = &c.place { vector(origin) } else { RowField::Null };
            rows.push(&[RowField::I64(c.station), origin, RowField::I64(c.seen as i64), RowField::I64(c.added as i64)]);
        }
        Ok(SqlValue::Null)
    }
}
