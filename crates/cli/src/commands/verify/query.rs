//! The verdicts on all objects, by the server's `ab_verify_table`.

use anyhow::Result;
use asbuilt_core::evidence::{Loa, SensorPreset};
use postgres::types::ToSql;
use postgres::{IsolationLevel, Row};

use super::question::QuestionArgs;
use crate::database::connect::{Database, explain};
use crate::output::spinner;

/// Every literal has its type and every name its schema, so that what others have planted beside the extension matches
/// less well.
const VERIFIED: &str = "
FROM   @building_object o
JOIN   @ext.ab_verify_table(
           pg_catalog.format($9::text, $2::text, $3::text, $4::float8, $5::float8, $8::float8, $6::float8, $7::float8, $10::float8),
           $1::text, NULL::@ext.ab_evidence_model, $11::bool, NULL::float8, NULL::float8, NULL::float8) s ON s.id = o.id";

const VERDICTS: &str = "
SELECT o.id, o.name, o.global_id, o.ifc_class, o.storey, coalesce($2::text, o.loa::text), s.verdict, s.best_loa::text, s.samples,
       s.coverage, s.confirmed, s.refuted, s.open, s.conflict, s.deviation, s.deviation_sd, s.shift, s.shift_sd,
       s.deviation_normal, s.deviation_face, s.reason, s.reason_shares, coalesce(h.name, s.hidden_by), coalesce(t.name, s.drawn_twice)
@verified
LEFT   JOIN @building_object h ON h.id = s.hidden_by::int8
LEFT   JOIN @building_object t ON t.id = s.drawn_twice::int8
ORDER  BY o.id";

const EXPLANATIONS: &str = "
SELECT o.id, o.name, o.global_id, o.ifc_class, o.storey,
       @ext.ab_explain(s.evidence, NULL::@ext.ab_loa, NULL::float8, NULL::float8, NULL::float8, NULL::float8)
@verified
WHERE  o.id = ANY ($12::int8[])
ORDER  BY o.id";

/// What is verified, as a template for PostgreSQL's `format`.
pub const OBJECTS: &str = "
SELECT id, solid, @ext.ab_evidence_model(loa => coalesce(%L::@ext.ab_loa, loa), model => %L::text, spacing => %L::float8,
       sigma_range => %L::float8, sigma_angle => %L::float8, sigma_station => %L::float8, confidence => %L::float8,
       reach => %L::float8)
FROM   @building_object";

/// An object with its row of [`VERDICTS`].
pub struct VerifiedObject {
    pub id: i64,
    /// `unobserved` where it has no solid: no evidence, and the object is there all the same.
    pub verdict: String,
    pub row: Row,
}

impl VerifiedObject {
    fn of(row: Row) -> Self {
        let verdict = row.get::<_, Option<String>>(6).unwrap_or_else(|| "unobserved".into());
        Self { id: row.get(0), verdict, row }
    }

    /// Of its name, class or storey, by the number of the column.
    pub fn text(&self, column: Named) -> Option<&str> {
        self.row.get(column as usize)
    }

    /// Share of its samples that were seen.
    pub fn coverage(&self) -> Option<f64> {
        self.row.get(9)
    }

    /// Metres.
    pub fn deviation(&self) -> Option<f64> {
        self.row.get(14)
    }
}

/// What names an object, by its column in [`VERDICTS`].
#[derive(Debug, Clone, Copy)]
pub enum Named {
    Name = 1,
    Class = 3,
    Storey = 4,
}

/// Every object, by id.
pub fn judged(question: &QuestionArgs, db: &mut Database) -> Result<Vec<VerifiedObject>> {
    Ok(rows(question, db, VERDICTS, None)?.into_iter().map(VerifiedObject::of).collect())
}

/// Id, name, GlobalId, class, storey and the explanation of these objects, each verified among all.
pub fn explanations(question: &QuestionArgs, db: &mut Database, ids: &[i64]) -> Result<Vec<Row>> {
    rows(question, db, EXPLANATIONS, Some(ids))
}

/// The rows of a statement about what was verified; evidence is kept where `ids` choose some of the objects.
fn rows(question: &QuestionArgs, db: &mut Database, statement: &str, ids: Option<&[i64]>) -> Result<Vec<Row>> {
    let statement = db.sql(&statement.replace("@verified", VERIFIED.trim_start()));
    let objects = db.names.for_format().sql(OBJECTS);
    let QuestionArgs { epoch, model, spacing, confidence, reach, .. } = question;
    let scans = format!("{} WHERE epoch = '{epoch}'::int4", db.sql("SELECT patch FROM @scan"));
    let loa = question.loa.map(Loa::name);
    let preset = question.sensor.as_deref().map(SensorPreset::named).transpose()?;
    let sigma_range = question.sigma_range.or(preset.map(|p| p.sigma_range));
    let sigma_station = question.sigma_station.or(preset.map(|p| p.sigma_station));
    let sigma_angle = preset.map(|p| p.sigma_angle);
    let keep = ids.is_some();
    let bar = spinner("verifying");
    let one_view = db.client.build_transaction().read_only(true).isolation_level(IsolationLevel::RepeatableRead);
    let mut client = one_view.start().map_err(explain)?;
    let mut parameters: Vec<&(dyn ToSql + Sync)> = vec![
        &scans,
        &loa,
        model,
        spacing,
        &sigma_range,
        &sigma_station,
        confidence,
        &sigma_angle,
        &objects,
        reach,
        &keep,
    ];
    parameters.extend(ids.iter().map(|ids| ids as &(dyn ToSql + Sync)));
    let rows = client.query(&statement, &parameters).map_err(explain)?;
    bar.finish_and_clear();
    Ok(rows)
}
