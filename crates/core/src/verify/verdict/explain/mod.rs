//! Why a verdict is what it is.
//!
//! [`Finding`]s are the facts, each with its numbers and in no language; a [`Cause`] is the one that decided; `english`
//! makes sentences of them that can be forwarded as they are.

mod cause;
mod english;
mod finding;

use finding::Finding;

use super::VerdictRule;
use crate::verify::evidence::Evidence;
use crate::verify::model::Question;
use crate::{Interrupt, Result};

impl Evidence {
    /// Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer class holds.
    pub fn explain(&self, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<String> {
        let findings = Finding::all(self, question, rule, interrupt)?;
        Ok(findings.iter().map(english::sentence).collect::<Vec<_>>().join("\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::{Solid, Vec3};
    use crate::scan::{Beam, Patch};
    use crate::verify::{Collector, EvidenceModel};

    /// A wall 4 m away, met by each station where its number says, metres.
    fn explained(met: &[f64]) -> String {
        let wall = Solid::cuboid([4.0, -0.5, -0.5], [4.2, 0.5, 0.5]).unwrap();
        let mut collector = Collector::new(&wall, EvidenceModel::default(), NEVER).unwrap();
        for (station, x) in met.iter().enumerate() {
            let end = |i: i32| Vec3::new(*x, f64::from(i % 60) * 0.02 - 0.6, f64::from(i / 60) * 0.02 - 0.6);
            let beams: Vec<Beam> = (0..3600).map(|i| Beam { offset: end(i), returned: true }).collect();
            let patch = Patch::encode(station as i64, Vec3::zeros(), 5e-3, 1e-4, &beams).unwrap();
            collector.absorb(&patch.to_bytes(), NEVER).unwrap();
        }
        collector.evidence().explain(&Question::default(), &VerdictRule::default(), NEVER).unwrap()
    }

    /// Nothing that an explanation says stands against its verdict.
    #[test]
    fn what_is_said_fits_the_verdict() {
        let as_drawn = explained(&[4.0]);
        assert!(
            as_drawn.contains("Confirmed, because at least 95 %") && as_drawn.contains("finest class"),
            "{as_drawn}"
        );
        let off = explained(&[4.03]);
        assert!(off.contains("; it lies 30.0 mm inside the drawing (σ"), "{off}");
        for (met, begins, because) in [
            (&[4.0, 4.6][..], "Conflicting at LOA30", "because its stations contradict each other"),
            (&[4.6, 4.6], "Absent at LOA30", "Absent, because 100 % of the places"),
            (&[2.0], "Unobserved at LOA30", "Unobserved, because none of its surface was seen"),
            (&[], "Unobserved at LOA30", "Unobserved, because none of its surface was seen"),
        ] {
            let text = explained(met);
            assert!(text.starts_with(begins) && text.contains(because), "{text}");
            assert!(!text.contains("finest class") && !text.contains("is not claimed"), "{text}");
        }
    }
}
