//! Small numerical tools. Read in this order:
//!
//! * [`text`]: shortest decimal and hexadecimal text;
//! * [`bytes`]: cursors that cannot read past the end;
//! * [`sections`]: stored values as containers of sections;
//! * [`words`]: parameters as named words, stored and as text;
//! * [`sort`]: long sorts that can be interrupted;
//! * [`piece_map`]: large maps no step of which is long;
//! * [`stats`]: order statistics, robust weights;
//! * [`scatter`]: places spread over a list;
//! * [`whole`]: the whole numbers beside a number;
//! * [`hilbert`]: cells along a space-filling curve;
//! * [`normal`]: the normal distribution;
//! * [`chi_square`]: the distribution of a sum of squares;
//! * [`eigen`]: eigenvalues in bounded time.

pub mod bytes;
pub mod chi_square;
pub(crate) mod eigen;
pub(crate) mod hilbert;
pub mod normal;
pub(crate) mod piece_map;
pub mod scatter;
pub(crate) mod sections;
pub mod sort;
pub mod stats;
pub mod text;
pub(crate) mod whole;
pub mod words;
