//! Small numerical tools: [`normal`] distribution, [`bytes`] cursors, decimal and hexadecimal [`text`].

pub mod bytes;
pub mod normal;
pub mod stats;
pub mod text;
