//! `ab_verify_table(objects, scans, …)`: every patch unpacked once for all objects of a batch.

use std::sync::Mutex;

use asbuilt_core::geometry::Solid;
use asbuilt_core::verify::{Evidence, EvidenceModel, Judged, Sights, SurveyObjects, VerdictRule, Verifier};
use asbuilt_core::{Error, Interrupt, Result};

use super::evidence_model::{ModelArg, model_or_default, parse};
use super::summary::{row, rule};
use crate::pg::{
    Account, Args, Query, ResultCell, ResultColumn, RowField, SqlValue, WorkerPool, for_each_batch, sql_functions,
};

/// Patches that are unpacked at once: about ten megabytes.
const BATCH: i64 = 64;
/// Objects whose verdicts are made at once.
const VERDICTS: usize = 32;

/// Objects as the query returned them; without a solid there is nothing to verify.
#[derive(Default)]
pub struct Objects {
    /// Id, and whether it has a solid.
    pub rows: Vec<(ResultCell, bool)>,
    /// Those that have one, in order.
    pub solids: Vec<(Solid, EvidenceModel)>,
}

/// Reads the query of objects; those without a model of their own get `model`.
pub fn objects(call: &Args, text: &str, model: &EvidenceModel, crew: &WorkerPool) -> Result<Objects> {
    let query = Query {
        what: "the query of objects",
        text,
        columns: &[
            ResultColumn::Integer,
            ResultColumn::Varlena("ab_solid"),
            ResultColumn::Varlena("ab_evidence_model"),
        ],
        optional: 1,
        expected: "a SELECT of an integer id, an ab_solid and perhaps an ab_evidence_model",
    };
    let mut out = Objects::default();
    for_each_batch(call, query, 256, |mut rows| {
        out.rows.extend(rows.iter().map(|r| (r[0].clone(), r[1].bytes().is_some())));
        rows.retain(|r| r[1].bytes().is_some());
        let solids = crew.run(|interrupt| {
            crew.threads().map(&rows, |row| {
                let solid = Solid::from_stored(row[1].bytes().unwrap_or_default(), interrupt)?;
                let own = row.get(2).and_then(ResultCell::bytes).map(parse).transpose()?;
                Ok((solid, own.unwrap_or(*model)))
            })
        })?;
        out.solids.extend(solids);
        Ok(())
    })?;
    Ok(out)
}

/// Adds what the patches of a query tell; `what` names it in messages.
pub fn absorb_scans(
    call: &Args,
    what: &'static str,
    text: &str,
    verifier: &mut Verifier,
    mut sights: Option<&mut Sights>,
    crew: &WorkerPool,
) -> Result<()> {
    let query = Query {
        what,
        text,
        columns: &[ResultColumn::Varlena("ab_scan")],
        optional: 0,
        expected: "a SELECT of one column of ab_scan",
    };
    for_each_batch(call, query, BATCH, |rows| {
        let patches: Vec<&[u8]> = rows.iter().filter_map(|r| r[0].bytes()).collect();
        crew.run(|interrupt| verifier.absorb(&patches, sights.as_deref_mut(), interrupt))
    })
}

/// An object's verdict, and its evidence where it is kept.
type Kept = (Judged, Option<Vec<u8>>);

/// What a batch is judged by.
struct Judge<'a> {
    objects: &'a SurveyObjects,
    sights: &'a Sights,
    rule: VerdictRule,
    keep: bool,
}

impl Judge<'_> {
    fn judge(&self, object: u32, mut evidence: Evidence, interrupt: Interrupt) -> Result<Kept> {
        let judged = self.objects.judge(object, &mut evidence, self.sights, &self.rule, interrupt)?;
        let bytes = self.keep.then(|| evidence.to_bytes(interrupt)).transpose()?;
        Ok((judged, bytes))
    }
}

/// For each object its verdict, batch by batch: the scans are read once for each.
fn judged(
    call: &Args,
    scans: &str,
    objects: &SurveyObjects,
    (rule, keep): (VerdictRule, bool),
    crew: &WorkerPool,
) -> Result<Vec<Option<Kept>>> {
    let mut out: Vec<Option<Kept>> = (0..objects.len()).map(|_| None).collect();
    let mut sights = Sights::default();
    for (round, batch) in objects.batches().iter().enumerate() {
        let mut verifier = crew.run(|interrupt| Verifier::new(objects, batch, crew.threads(), interrupt))?;
        absorb_scans(call, "the query of scans", scans, &mut verifier, (round == 0).then_some(&mut sights), crew)?;
        let judge = Judge { objects, sights: &sights, rule, keep };
        let mut evidence = verifier.into_evidence();
        loop {
            let due: Vec<(u32, Mutex<Option<Evidence>>)> =
                evidence.by_ref().take(VERDICTS).map(|(i, e)| (i, Mutex::new(Some(e)))).collect();
            if due.is_empty() {
                break;
            }
            let verdicts = crew.run(|interrupt| {
                crew.threads().map(&due, |(object, evidence)| {
                    let evidence = evidence.lock().ok().and_then(|mut e| e.take());
                    evidence.map(|e| judge.judge(*object, e, interrupt)).transpose()
                })
            })?;
            for ((object, _), verdict) in due.iter().zip(verdicts) {
                out[*object as usize] = verdict;
            }
        }
    }
    Ok(out)
}

sql_functions! {
    on Account::Evidence;

    fn ab_verify_table(
        call: Call, out: Rows; objects: Option<String>, scans: Option<String>, model: Option<ModelArg>,
        keep_evidence: Option<bool>, min_confirmed: Option<f64>, min_coverage: Option<f64>, max_conflict: Option<f64>
    ) {
        let no_query = |what| Error::argument(what, "one SELECT", "NULL");
        let objects_query = objects.ok_or_else(|| no_query("the query of objects"))?;
        let scans_query = scans.ok_or_else(|| no_query("the query of scans"))?;
        let model = model_or_default(model.as_ref())?;
        let rule = rule([min_confirmed, min_coverage, max_conflict])?;
        let keep = keep_evidence.unwrap_or(true);
        let crew = WorkerPool::gather();
        let Objects { rows, solids } = self::objects(call, &objects_query, &model, &crew)?;
        let objects = crew.run(|interrupt| SurveyObjects::new(solids, crew.threads(), interrupt))?;
        let ids: Vec<String> = rows.iter().filter(|r| r.1).map(|r| id_text(&r.0)).collect();
        let name = |object: Option<u32>| {
            RowField::or_null(object.and_then(|i| ids.get(i as usize)), |id| RowField::Text(id.clone()))
        };
        let mut verdicts = judged(call, &scans_query, &objects, (rule, keep), &crew)?.into_iter().enumerate();
        for (id, has_solid) in &rows {
            let id = if let ResultCell::Integer(id) = id { RowField::I64(*id) } else { RowField::Null };
            let mut fields = vec![id];
            match has_solid.then(|| verdicts.next()).flatten() {
                Some((object, Some((Judged { summary, hidden_by }, bytes)))) => {
                    fields.push(RowField::or_null(bytes, RowField::Bytes));
                    fields.extend(row(&summary, name(hidden_by)));
                    fields.push(name(objects.drawn_twice(object as u32)));
                }
                _ => fields.resize(out.width(), RowField::Null),
            }
            out.push(&fields);
        }
        Ok(SqlValue::Null)
    }
}

fn id_text(id: &ResultCell) -> String {
    if let ResultCell::Integer(id) = id { id.to_string() } else { String::new() }
}
