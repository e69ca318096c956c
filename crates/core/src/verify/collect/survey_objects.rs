//! All objects of a survey as they are drawn: who is whose neighbour, and which are one body drawn twice.

use std::sync::Arc;

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::drawn_object::DrawnObject;
use super::threads::Threads;
use crate::geometry::{Aabb, Solid, Vec3};
use crate::num::hilbert;
use crate::verify::aim::Target;
use crate::verify::evidence::Samples;
use crate::verify::model::EvidenceModel;
use crate::verify::sights::{Looked, Owner};
use crate::{Interrupt, Result, poll};

/// Objects that are worked on together have about as many samples: 240 MB.
const BATCH_SAMPLES: f64 = 20e6;
/// Objects farther apart than this do not claim each other's returns, metres: the widest search band and the claim.
const HALO_M: f64 = 0.35;
/// Drawn surfaces nearer than this are the same to a survey, metres.
const SAME_PLACE_M: f64 = 0.01;
/// Bodies are one where this share of the surface of each lies on the other.
const ONE_BODY: f64 = 0.95;
/// What hides an object is that object's which is drawn within this, metres.
const AS_BUILT_M: f64 = 0.1;
/// Places of a surface that are compared.
const COMPARED: f64 = 400.0;

/// Every object that was drawn.
#[derive(Debug)]
pub struct SurveyObjects {
    pub(super) drawn: Vec<Arc<DrawnObject>>,
    solids: Vec<Solid>,
    boxes: RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>,
    /// For each object the first of those that are one body with it.
    body: Vec<u32>,
}

/// Objects whose evidence is gathered together.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// These, by number.
    pub own: Vec<u32>,
    /// Those around them, that may have been met instead.
    pub around: Vec<u32>,
}

impl SurveyObjects {
    /// Makes all objects ready.
    pub fn new(objects: Vec<(Solid, EvidenceModel)>, threads: Threads, interrupt: Interrupt) -> Result<Self> {
        let drawn = threads.map(&objects, |(solid, model)| DrawnObject::new(solid, *model, interrupt).map(Arc::new))?;
        let boxed = |(i, o): (usize, &Arc<DrawnObject>)| {
            GeomWithData::new(Rectangle::from_corners(o.bounds.min, o.bounds.max), i as u32)
        };
        let boxes = RTree::bulk_load(drawn.iter().enumerate().map(boxed).collect());
        let solids = objects.into_iter().map(|(solid, _)| solid).collect();
        let body = (0..drawn.len() as u32).collect();
        let mut out = Self { drawn, solids, boxes, body };
        out.find_bodies(threads, interrupt)?;
        Ok(out)
    }

    /// Number of objects.
    pub fn len(&self) -> usize {
        self.drawn.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.drawn.is_empty()
    }

    pub(super) fn solid(&self, object: u32) -> &Solid {
        &self.solids[object as usize]
    }

    /// The first of the objects that are one body with this one; itself where none is.
    pub(super) fn body(&self, object: u32) -> u32 {
        self.body[object as usize]
    }

    /// Another object that is drawn at the very place of this one: the same body in two models.
    pub fn drawn_twice(&self, object: u32) -> Option<u32> {
        let first = self.body(object);
        let others = self.body.iter().enumerate().filter(|(i, body)| **body == first && *i as u32 != object);
        others.map(|(i, _)| i as u32).next()
    }

    /// The objects in batches of neighbours of some 20 million samples, whatever memory there is.
    pub fn batches(&self) -> Vec<Batch> {
        self.batches_of(BATCH_SAMPLES)
    }

    /// The same with so many samples, a number without unit. What is found out of an object does not depend on its batch.
    pub fn batches_of(&self, max_samples: f64) -> Vec<Batch> {
        let all = Aabb::around(&self.drawn.iter().map(|o| o.bounds.centre()).collect::<Vec<_>>());
        let cell = |o: &DrawnObject| {
            let scale = f64::from(1u32 << 20) / all.diagonal().max(1.0);
            let v = (o.bounds.centre() - Vec3::from(all.min)) * scale;
            hilbert::place_of::<21, 3>([v.x as u32, v.y as u32, v.z as u32])
        };
        let mut order: Vec<u32> = (0..self.drawn.len() as u32).collect();
        order.sort_by_key(|i| (cell(&self.drawn[*i as usize]), *i));
        let (mut groups, mut samples) = (vec![Vec::new()], 0.0);
        for i in order {
            let more = self.expected_samples(i);
            if samples > 0.0 && samples + more > max_samples {
                groups.push(Vec::new());
                samples = 0.0;
            }
            samples += more;
            groups.last_mut().expect("one at least").push(i);
        }
        groups.into_iter().map(|own| self.batch(own)).collect()
    }

