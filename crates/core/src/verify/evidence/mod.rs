//! What is stored about a solid: samples on its faces, and by station the sums of what was met around them.
//!
//! [`Samples`] are spread over the solid once (`spread`). A [`StationEvidence`] holds its sums by blocks of samples.
//! [`Unseen`] says why an object stayed unobserved, a [`FoundFace`] where it stands instead of its place. [`Evidence`] is
//! all of it with the parameters: a value that is merged, and written and read as bytes (`write`, `read`).

mod found_face;
mod header;
mod read;
mod samples;
mod spread;
mod station;
mod unseen;
mod value;
mod write;

pub use found_face::FoundFace;
pub use header::EvidenceHeader;
pub use samples::Samples;
pub(super) use samples::{BLOCK, SampleBlock};
pub use station::{StationEvidence, StationOrigin};
pub use unseen::{Unseen, Why};
pub use value::Evidence;
