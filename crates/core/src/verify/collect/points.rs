//! Adding points that no beam was aimed with: clouds without origin, tie points, and what stands beside a slim solid.

use nalgebra::Matrix3;

use super::collector::Collector;
use super::point_index::{LocalPoint, PointIndex};
use crate::geometry::{Aabb, Vec3};
use crate::scan::{Beam, Patch, PatchHeader, RangeImage};
use crate::uncertain::UncertainPoint;
use crate::verify::aim::{BeamCrossing, OtherObjects, image_rectangle};
use crate::verify::evidence::{Evidence, Samples, StationOrigin};
use crate::verify::model::{BeamModel, BeamOutcome, PointTouch, may_be_anothers, with_model};
use crate::{Interrupt, Result, poll};

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
            self.absorb_points::<M>(&[local], TIE_POINTS, interrupt)?;
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

    pub(super) fn absorb_cloud<M: BeamModel>(
        &mut self,
        header: &PatchHeader,
        returns: &[Vec3],
        interrupt: Interrupt,
    ) -> Result<()> {
        let origin_local = header.origin - self.evidence.samples.reference;
        let spacing = header.spacing.distance().max(1e-4);
        let point = |p: &Vec3| LocalPoint { position_local: p + origin_local, covariance: Matrix3::zeros(), spacing };
        let points: Vec<LocalPoint> = returns.iter().map(point).collect();
        self.absorb_points::<M>(&points, header.station, interrupt)
    }

    fn absorb_points<M: BeamModel>(&mut self, points: &[LocalPoint], id: i64, interrupt: Interrupt) -> Result<()> {
        let Self { evidence, point_index, .. } = self;
        let index = made(point_index, &evidence.samples, interrupt)?;
        let model = evidence.model;
        let bands = (model.band_in_front(), model.band_behind());
        let number = evidence.station_index(id, StationOrigin::Unknown);
        let Evidence { samples, stations, .. } = evidence;
        let station = &mut stations[number];
        for (i, point) in points.iter().enumerate() {
            if i % 64 == 0 {
                poll(interrupt)?;
            }
            index.gather(samples, point, bands, |block, k, touch| {
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
        let Self { evidence, point_index, .. } = self;
        let index = made(point_index, &evidence.samples, interrupt)?;
        let model = evidence.model;
        let (header, band) = (&view.header, model.band_in_front());
        let around = evidence.bounds.expanded(band);
        let number = evidence.station_index(header.station, StationOrigin::At(header.origin));
        let Evidence { samples, stations, .. } = evidence;
        let station = &mut stations[number];
        let scanner_local = header.origin - samples.reference;
        let (min, max) = image_rectangle(view, &around.corners().map(|c| c - header.origin));
        for (i, slot) in view.slots_in(min, max).flatten().enumerate() {
            if i % 1024 == 0 {
                poll(interrupt)?;
            }
            let Some(met_world) = met_beside(view, slot, crossings, &around) else { continue };
            let spacing = view.step_at(slot) * view.ranges[slot];
            let position_local = met_world - samples.reference;
            let point = LocalPoint { position_local, covariance: Matrix3::zeros(), spacing };
            index.gather(samples, &point, (band, band), |block, k, touch| {
                if !may_be_anothers(touch.deviation.abs(), others.distance(slot), &model) {
                    let len = samples.blocks[block as usize].len;
                    M::add_point(&towards(touch, &scanner_local), &model, &mut station.block(block, len)[k]);
                }
            });
            station.step = station.step.max(view.step_at(slot) as f32);
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

fn made<'a>(index: &'a mut Option<PointIndex>, samples: &Samples, interrupt: Interrupt) -> Result<&'a PointIndex> {
    match index {
        Some(index) => Ok(index),
        None => Ok(index.insert(PointIndex::of(samples, interrupt)?)),
    }
}