    fn expected_samples(&self, object: u32) -> f64 {
        let spacing = self.drawn[object as usize].model.spacing;
        Samples::expected(self.solid(object), spacing)
    }

    fn batch(&self, mut own: Vec<u32>) -> Batch {
        own.sort_unstable();
        let near = own.iter().flat_map(|i| self.near(self.drawn[*i as usize].bounds.expanded(HALO_M)));
        let mut around: Vec<u32> = near.filter(|i| own.binary_search(i).is_err()).collect();
        around.sort_unstable();
        around.dedup();
        Batch { own, around }
    }

    /// The objects whose boxes meet a box.
    fn near(&self, bounds: Aabb) -> impl Iterator<Item = u32> {
        self.boxes.locate_in_envelope_intersecting(&AABB::from_corners(bounds.min, bounds.max)).map(|b| b.data)
    }

    /// Looks a second time at an object, beside all others.
    pub(in crate::verify) fn look_again(
        &self,
        object: u32,
        look: impl FnOnce(&Looked<'_>) -> Result<()>,
    ) -> Result<()> {
        let drawn = &self.drawn[object as usize];
        let owner = |met_world: &Vec3, direction: &Vec3| match self.owner(met_world, direction, AS_BUILT_M) {
            Some(owner) if self.body(owner) == self.body(object) => Owner::Own,
            Some(owner) => Owner::Other(owner),
            None => Owner::Nobody,
        };
        let is_anothers = |met_world: &Vec3, direction: &Vec3, within: f64| {
            let near = self.near_surfaces(met_world, direction, within);
            near.into_iter().any(|(_, i)| self.body(i) != self.body(object))
        };
        let Target { two_sided, has_optional, .. } = drawn.target;
        let extent = drawn.bounds.diagonal();
        look(&Looked { owner: &owner, is_anothers: &is_anothers, two_sided, has_optional, extent, model: &drawn.model })
    }

    /// The object drawn nearest to what a beam met, within `within` metres.
    fn owner(&self, met_world: &Vec3, direction: &Vec3, within: f64) -> Option<u32> {
        let near = self.near_surfaces(met_world, direction, within).into_iter();
        near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, i)| i)
    }

    /// The objects drawn within `within` metres of what a beam met, and how far away each is.
    fn near_surfaces(&self, met_world: &Vec3, direction: &Vec3, within: f64) -> Vec<(f64, u32)> {
        let place = Aabb::around(&[*met_world]).expanded(within);
        let distance =
            |i: u32| self.drawn[i as usize].target.met_part(met_world, direction, within).map(|(d, _)| (d, i));
        self.near(place).filter_map(distance).collect()
    }

    fn find_bodies(&mut self, threads: Threads, interrupt: Interrupt) -> Result<()> {
        let numbers: Vec<u32> = (0..self.drawn.len() as u32).collect();
        let first = threads.map(&numbers, |&i| {
            poll(interrupt)?;
            let bounds = self.drawn[i as usize].bounds;
            let mut before: Vec<u32> = self.near(bounds).filter(|j| *j < i && self.are_alike(i, *j)).collect();
            before.sort_unstable();
            for j in before {
                if self.lies_on(i, j, interrupt)? && self.lies_on(j, i, interrupt)? {
                    return Ok(j);
                }
            }
            Ok(i)
        })?;
        for (i, first) in first.into_iter().enumerate() {
            self.body[i] = self.body[first as usize];
        }
        Ok(())
    }

    /// Whether two boxes are one to a survey.
    fn are_alike(&self, i: u32, j: u32) -> bool {
        let [a, b] = [i, j].map(|k| &self.drawn[k as usize].bounds);
        let apart = |p: &[f64; 3], q: &[f64; 3]| p.iter().zip(q).any(|(x, y)| (x - y).abs() > 2.0 * SAME_PLACE_M);
        !apart(&a.min, &b.min) && !apart(&a.max, &b.max)
    }

    /// Whether nearly all of the surface of `i` lies on that of `j`.
    fn lies_on(&self, i: u32, j: u32, interrupt: Interrupt) -> Result<bool> {
        let (solid, target) = (self.solid(i), &self.drawn[j as usize].target);
        let samples = Samples::on(solid, (solid.area() / COMPARED).sqrt().max(1e-3), interrupt)?;
        let mut on = 0;
        for k in 0..samples.len() {
            poll(interrupt)?;
            on += usize::from(target.distance(&samples.position(k), SAME_PLACE_M).is_some());
        }
        Ok(on > 0 && on as f64 >= ONE_BODY * samples.len() as f64)
    }
}
