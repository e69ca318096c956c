//! What is said of the objects of a survey, which know each other, after a second look.

use super::rule::{Verdict, VerdictRule};
use super::summary::Summary;
use crate::verify::collect::{SurveyObjects, Threads};
use crate::verify::evidence::Evidence;
use crate::verify::sights::Sights;
use crate::{Interrupt, Result};

/// The verdict on one of many objects.
#[derive(Debug, Clone)]
pub struct Judged {
    /// Verdict and numbers.
    pub summary: Summary,
    /// Of an unobserved object the one that hides most of it, by its number.
    pub hidden_by: Option<u32>,
}

impl SurveyObjects {
    /// The verdict on an object, after a second look where the first left it open: why it stayed unobserved, or where it
    /// stands if not at its place; both are noted in its evidence. `sights`: of all the survey's patches.
    pub fn judge(
        &self,
        object: u32,
        evidence: &mut Evidence,
        sights: &Sights,
        rule: &VerdictRule,
        interrupt: Interrupt,
    ) -> Result<Judged> {
        let question = evidence.model().question;
        let mut summary = evidence.summary(&question, rule, interrupt)?;
        let mut hidden_by = None;
        if summary.is_open() || summary.verdict == Verdict::Unobserved {
            self.look_again(object, |looked| {
                if summary.is_open() {
                    evidence.found = sights.far_face(evidence, looked, interrupt)?;
                }
                if evidence.found.is_some() {
                    summary = evidence.summary(&question, rule, interrupt)?;
                }
                if summary.verdict == Verdict::Unobserved {
                    (evidence.unseen, hidden_by) = sights.unseen(evidence, looked, interrupt)?;
                    summary.unseen = evidence.unseen;
                }
                Ok(())
            })?;
        }
        Ok(Judged { summary, hidden_by })
    }

    /// The evidence and the verdict about every object from patches in memory, in the objects' order; so many patches
    /// are unpacked at once.
    pub fn verified<P: AsRef<[u8]> + Sync>(
        &self,
        patches: &[P],
        at_once: usize,
        rule: &VerdictRule,
        threads: Threads,
        interrupt: Interrupt,
    ) -> Result<Vec<(Evidence, Judged)>> {
        let (evidence, sights) = self.evidence_and_sights(patches, at_once, threads, interrupt)?;
        let mut all: Vec<_> = (0..).zip(evidence).map(|(object, evidence)| (object, evidence, None)).collect();
        threads.for_each(&mut all, |(object, evidence, judged)| {
            *judged = Some(self.judge(*object, evidence, &sights, rule, interrupt)?);
            Ok(())
        })?;
        Ok(all.into_iter().filter_map(|(_, evidence, judged)| Some((evidence, judged?))).collect())
    }
}
