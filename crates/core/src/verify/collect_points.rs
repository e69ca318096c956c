//! Adding points that no beam was aimed with: clouds without origin, tie points, and what stands beside a slim solid.

use nalgebra::Matrix3;

use super::collect::Collector;
use super::crossing::{Crossing, image_rectangle};
use super::encounter::{self, Seen};
use super::evidence::{Evidence, Place};
use super::model::ModelKind;
use super::point_index::{LocalPoint, PointIndex};
use super::sample::Samples;
use super::{ray_sums, surface_sums};
use crate::geometry::Vec3;
use crate::scan::{Beam, Header, Patch, View};
use crate::uncertain::Point;
use crate::{Interrupt, Result, poll};

/// The station number of tie points; their cameras tell themselves apart by their places.
const TIE_POINTS: i64 = 0;

impl Collector {
    pub(super) fn absorb_cloud(&mut self, header: &Header, returns: &[Vec3], interrupt: Interrupt) -> Result<()> {
        let shift = header.origin - self.evidence.samples.reference;
        let spacing = f64::from(header.step).max(1e-4);
        let point = |p: &Vec3| LocalPoint { position: p + shift, covariance: Matrix3::zeros(), spacing };
        let points: Vec<LocalPoint> = returns.iter().map(point).collect();
        self.absorb_points(&points, header.station, interrupt)
    }

    /// Adds what an uncertain point (a tie point) says that cameras saw: a surface at its place, once, however many
    /// cameras there were, and empty space along their rays, one weight shared out among them.
    pub fn absorb_tie_point(&mut self, point: &Point, cameras: &[Vec3], interrupt: Interrupt) -> Result<()> {
        let spacing = self.evidence.model.spacing;
        let position = point.position - self.evidence.samples.reference;
        let local = LocalPoint { position, covariance: point.covariance, spacing };
        if self.evidence.model.kind == ModelKind::Surface || cameras.is_empty() {
            self.absorb_points(&[local], TIE_POINTS, interrupt)?;
        }
        let share = 1.0 / cameras.len().max(1) as f32;
        for camera in cameras {
            let beam = Beam { offset: point.position - camera, returned: true };
            let step = (spacing / beam.offset.norm().max(spacing)).max(1e-7);
            let patch = Patch::encode(TIE_POINTS, *camera, step, Patch::QUANTUM_M, &[beam])?;
            if self.concerns(patch.header()) {
                let view = View::new(patch.header().clone(), &[beam]);
                // Only what a ray pierced: its end speaks for itself.
                let pierced = |seen| match seen {
                    Seen::Through(weight) => Some(Seen::Through(weight * share)),
                    Seen::Surface(..) => None,
                };
                self.absorb_view(&view, Place::At(*camera), pierced, interrupt)?;
            }
        }
        Ok(())
    }

    fn absorb_points(&mut self, points: &[LocalPoint], id: i64, interrupt: Interrupt) -> Result<()> {
        let Self { evidence, point_index, .. } = self;
        let index = made(point_index, &evidence.samples, interrupt)?;
        let model = evidence.model;
        let rays = model.ray_model();
        let station = evidence.station_index(id, Place::Unknown);
        let Evidence { samples, stations, .. } = evidence;
        let own = &mut stations[station];
        for (i, point) in points.iter().enumerate() {
            if i % 64 == 0 {
                poll(interrupt)?;
            }
            index.gather(samples, point, (model.band_in_front(), model.band_behind()), |touch| {
                let block = samples.blocks[touch.block as usize];
                let sums = &mut own.block(touch.block, block.len)[touch.k];
                match model.kind {
                    ModelKind::Surface => {
                        surface_sums::add_point(touch.weight, touch.deviation, touch.variance, sums);
                    }
                    ModelKind::Meyer2022 => {
                        let query = samples.local(block.start as usize + touch.k);
                        let normal = &samples.normals[block.face as usize];
                        let mass = rays.dense_point_mass(&point.position, normal, &query);
                        ray_sums::add_mass(&mass.discounted(model.reliability), sums);
                    }
                }
            });
        }
        if own.blocks.is_empty() {
            stations.remove(station);
        }
        self.evidence.check_size()
    }

    /// Adds the returns beside a slim solid that no other object explains: each speaks for the face nearest to it.
    pub(super) fn absorb_beside(
        &mut self,
        view: &View,
        crossings: &[Crossing],
        others: &dyn Fn(usize) -> f64,
        interrupt: Interrupt,
    ) -> Result<()> {
        let Self { evidence, point_index, .. } = self;
        let index = made(point_index, &evidence.samples, interrupt)?;
        let model = evidence.model;
        let (header, band) = (&view.header, (model.band_in_front(), model.band_in_front()));
        let around = evidence.bounds.expanded(band.0);
        let station = evidence.station_index(header.station, Place::At(header.origin));
        let Evidence { samples, stations, .. } = evidence;
        let scanner = header.origin - samples.reference;
        let (min, max) = image_rectangle(view, &around.corners().map(|c| c - header.origin));
        for (i, slot) in view.slots_in(min, max).flatten().enumerate() {
            if i % 1024 == 0 {
                poll(interrupt)?;
            }
            let met = view.directions[slot] * view.ranges[slot] + header.origin;
            let aimed = || crossings.binary_search_by_key(&slot, |c| c.slot as usize).is_ok();
            if view.ranges[slot].is_infinite() || !around.holds(&met) || aimed() {
                continue;
            }
            let spacing = f64::from(header.step) * view.ranges[slot];
            let position = met - samples.reference;
            let point = LocalPoint { position, covariance: Matrix3::zeros(), spacing };
            let station = &mut stations[station];
            index.gather(samples, &point, band, |touch| {
                if encounter::may_be_anothers(touch.deviation.abs(), others(slot), &model) {
                    return;
                }
                let block = samples.blocks[touch.block as usize];
                let sums = station.block(touch.block, block.len);
                // Sums count towards the scanner.
                let sight = samples.local(block.start as usize + touch.k) - scanner;
                let away = sight.dot(&samples.normals[block.face as usize]) > 0.0;
                let deviation = if away { -touch.deviation } else { touch.deviation };
                surface_sums::add_point(touch.weight, deviation, touch.variance, &mut sums[touch.k]);
            });
            station.step = station.step.max(header.step);
        }
        stations.retain(|s| !s.blocks.is_empty());
        self.evidence.check_size()
    }
}

fn made<'a>(index: &'a mut Option<PointIndex>, samples: &Samples, interrupt: Interrupt) -> Result<&'a PointIndex> {
    match index {
        Some(index) => Ok(index),
        None => Ok(index.insert(PointIndex::of(samples, interrupt)?)),
    }
}
