//! What a survey would prove, before anyone scans.

pub mod next;
pub mod room;
