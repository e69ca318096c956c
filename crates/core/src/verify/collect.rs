//! Adding patches to the evidence about one solid.

use super::claims::Claims;
use super::crossing::Crossing;
use super::encounter::{self, Encounters, Seen};
use super::evidence::{Evidence, Place};
use super::model::{EvidenceModel, ModelKind};
use super::point_index::PointIndex;
use super::sample::{BLOCK, Block, Samples};
use super::sums::Sums;
use super::surface_sums::KERNEL_SPACINGS;
use super::target::Target;
use super::unpacked::{Aim, Beams, Unpacked};
use super::{ray_sums, surface_sums};
use crate::geometry::{Solid, Vec3};
use crate::scan::{Header, Origins, View};
use crate::{Interrupt, Result, poll};

/// Evidence in the making: the value, and the solid made ready for beams.
#[derive(Debug)]
pub struct Collector {
    pub(super) evidence: Evidence,
    target: Target,
    /// Ball (local centre, radius) around each block of samples.
    balls: Vec<(Vec3, f64)>,
    /// Made when the first point without a beam comes.
    pub(super) point_index: Option<PointIndex>,
    /// Displaced by its own thickness, no beam aimed at it meets it.
    is_slim: bool,
}

impl Collector {
    /// Spreads samples over the solid; no patch has spoken yet.
    pub fn new(solid: &Solid, mut model: EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let samples = Samples::on(solid, model.spacing, interrupt)?;
        // What the value says of itself; beyond the parameter's range only on objects of 500 km².
        model.spacing = Samples::effective_spacing(solid, model.spacing).min(EvidenceModel::MAX_SPACING_M);
        let balls = samples.balls(interrupt)?;
        let fingerprint = solid.fingerprint(interrupt)?;
        let (bounds, stations) = (solid.bounds(), Vec::new());
        let evidence = Evidence { model, fingerprint, bounds, samples, knows_neighbours: false, stations };
        let is_slim = evidence.samples.is_slim();
        Ok(Self { evidence, target: Target::new(solid, interrupt)?, balls, point_index: None, is_slim })
    }

    /// Says that beams which other objects explain are left out of all that comes.
    pub(super) fn know_neighbours(&mut self) {
        self.evidence.knows_neighbours = true;
    }

    /// The evidence so far.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }

    /// Gives up the evidence.
    pub fn into_evidence(self) -> Evidence {
        self.evidence
    }

    /// Adds evidence from another collector of the same solid.
    pub fn merge(&mut self, other: &Evidence, interrupt: Interrupt) -> Result<()> {
        self.evidence.merge(other, interrupt)
    }

    /// Whether a patch can say anything, by its header alone.
    pub fn concerns(&self, header: &Header) -> bool {
        let bounds = &self.evidence.bounds;
        match header.origins() {
            Origins::One => {}
            Origins::Each => return header.hull.overlaps(bounds),
            Origins::Unknown => {
                let reach = self.evidence.model.band_behind() + KERNEL_SPACINGS * f64::from(header.step);
                return header.points.expanded(reach).overlaps(bounds);
            }
        }
        let offset = bounds.centre() - header.origin;
        let radius = 0.5 * bounds.diagonal();
        offset.norm() - radius <= self.reach(header)
            && header.cone.meets_ball(&offset, radius + self.kernel_radius(), self.margin(header))
    }

    /// Adds what a packed patch says. Points without origin speak for the face nearest to them, and never of empty
    /// space.
    pub fn absorb(&mut self, patch: &[u8], interrupt: Interrupt) -> Result<()> {
        if !self.concerns(&Header::read(patch)?) {
            return Ok(());
        }
        let patch = Unpacked::of(patch, self.evidence.model.intensity.is_some())?;
        let aim = self.aim(&patch, interrupt)?;
        self.absorb_aimed(&patch, &aim, None, interrupt)
    }

    /// Where the beams of a patch from one place would cross the solid.
    pub(super) fn aim(&self, patch: &Unpacked, interrupt: Interrupt) -> Result<Aim> {
        if !self.concerns(&patch.header) {
            return Ok(Aim::Aside);
        }
        match (&patch.beams, self.evidence.model.kind) {
            (Beams::FromOne(view), ModelKind::Surface) => {
                let crossings = self.target.crossings(view, self.reach(&view.header), interrupt)?;
                Ok(if crossings.is_empty() && !self.is_slim { Aim::Aside } else { Aim::At(crossings) })
            }
            _ => Ok(Aim::Unknown),
        }
    }

    /// Claims for this solid, number `object`, the beams of the patch that met something near where it is drawn.
    pub(super) fn claim(&self, patch: &Unpacked, aim: &Aim, object: u32, claims: &mut Claims) {
        if let (Beams::FromOne(view), Aim::At(crossings)) = (&patch.beams, aim) {
            encounter::claim(view, &self.target, crossings, object, claims);
        }
    }

    /// Adds what a patch says whose aim is known. What is rather another object's (`others`: by slot, how far that one's
    /// drawn surface is, metres) does not displace this one.
    pub(super) fn absorb_aimed(
        &mut self,
        patch: &Unpacked,
        aim: &Aim,
        others: Option<&dyn Fn(usize) -> f64>,
        interrupt: Interrupt,
    ) -> Result<()> {
        match (&patch.beams, aim) {
            (_, Aim::Aside) => Ok(()),
            (Beams::FromOne(view), Aim::At(crossings)) => {
                let place = Place::At(view.header.origin);
                self.absorb_crossings(view, crossings, place, others, Some, interrupt)?;
                match others {
                    Some(others) if self.is_slim => self.absorb_beside(view, crossings, others, interrupt),
                    _ => Ok(()),
                }
            }
            (Beams::FromOne(view), _) => self.absorb_view(view, Place::At(view.header.origin), Some, interrupt),
            // Each place speaks alone; together they are one station.
            (Beams::FromMany(views), _) => {
                for view in views {
                    if self.concerns(&view.header) {
                        self.absorb_view(view, Place::Many, Some, interrupt)?;
                    }
                }
                Ok(())
            }
            (Beams::Points(points), _) => self.absorb_cloud(&patch.header, points, interrupt),
        }
    }

