//! What is stored about a solid: samples on its faces, and by station the sums of what was met around them.
//!
//! [`Samples`] are spread over the solid once (`spread`). A [`StationEvidence`] holds its sums by blocks of samples.
//! [`Evidence`] is both with the parameters: a value that is merged, and written and read as bytes (`write`, `read`).

mod header;
mod read;
mod samples;
mod spread;
mod station;
mod value;
mod write;

pub use header::EvidenceHeader;
pub use samples::Samples;
pub(super) use samples::{BLOCK, SampleBlock};
pub use station::{StationEvidence, StationOrigin};
pub use value::Evidence;
