//! Where a scanner stood: what the file says, what the user says, and whether it can be true.
//!
//! * [`choice`]: the option `--origins`;
//! * [`listing`]: a text with the places of several scanners;
//! * [`attribution`]: which points belong to which of them;
//! * [`place`]: a scan gets its origin, or loses it;
//! * [`recovery`]: the origin from the order of the points;
//! * [`passing`]: how many beams pass between nearer returns;
//! * [`judge`]: whether a scanner can have stood there;
//! * [`settle`]: all of it in turn, for every scan of a file.

mod attribution;
mod choice;
mod judge;
mod listing;
mod passing;
mod place;
mod recovery;
mod settle;

pub use choice::OriginsChoice;
pub use judge::IdentityPose;
pub(crate) use listing::Listing;
pub use place::OriginSource;
pub use settle::Settler;
