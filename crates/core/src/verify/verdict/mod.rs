//! What is said of an object: its verdict at a tolerance, and the numbers behind it.
//!
//! The counts of its faces ([`FaceReport`], [`Counts`]) make a `tally`, the tally a `reason`, the reason the
//! [`Verdict`]: `judgement` asks the tally's questions in order, and the first that holds is the reason; `thresholds`
//! has the numbers. [`Summary`] adds the finest class that holds, the deviation and the offset; `explain` says it in
//! words. An `inquiry` asks each place alone, and where few beams told of any, all of them together. Of one of many
//! objects a [`Judged`] is told, after a second look. Beside the object: the [`SampleBelief`] at each sample, the
//! [`Contribution`] of each station, and the evidence to be expected from a [`PlannedStation`].

mod belief;
mod best_loa;
mod contribution;
mod counts;
mod explain;
mod face_report;
mod forecast;
mod inquiry;
mod judged;
mod judgement;
mod reason;
mod rule;
mod summary;
mod tally;
mod thresholds;

pub use belief::SampleBelief;
pub use contribution::Contribution;
pub use counts::Counts;
pub use face_report::FaceReport;
pub use forecast::PlannedStation;
pub(in crate::verify) use inquiry::may_count_together;
pub use judged::Judged;
pub use rule::{Verdict, VerdictRule};
pub use summary::{Shares, Summary};
pub(in crate::verify) use thresholds::{CONFIDENCE_TOGETHER, MIN_INDEPENDENT, MIN_INDEPENDENT_TOGETHER, MIN_UNANIMOUS};
