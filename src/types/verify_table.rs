//! `ab_verify_table(objects, scans, …)`: every patch unpacked once for all objects.

use asbuilt_core::geometry::Solid;
use asbuilt_core::verify::{Evidence, EvidenceModel, Samples, Summary, VerdictRule, Verifier};
use asbuilt_core::{Budget, Error, Result};

use super::evidence_model::{ModelArg, model_or_default, parse};
use super::summary::{row, rule};
use crate::pg::{
    Account, Args, Backend, Query, ResultCell, ResultColumn, RowField, SqlValue, WorkerPool, for_each_batch,
    sql_functions,
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
    let (mut out, mut expected) = (Objects::default(), 0);
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
        // Before any is spread: a few solids can ask for more than there is.
        expected += solids.iter().map(|(solid, m)| Samples::expected_memory(solid, m.spacing)).sum::<usize>();
        out.solids.extend(solids);
        Backend.room(expected)
    })?;
    Ok(out)
}

/// Adds what the patches of a query tell; `what` names it in messages.
pub fn absorb_scans(
    call: &Args,
    what: &'static str,
    text: &str,
    verifier: &mut Verifier,
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
        crew.run(|interrupt| verifier.absorb(&patches, interrupt))
    })
}

fn verdict(
    e: &Evidence,
    rule: &VerdictRule,
    keep: bool,
    interrupt: asbuilt_core::Interrupt,
) -> Result<(Summary, Option<Vec<u8>>)> {
    let bytes = keep.then(|| e.to_bytes(interrupt)).transpose()?;
    Ok((e.summary(&e.model().question, rule, interrupt)?, bytes))
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
        let objects = self::objects(call, &objects_query, &model, &crew)?;
        let mut verifier = crew.run(|interrupt| Verifier::new(&objects.solids, crew.threads(), interrupt))?;
        absorb_scans(call, "the query of scans", &scans_query, &mut verifier, &crew)?;
        let mut evidence = verifier.into_evidence();
        for rows in objects.rows.chunks(VERDICTS) {
            let due: Vec<Evidence> = evidence.drain(..rows.iter().filter(|r| r.1).count()).collect();
            let mut verdicts = crew.run(|interrupt| {
                crew.threads().map(&due, |e| verdict(e, &rule, keep, interrupt))
            })?.into_iter();
            for (id, has_solid) in rows {
                let id = if let ResultCell::Integer(id) = id { RowField::I64(*id) } else { RowField::Null };
                let mut fields = vec![id];
                match has_solid.then(|| verdicts.next()).flatten() {
                    Some((summary, bytes)) => {
                        fields.push(RowField::or_null(bytes, RowField::Bytes));
                        fields.extend(row(&summary));
                    }
                    None => fields.resize(out.width(), RowField::Null),
                }
                out.push(&fields);
            }
        }
        Ok(SqlValue::Null)
    }
}
