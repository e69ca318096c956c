//! Whether model and scans are in one frame: what would otherwise leave every object `unobserved`, or confirm a floor that
//! happens to lie at the same height, is named, with the option that mends it.
//!
//! * [`hypothesis`]: what may be wrong: a unit, an axis, an offset;
//! * [`fit`]: how well boxes of patches and of objects lie on each other under it;
//! * [`diagnosis`]: what is said;
//! * [`check`]: asked of the database.

pub mod check;
mod diagnosis;
mod fit;
mod hypothesis;
