//! Small numerical tools: [`normal`] distribution, order [`stats`], interruptible [`sort`], [`bytes`] cursors, decimal
//! and hexadecimal [`text`].

pub mod bytes;
pub mod normal;
pub mod sort;
pub mod stats;
pub mod text;
