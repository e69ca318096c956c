//! What is said of the objects of a survey, which know each other, after a second look.

use super::rule::{Verdict, VerdictRule};
use super::summary::Summary;
use crate::verify::collect::{SurveyObjects, Threads, Verifier};
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
        if summary.is_open() {
            self.look_again(object, |looked| {
                evidence.found = sights.far_face(evidence, looked, interrupt)?;
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
        let (mut out, mut sights) = (Vec::new(), Sights::default());
        for (round, batch) in self.batches().iter().enumerate() {
            let mut verifier = Verifier::new(self, batch, threads, interrupt)?;
            for some in patches.chunks(at_once.max(1)) {
                verifier.absorb(some, (round == 0).then_some(&mut sights), interrupt)?;
            }
            for (object, mut evidence) in verifier.into_evidence() {
                let judged = self.judge(object, &mut evidence, &sights, rule, interrupt)?;
                out.push((object, (evidence, judged)));
            }
        }
        out.sort_by_key(|(object, _)| *object);
        Ok(out.into_iter().map(|(_, verified)| verified).collect())
    }
}
