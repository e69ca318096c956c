//! One object of one scene under one delivery: what is right, what was said.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};
use asbuilt_core::evidence::Loa;
use asbuilt_core::verify::Verdict;

use super::fate::Deed;
use super::layout::Kind;
use super::patches::Delivery;
use super::right::Right;
use super::why::ReasonSaid;
use crate::case::{Estimate, Stated};

/// An object-case.
#[derive(Debug)]
pub struct Case {
    pub scene: usize,
    pub model: String,
    pub delivery: Delivery,
    /// GlobalId, IFC class and name of the object.
    pub id: String,
    pub class: String,
    pub name: String,
    pub kind: Kind,
    /// Whether any of it is of glass.
    pub glazed: bool,
    pub deed: Deed,
    /// Displacement on purpose, millimetres.
    pub displaced_mm: [f64; 3],
    pub loa: Loa,
    pub right: Right,
    pub said: Verdict,
    pub best_loa: Option<Loa>,
    pub coverage: f64,
    /// Confirmed, refuted, open.
    pub shares: Option<[f64; 3]>,
    /// As said, metres, with its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The same with the truth.
    pub true_deviation: Option<Estimate>,
    /// The name of who hides most of what is hidden, and of who shares most of what is shared.
    pub hidden_by: Option<String>,
    /// Why it is unobserved, as said, against the truth.
    pub reason: Option<ReasonSaid>,
    pub shared_with: Option<String>,
    pub stated: Vec<Stated>,
    /// What the verifier says why, where the verdict is wrong.
    pub account: Option<String>,
}

impl Case {
    /// Whether the verdict is right.
    pub fn is_right(&self) -> bool {
        self.right.verdicts.contains(&self.said)
    }

    /// Whether it is said to be absent, and is not.
    pub fn is_false_absent(&self) -> bool {
        self.said == Verdict::Absent && !self.is_right()
    }

    /// Whether it is said to be built, and is not.
    pub fn is_missing_confirmed(&self) -> bool {
        self.deed == Deed::Missing && self.said == Verdict::Confirmed
    }

    /// Whether an ideal observer could decide, and the verifier did not.
    pub fn is_declined(&self) -> bool {
        self.said == Verdict::Unobserved && !self.right.verdicts.contains(&Verdict::Unobserved)
    }

    fn right_names(&self) -> String {
        self.right.verdicts.iter().map(|v| v.name()).collect::<Vec<_>>().join("|")
    }

    fn line(&self) -> String {
        let [x, y, z] = self.displaced_mm;
        let text = |s: &str| format!("\"{}\"", s.replace('"', "'"));
        let [confirmed, refuted, open] = self.shares.unwrap_or([f64::NAN; 3]);
        let (deviation, sd) = self.deviation.unwrap_or((f64::NAN, f64::NAN));
        let truth = self.true_deviation.map_or(f64::NAN, |e| e.truth);
        let r = &self.right;
        let judged = u8::from(self.is_right());
        [
            format!("{},{},{},{judged}", self.scene, text(&self.model), self.delivery.name()),
            format!("{},{},{},{}", text(&self.id), self.class, text(&self.name), self.kind.name()),
            format!("{},{x:.1},{y:.1},{z:.1},{}", self.deed.name(), self.loa.name()),
            format!("{},{},{}", self.right_names(), self.said.name(), self.best_loa.map_or("-", Loa::name)),
            format!("{:.3},{confirmed:.3},{refuted:.3},{open:.3}", self.coverage),
            format!("{:.1},{:.1},{:.1}", deviation * 1e3, sd * 1e3, truth * 1e3),
            format!("{:.3},{:.3},{:.3},{:.1},{:.0}", r.seen, r.empty, r.shared, r.worst_m * 1e3, r.beams),
            self.reason.map_or("-,,,".into(), |r| {
                let hider = r.hider_is_right.map_or("", |is| if is { "1" } else { "0" });
                format!("{},{:.2},{:.2},{hider}", r.said.name(), r.share, r.largest)
            }),
            format!("{},{}", self.hidden_by.as_deref().map_or("-".into(), text), {
                self.shared_with.as_deref().map_or("-".into(), text)
            }),
        ]
        .join(",")
    }
}

const HEAD: &str = "scene,model,delivery,is_right,id,class,name,kind,done,dx_mm,dy_mm,dz_mm,loa,right,said,best_loa,\
    coverage,confirmed,refuted,open,deviation_mm,deviation_sd_mm,true_deviation_mm,seen_share,empty_share,\
    shared_share,worst_mm,beams,reason,reason_share,largest_share,hider_is_right,hidden_by,shared_with";

/// Writes a line for every case, the wrong ones first; and what is said of those.
pub fn write(path: &Path, cases: &[Case]) -> Result<()> {
    for case in cases {
        if let Some(account) = &case.account {
            println!("wrong: {} {} {} {}\n{account}", case.delivery.name(), case.id, case.name, case.deed.name());
        }
    }
    let mut out = format!("{HEAD}\n");
    for wanted in [false, true] {
        for case in cases.iter().filter(|c| c.is_right() == wanted) {
            let _ = writeln!(out, "{}", case.line());
        }
    }
    std::fs::write(path, out).with_context(|| format!("{}: cannot write", path.display()))
}
