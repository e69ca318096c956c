//! Where the scanner stood, from the points of its scan alone.
//!
//! A tripod's scanner turns a mirror while its head rotates about its standing axis. So the points of one turn of the
//! mirror lie in a plane that contains the axis (Lichti 2007, "Error modelling, calibration and analysis of an AM–CW
//! terrestrial laser scanner system", ISPRS J. 62), and follow each other by equal angles. Where a file holds all
//! points of one station in the order in which they were measured, the planes meet in the axis, and the equal angles
//! tell the place on it:
//!
//! * [`sequence`]: points in the order of measurement;
//! * [`jackknife`]: least squares, and how well their result is known (Kott 2001, "The delete-a-group jackknife", J. Official
//!   Statistics 17);
//! * [`chords`]: a first axis, from lines through points that follow each other;
//! * [`lines`]: the sequence cut into scan lines;
//! * [`axis`]: the line in which the planes of the scan lines meet, with its tilt, by robust least squares;
//! * [`height`]: the place on the axis from which the steps of a scan line are equal angles;
//! * [`recover`]: all of it, and the proof.
//!
//! Assumed is that the axis stands within a few degrees of the vertical, and that a scan line has a mirror's, not a
//! camera's steps. Clouds for which this does not hold (thinned, merged, sorted, photogrammetry) are told, not guessed
//! at: [`NotRecovered`].

mod axis;
mod chords;
mod height;
mod jackknife;
mod lines;
mod recover;
mod sequence;

pub use recover::{NotRecovered, RecoveredOrigin, recover};
