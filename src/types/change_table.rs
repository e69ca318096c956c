//! `ab_change_table(objects, old_scans, new_scans, …)`: what became of every object between two epochs.

use asbuilt_core::verify::{Evidence, EvidenceModel, ObjectChange, ObjectChangeClass, Verifier};
use asbuilt_core::{Error, Result};

use super::evidence_model::{ModelArg, model_or_default};
use super::summary::shift_fields;
use super::verify_table::{Objects, absorb_scans, objects};
use crate::pg::{Account, Args, ResultCell, RowField, SqlValue, WorkerPool, sql_functions};

/// Objects that are compared at once.
const COMPARED: usize = 32;

/// The evidence of one epoch about all objects.
fn epoch(
    call: &Args,
    what: &'static str,
    scans: &str,
    objects: &Objects,
    crew: &WorkerPool,
) -> Result<Vec<Evidence>> {
    let mut verifier = crew.run(|interrupt| Verifier::new(&objects.solids, crew.threads(), interrupt))?;
    absorb_scans(call, what, scans, &mut verifier, crew)?;
    Ok(verifier.into_evidence())
}

/// The same samples and question under another survey.
fn surveyed(model: &EvidenceModel, survey: &EvidenceModel) -> EvidenceModel {
    EvidenceModel { kind: model.kind, spacing: model.spacing, question: model.question, ..*survey }
}

/// The columns after the id.
fn row(change: &ObjectChange) -> Vec<RowField> {
    let s = &change.samples;
    let share = |n: u64| match s.seen_in_both {
        0 => RowField::Null,
        all => RowField::F64(n as f64 / all as f64),
    };
    let stands = !matches!(
        change.class,
        ObjectChangeClass::Appeared | ObjectChangeClass::Gone | ObjectChangeClass::NotComparable
    );
    let displacement = change.displacement.as_ref().filter(|_| stands);
    let mut fields = vec![RowField::Enum(change.class.name()), RowField::F64(change.seen_in_both())];
    fields.extend(shift_fields(displacement.map(|d| &d.shift)));
    fields.push(RowField::or_null(displacement, |d| RowField::F64(d.chance)));
    fields.push(RowField::I64(s.samples as i64));
    fields.extend([s.kept, s.lost, s.won, s.empty].map(share));
    fields
}

sql_functions! {
    on Account::Evidence;

    fn ab_change_table(
        call: Call, out: Rows; objects: Option<String>, old_scans: Option<String>, new_scans: Option<String>,
        model: Option<ModelArg>, new_model: Option<ModelArg>
    ) {
        let no_query = |what| Error::argument(what, "one SELECT", "NULL");
        let objects_query = objects.ok_or_else(|| no_query("the query of objects"))?;
        let old_query = old_scans.ok_or_else(|| no_query("the query of old scans"))?;
        let new_query = new_scans.ok_or_else(|| no_query("the query of new scans"))?;
        let model = model_or_default(model.as_ref())?;
        let new_model = new_model.as_ref().map(|m| model_or_default(Some(m))).transpose()?;
        let crew = WorkerPool::gather();
        let mut objects = self::objects(call, &objects_query, &model, &crew)?;
        let mut old = epoch(call, "the query of old scans", &old_query, &objects, &crew)?;
        if let Some(survey) = new_model {
            objects.solids.iter_mut().for_each(|(_, model)| *model = surveyed(model, &survey));
        }
        let mut new = epoch(call, "the query of new scans", &new_query, &objects, &crew)?;
        for rows in objects.rows.chunks(COMPARED) {
            let count = rows.iter().filter(|r| r.1).count();
            let pairs: Vec<(Evidence, Evidence)> = old.drain(..count).zip(new.drain(..count)).collect();
            let mut changes = crew.run(|interrupt| {
                crew.threads().map(&pairs, |(old, new)| ObjectChange::between(old, new, interrupt))
            })?.into_iter();
            for (id, has_solid) in rows {
                let id = if let ResultCell::Integer(id) = id { RowField::I64(*id) } else { RowField::Null };
                let mut fields = vec![id];
                match has_solid.then(|| changes.next()).flatten() {
                    Some(change) => fields.extend(row(&change)),
                    None => fields.resize(out.width(), RowField::Null),
                }
                out.push(&fields);
            }
        }
        Ok(SqlValue::Null)
    }
}
