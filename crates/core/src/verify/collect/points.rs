//! Adding points that no beam was aimed with: clouds without origin, tie points, and what stands beside a slim solid.

use super::collector::Collector;
use super::point_index::LocalPoint;
use crate::geometry::{Aabb, Vec3};
use crate::scan::{Beam, Patch, PatchHeader, RangeImage};
use crate::uncertain::UncertainPoint;
use crate::verify::aim::{BeamCrossing, NearFace, OtherObjects};
use crate::verify::evidence::{Evidence, StationOrigin};
use crate::verify::model::{BeamModel, BeamOutcome, PointTouch, may_be_anothers, with_model};
use crate::{Interrupt, Result, poll};

/// A point whose own standard deviation along the normal is more than this part of the search band tells nothing: where
/// in the band it lies would be chance.
const MAX_SD: f64 = 0.5;
/// The station number of tie points; their cameras tell themselves apart by their places.
const TIE_POINTS: i64 = 0;

impl Collector {
    /// Adds what an uncertain point (a tie point) tells that cameras saw: a surface at its place, once, however many
    /// cameras there were, and empty space along their rays, one weight shared out among them.
    pub fn absorb_tie_point(&mut self, point: &UncertainPoint, cameras: &[Vec3], interrupt: Interrupt) -> Result<()> {
        with_model!(self.evidence.model.kind, M => self.absorb_tie_point_with::<M>(point, cameras, interrupt))
    }

    fn absorb_tie_point_with<M: BeamModel>(
        &mut self,
        point: &UncertainPoint,
        cameras: &[Vec3],
        interrupt: Interrupt,
    ) -> Result<()> {
        let spacing = self.evidence.model.spacing;
        if !M::RAYS_TELL_OF_THEIR_END || cameras.is_empty() {
            let position_local = point.position - self.evidence.samples.reference;
            let local = LocalPoint { position_local, covariance: point.covariance, spacing };
            let face = self.drawn.near_face(&point.position).filter(|face| self.tells(point, face));
            self.absorb_points::<M>(face.map(|face| (local, face)).into_iter(), TIE_POINTS, interrupt)?;
        }
        let share = 1.0 / cameras.len().max(1) as f32;
        for camera in cameras {
            let beam = Beam { offset: point.position - camera, returned: true };
            let step = (spacing / beam.offset.norm().max(spacing)).max(1e-7);
            let patch = Patch::encode(TIE_POINTS, *camera, step, Patch::QUANTUM_M, &[beam])?;
            if self.concerns(patch.header()) {
                let view = RangeImage::new(patch.header().clone(), &[beam]);
                // Only what a ray passed through: its end was added above.
                let seen_through = |outcome| match outcome {
                    BeamOutcome::SeenThrough { weight } => Some(BeamOutcome::SeenThrough { weight: weight * share }),
                    BeamOutcome::Surface { .. } => None,
                };
                self.absorb_view::<M>(&view, StationOrigin::At(*camera), seen_through, interrupt)?;
            }
        }
        Ok(())
    }

    /// Whether a point is known well enough to say where in the search band it lies.
    fn tells(&self, point: &UncertainPoint, face: &NearFace) -> bool {
        face.normal.dot(&(point.covariance * face.normal)).max(0.0).sqrt() <= MAX_SD * self.drawn.model.band()
    }

    /// Adds the points near a face that no other object explains.
    pub(super) fn absorb_cloud<M: BeamModel>(
        &mut self,
        header: &PatchHeader,
        points: &[Vec3],
        near: &[(u32, NearFace)],
        others: Option<OtherObjects<'_>>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let (origin_local, model) = (header.origin - self.evidence.samples.reference, self.evidence.model);
        let spacing = header.spacing.distance().max(1e-4);
        let may_be_own = |i: u32, face: &NearFace| {
            others.is_none_or(|o| !may_be_anothers(face.deviation(), o.deviation(i as usize), &model))
        };
        let own = near.iter().filter(|(i, face)| may_be_own(*i, face));
        let points = own.map(|(i, face)| (LocalPoint::exact(points[*i as usize] + origin_local, spacing), *face));
        self.absorb_points::<M>(points, header.station, interrupt)
    }

