//! Small numerical tools: [`normal`] and [`chi_square`] distribution, order [`stats`], interruptible [`sort`], bounded `eigen`values, [`bytes`] cursors,
//! stored values as [`sections`] or [`words`], decimal and hexadecimal [`text`].

pub mod bytes;
pub mod chi_square;
pub(crate) mod eigen;
pub mod normal;
pub(crate) mod sections;
pub mod sort;
pub mod stats;
pub mod text;
pub mod words;
