//! The thresholds of a verdict, beside those that [`VerdictRule`](super::VerdictRule) leaves to the user.

/// Least number of seen samples for a verdict.
pub const MIN_SEEN: u64 = 5;
/// Share of the decided samples that must have been seen empty before the object is absent: more than half, for the
/// lee side of a displaced object is empty too.
pub const MIN_EMPTY: f64 = 0.6;
/// It is not absent where as much of the decided shows the object's own surface, in place or not: it was built in part,
/// or displaced by more than it is thick.
pub const MAX_ON_SURFACE_OF_ABSENT: f64 = 0.2;
/// A slim object stands beside its place when something was met before so many times as many samples as were seen empty:
/// before one that stands there it is, before one that is gone its neighbour may be.
pub const MIN_BESIDE: f64 = 1.2;
/// Least share of the seen samples that must say something; below it everything is open.
pub const MIN_DECIDED: f64 = 0.2;
/// Least share of the seen samples that must speak for the object before it is confirmed, where its surface as a whole
/// is not known.
pub const MIN_CONFIRMED_OF_SEEN: f64 = 0.5;
/// Least number of samples' worth of independent measurements that must show the object before it is confirmed: some
/// twenty beams.
pub const MIN_INDEPENDENT: f64 = 2.0;
/// A place that few beams told of counts from this belief on, where its object's places are counted together: one beam
/// within half a spacing.
pub const CONFIDENCE_TOGETHER: f64 = 0.6;
/// Of these places so many must say the same.
pub const MIN_UNANIMOUS: f64 = 0.8;
/// And so many samples' worth of independent measurements: some 36 beams.
pub const MIN_INDEPENDENT_TOGETHER: f64 = 4.0;
/// A surface counts as well seen with this share of the object's samples that have one.
pub const WELL_SEEN_SHARE: f64 = 0.03;
/// It must have at least as many.
pub const WELL_SEEN_SAMPLES: u64 = 10;
/// Share of every well-seen surface that must keep the tolerance (USIBD, Level of Accuracy Specification: 95 % of the
/// deviations), for a class and for any other tolerance.
pub const MIN_WITHIN: f64 = 0.95;
/// Least share of the decided samples that must show the object in place, however strict the rule is about where its
/// surfaces are: openings and furniture take the rest.
pub const MIN_PRESENT: f64 = 0.6;
/// A smooth surface with this share of the seen samples can condemn the object by being seen through.
pub const LARGE_SHARE: f64 = 0.1;
/// Of a surface that condemns the object at least this share of the seen is decided, and more of that seen through.
pub const MIN_SEEN_THROUGH: f64 = 0.5;
/// A face is certainly off when its deviation is this many σ: the largest of several that are not seldom is.
pub const CERTAINLY_OFF: f64 = 3.0;
/// Part of the confidence that suffices for "in front" once the whole surface agrees: by itself it is discounted.
pub const IN_FRONT_SHARE: f64 = 0.8;