    /// `adjust` may take back some of what the beams saw.
    pub(super) fn absorb_view(
        &mut self,
        view: &View,
        place: Place,
        adjust: impl Fn(Seen) -> Option<Seen>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let model = self.evidence.model;
        match model.kind {
            ModelKind::Surface => {
                let crossings = self.target.crossings(view, self.reach(&view.header), interrupt)?;
                self.absorb_crossings(view, &crossings, place, None, adjust, interrupt)
            }
            ModelKind::Meyer2022 => self.for_blocks(view, place, None, interrupt, |offset, _, sums| {
                ray_sums::gather(view, offset, &model, sums);
            }),
        }
    }

    fn absorb_crossings(
        &mut self,
        view: &View,
        crossings: &[Crossing],
        place: Place,
        others: Option<&dyn Fn(usize) -> f64>,
        adjust: impl Fn(Seen) -> Option<Seen>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let model = self.evidence.model;
        let Some(encounters) = Encounters::of(view, &self.target, crossings, &model, others, adjust) else {
            return Ok(());
        };
        let min_cos = model.max_incidence.cos();
        self.for_blocks(view, place, Some(encounters.widest), interrupt, |offset, normal, sums| {
            let cos = -offset.dot(normal) / offset.norm();
            if cos >= min_cos {
                surface_sums::gather(view, &encounters, offset, normal, sums);
            }
        })
    }

    /// Calls `speak(offset from the scanner, normal towards it, sums)` for every sample the patch may concern: those
    /// that look at it, and lie within `beside` metres of its cone; without that number the ray model's rule, whose
    /// kernel is a length and asks for no normal.
    fn for_blocks(
        &mut self,
        view: &View,
        place: Place,
        beside: Option<f64>,
        interrupt: Interrupt,
        speak: impl Fn(&Vec3, &Vec3, &mut Sums),
    ) -> Result<()> {
        let header = &view.header;
        let (margin, reach) = (self.margin(header), self.reach(header));
        let beyond = beside.unwrap_or_else(|| self.kernel_radius());
        let station = self.evidence.station_index(header.station, place);
        // Sums count towards the scanner; where there are many, along the normal.
        let turns = place == Place::Many && self.evidence.model.kind == ModelKind::Surface;
        let Evidence { samples, stations, .. } = &mut self.evidence;
        let station = &mut stations[station];
        let scanner = header.origin - samples.reference;
        let mut own = [Sums::default(); BLOCK];
        for (i, block) in samples.blocks.iter().enumerate() {
            let (centre, radius) = &self.balls[i];
            let offset = centre - scanner;
            let normal = &samples.normals[block.face as usize];
            let behind = offset.dot(normal) > *radius;
            if offset.norm() - radius > reach
                || (beside.is_some() && behind && !samples.two_sided)
                || !header.cone.meets_ball(&offset, radius + beyond, margin)
            {
                continue;
            }
            if i % 16 == 0 {
                poll(interrupt)?;
            }
            let own = &mut own[..block.len as usize];
            own.fill(Sums::default());
            gather_block(samples, block, &scanner, normal, turns, &speak, own);
            if own.iter().any(|s| !s.is_empty()) {
                station.add_block(i as u32, own);
                station.step = station.step.max(header.step);
            }
        }
        stations.retain(|s| !s.blocks.is_empty());
        self.evidence.check_size()
    }

    /// How far from the scanner a patch can speak, metres: behind its farthest return by the search band as a
    /// beam at the steepest admitted incidence sees it.
    fn reach(&self, header: &Header) -> f64 {
        let model = &self.evidence.model;
        let behind = model.band_in_front() / model.max_incidence.cos();
        let returns = f64::from(header.range[1]) + behind + self.kernel_radius();
        if header.flags & Header::FLAG_NO_RETURNS != 0 { returns.max(model.no_return_range) } else { returns }
    }

    /// Angle beyond the patch's cone within which a sample still hears its beams, radians.
    fn margin(&self, header: &Header) -> f64 {
        KERNEL_SPACINGS * f64::from(header.step) + 1e-6
    }

    /// The same as a length, for the model whose kernel is one.
    fn kernel_radius(&self) -> f64 {
        match self.evidence.model.kind {
            ModelKind::Surface => 0.0,
            ModelKind::Meyer2022 => ray_sums::reach(&self.evidence.model),
        }
    }
}

fn gather_block(
    samples: &Samples,
    block: &Block,
    scanner: &Vec3,
    normal: &Vec3,
    turns: bool,
    speak: &impl Fn(&Vec3, &Vec3, &mut Sums),
    sums: &mut [Sums],
) {
    for (k, sums) in sums.iter_mut().enumerate() {
        let offset = samples.local(block.start as usize + k) - scanner;
        let behind = samples.two_sided && offset.dot(normal) > 0.0;
        let towards = if behind { -normal } else { *normal };
        if behind && turns {
            let mut own = Sums::default();
            speak(&offset, &towards, &mut own);
            sums.add(&surface_sums::turned(&own));
        } else {
            speak(&offset, &towards, sums);
        }
    }
}
