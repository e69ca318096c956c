//! `ab_change_table(objects, old_scans, new_scans, …)`: what became of every object between two epochs.

use asbuilt_core::geometry::Solid;
use asbuilt_core::verify::{
    Batch, Evidence, EvidenceModel, ObjectChange, ObjectChangeClass, Sights, SurveyObjects, SurveyedEpoch, Verifier,
};
use asbuilt_core::{Error, Result};

use super::evidence_model::{ModelArg, model_or_default};
use super::summary::shift_fields;
use super::verify_table::{Objects, absorb_scans, objects};
use crate::pg::{Account, Args, ResultCell, RowField, SqlValue, WorkerPool, sql_functions};

/// One epoch: its patches, and the objects as they were surveyed then.
struct Epoch<'a> {
    what: &'static str,
    scans: &'a str,
    objects: &'a SurveyObjects,
}

impl Epoch<'_> {
    /// The evidence about the objects of a batch; `sights` remember all beams.
    fn evidence(
        &self,
        call: &Args,
        batch: &Batch,
        sights: Option<&mut Sights>,
        crew: &WorkerPool,
    ) -> Result<Vec<(u32, Evidence)>> {
        let mut verifier = crew.run(|interrupt| Verifier::new(self.objects, batch, crew.threads(), interrupt))?;
        absorb_scans(call, self.what, self.scans, &mut verifier, sights, crew)?;
        Ok(verifier.into_evidence().collect())
    }
}

/// What became of every object, by its number.
fn changes(call: &Args, old: &Epoch, new: &Epoch, crew: &WorkerPool) -> Result<Vec<Option<ObjectChange>>> {
    let mut out: Vec<Option<ObjectChange>> = (0..old.objects.len()).map(|_| None).collect();
    let mut sights = [Sights::default(), Sights::default()];
    for (round, batch) in old.objects.batches().iter().enumerate() {
        let [of_old, of_new] = sights.each_mut().map(|sights| (round == 0).then_some(sights));
        let before = old.evidence(call, batch, of_old, crew)?;
        let after = new.evidence(call, batch, of_new, crew)?;
        let pairs = before.into_iter().zip(after).map(|((object, old), (_, new))| (object, [old, new], None));
        let mut pairs: Vec<(u32, [Evidence; 2], Option<ObjectChange>)> = pairs.collect();
        let epochs = [
            SurveyedEpoch { objects: old.objects, sights: &sights[0] },
            SurveyedEpoch { objects: new.objects, sights: &sights[1] },
        ];
        crew.run(|interrupt| {
            crew.threads().for_each(&mut pairs, |(object, both, change)| {
                *change = Some(ObjectChange::looking_beside(*object, both.each_mut(), epochs, interrupt)?);
                Ok(())
            })
        })?;
        for (object, _, change) in pairs {
            out[object as usize] = change;
        }
    }
    Ok(out)
}

/// The same samples and question under another survey.
fn surveyed(model: &EvidenceModel, survey: &EvidenceModel) -> EvidenceModel {
    EvidenceModel { kind: model.kind, spacing: model.spacing, question: model.question, ..*survey }
}

/// The objects as a new survey measured them; `None` where it is like the old one.
fn resurveyed(
    solids: &[(Solid, EvidenceModel)],
    survey: Option<EvidenceModel>,
    crew: &WorkerPool,
) -> Result<Option<SurveyObjects>> {
    let Some(survey) = survey else { return Ok(None) };
    let solids = solids.iter().map(|(solid, model)| (solid.clone(), surveyed(model, &survey))).collect();
    crew.run(|interrupt| SurveyObjects::new(solids, crew.threads(), interrupt)).map(Some)
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
        let Objects { rows, solids } = self::objects(call, &objects_query, &model, &crew)?;
        let as_new = resurveyed(&solids, new_model, &crew)?;
        let as_old = crew.run(|interrupt| SurveyObjects::new(solids, crew.threads(), interrupt))?;
        let old = Epoch { what: "the query of old scans", scans: &old_query, objects: &as_old };
        let objects = as_new.as_ref().unwrap_or(&as_old);
        let new = Epoch { what: "the query of new scans", scans: &new_query, objects };
        let mut changes = changes(call, &old, &new, &crew)?.into_iter();
        for (id, has_solid) in &rows {
            let id = if let ResultCell::Integer(id) = id { RowField::I64(*id) } else { RowField::Null };
            let mut fields = vec![id];
            match has_solid.then(|| changes.next()).flatten().flatten() {
                Some(change) => fields.extend(row(&change)),
                None => fields.resize(out.width(), RowField::Null),
            }
            out.push(&fields);
        }
        Ok(SqlValue::Null)
    }
}