    fn absorb_points<M: BeamModel>(
        &mut self,
        points: impl Iterator<Item = (LocalPoint, NearFace)>,
        id: i64,
        interrupt: Interrupt,
    ) -> Result<()> {
        self.point_index(interrupt)?;
        let Self { evidence, point_index, .. } = self;
        let Some(index) = point_index.get() else { return Ok(()) };
        let model = evidence.model;
        let number = evidence.station_index(id, StationOrigin::Unknown);
        let Evidence { samples, stations, .. } = evidence;
        let station = &mut stations[number];
        for (i, (point, face)) in points.enumerate() {
            if i % 64 == 0 {
                poll(interrupt)?;
            }
            index.gather(samples, &point, &face, |block, k, touch| {
                let len = samples.blocks[block as usize].len;
                M::add_point(touch, &model, &mut station.block(block, len)[k]);
            });
        }
        if station.blocks.is_empty() {
            stations.remove(number);
        }
        self.evidence.check_size()
    }

    /// Adds the returns beside a slim solid that no other object explains: each counts for the face nearest to it.
    pub(super) fn absorb_beside<M: BeamModel>(
        &mut self,
        view: &RangeImage,
        crossings: &[BeamCrossing],
        others: OtherObjects<'_>,
        interrupt: Interrupt,
    ) -> Result<()> {
        self.point_index(interrupt)?;
        let Self { evidence, point_index, drawn, .. } = self;
        let Some(index) = point_index.get() else { return Ok(()) };
        let model = evidence.model;
        let (header, band) = (&view.header, model.band_in_front());
        let around = evidence.bounds.expanded(band);
        let number = evidence.station_index(header.station, StationOrigin::At(header.origin));
        let Evidence { samples, stations, .. } = evidence;
        let station = &mut stations[number];
        let scanner_local = header.origin - samples.reference;
        let (min, max) = view.rectangle_around(&around.corners().map(|c| c - header.origin));
        for (i, slot) in view.slots_in(min, max).flatten().enumerate() {
            if i % 1024 == 0 {
                poll(interrupt)?;
            }
            let Some(met_world) = met_beside(view, slot, crossings, &around) else { continue };
            let spacing = view.step() * view.ranges[slot];
            let point = LocalPoint::exact(met_world - samples.reference, spacing);
            let near = drawn.target.near_face(&met_world, band).filter(|face| face.height.abs() <= band);
            let Some(face) = near else { continue };
            if may_be_anothers(face.height, others.deviation(slot), &model) {
                continue;
            }
            index.gather(samples, &point, &face, |block, k, touch| {
                let len = samples.blocks[block as usize].len;
                M::add_point(&towards(touch, &scanner_local), &model, &mut station.block(block, len)[k]);
            });
            station.step = station.step.max(view.step() as f32);
        }
        stations.retain(|s| !s.blocks.is_empty());
        self.evidence.check_size()
    }
}

/// What a beam met within the box around an object without being aimed at it.
fn met_beside(view: &RangeImage, slot: usize, crossings: &[BeamCrossing], around: &Aabb) -> Option<Vec3> {
    let met_world = view.directions[slot] * view.ranges[slot] + view.header.origin;
    let is_aimed = || crossings.binary_search_by_key(&slot, |c| c.slot as usize).is_ok();
    let is_beside = !view.ranges[slot].is_infinite() && around.holds(&met_world) && !is_aimed();
    is_beside.then_some(met_world)
}

/// The same touch, its deviation counted towards the scanner as sums are.
fn towards(touch: &PointTouch, scanner_local: &Vec3) -> PointTouch {
    let sight = touch.sample_local - scanner_local;
    let looks_away = sight.dot(&touch.normal) > 0.0;
    PointTouch { deviation: if looks_away { -touch.deviation } else { touch.deviation }, ..*touch }
}
