//! The thresholds of an object's change.

/// Least number of samples that say something in both epochs before anything is said of the object.
pub const MIN_COMPARED: u64 = 10;
/// They are at least this share of the object's samples.
pub const MIN_COMPARED_SHARE: f64 = 0.01;
/// Where the object shows at less than this share of the compared samples, in either epoch, it stands in neither.
pub const MIN_SHOWN: f64 = 0.15;
/// Share of the samples where the object shows in either epoch that must have lost it before it is gone, or won it
/// before it appeared.
pub const MIN_WHOLE: f64 = 0.75;
/// An object of which less than this share was lost or won is all there.
pub const MIN_PART: f64 = 0.15;
/// One that lost and won at least this share each left one place for another.
pub const MIN_LEFT: f64 = 0.25;
/// Share of those samples that must have been displaced before the object moved as one that tilts or bends does.
pub const MIN_DISPLACED: f64 = 0.3;
/// Deviations of one surface in two epochs differ by no more than this many of their σ.
pub const SAME_SIGMAS: f64 = 3.3;
/// Nor by more than this where they are precise: surfaces are rough, and edges are sampled by few beams, metres.
pub const SAME_PLACE_M: f64 = 0.003;
/// Probability of so large a displacement by chance below which an object has moved.
pub const MAX_CHANCE: f64 = 1e-4;
/// No object has moved by less than this many standard deviations of registration.
pub const MIN_REGISTRATION_SIGMAS: f64 = 3.0;
/// A face needs this many samples that show the object in both epochs to have a say in how far it moved.
pub const MIN_SAMPLES_OF_FACE: usize = 10;
