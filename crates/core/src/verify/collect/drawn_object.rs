//! One drawn object, made ready for beams: all that others need to know of it.

use crate::geometry::{Aabb, Solid, Vec3};
use crate::scan::{PatchHeader, RangeImage, Spacing, Vicinity};
use crate::verify::aim::{Aim, BeamCrossing, Claims, Depth, NearFace, Target, Unpacked, UnpackedBeams, crossings};
use crate::verify::evidence::Samples;
use crate::verify::model::{BeamModel, EvidenceModel, KERNEL_SPACINGS, with_model};
use crate::{Interrupt, Result, poll};

/// A drawn object without samples.
#[derive(Debug)]
pub struct DrawnObject {
    pub target: Target,
    pub bounds: Aabb,
    pub model: EvidenceModel,
}

impl DrawnObject {
    /// Makes a solid ready for the beams of any patch.
    pub fn new(solid: &Solid, model: EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        // What the evidence says of itself; beyond the parameter's range only on objects of 500 km².
        let spacing = Samples::effective_spacing(solid, model.spacing).min(EvidenceModel::MAX_SPACING_M);
        let model = EvidenceModel { spacing, ..model };
        Ok(Self { target: Target::new(solid, interrupt)?, bounds: solid.bounds(), model })
    }

    /// Whether a patch can tell anything of the solid, by its header alone.
    pub fn concerns(&self, header: &PatchHeader) -> bool {
        let around = match header.spacing {
            Spacing::Angle(_) => 0.0,
            Spacing::Distance(spacing) => self.model.band_behind() + KERNEL_SPACINGS * spacing,
        };
        let (radius, reach, beside) = (0.5 * self.bounds.diagonal(), self.reach(header), self.kernel_radius());
        header.can_tell_of(&self.bounds, &Vicinity { around, radius, reach, beside, beside_angle: margin(header) })
    }

    /// Where the beams of a patch from one place would cross the solid, or which of its faces its points are near.
    pub fn aim(&self, patch: &Unpacked, interrupt: Interrupt) -> Result<Aim> {
        if !self.concerns(&patch.header) {
            return Ok(Aim::Aside);
        }
        match &patch.beams {
            UnpackedBeams::FromOne(view) if with_model!(self.model.kind, M => M::CROSSES_SURFACE) => {
                if self.is_behind_all(view) {
                    return Ok(Aim::Aside);
                }
                self.crossings(view, interrupt).map(Aim::At)
            }
            UnpackedBeams::Points(points) => self.near_faces(&patch.header, points, interrupt).map(Aim::Near),
            _ => Ok(Aim::Unknown),
        }
    }

    /// Claims for this object, by its number, what was met near where it is drawn.
    pub fn claim(&self, patch: &Unpacked, aim: &Aim, object: u32, claims: &mut Claims) {
        match (&patch.beams, aim) {
            (UnpackedBeams::FromOne(view), Aim::At(crossings)) => {
                claims.stake_all(view, &self.target, crossings, object);
            }
            (_, Aim::Near(faces)) => {
                faces.iter().for_each(|(i, face)| claims.stake(*i as usize, object, face.deviation() as f32));
            }
            _ => {}
        }
    }

    /// Which points of a cloud without origin lie near which face.
    fn near_faces(&self, header: &PatchHeader, points: &[Vec3], interrupt: Interrupt) -> Result<Vec<(u32, NearFace)>> {
        let around = self.bounds.expanded(self.model.band());
        let mut near = Vec::new();
        for (i, point) in points.iter().enumerate() {
            if i % 64 == 0 {
                poll(interrupt)?;
            }
            let point_world = point + header.origin;
            if around.holds(&point_world) {
                near.extend(self.near_face(&point_world).map(|face| (i as u32, face)));
            }
        }
        Ok(near)
    }

    /// The face that a point, world metres, may be the surface of.
    pub fn near_face(&self, point_world: &Vec3) -> Option<NearFace> {
        let (in_front, behind) = (self.model.band_in_front(), self.model.band_behind());
        let face = self.target.near_face(point_world, self.model.band());
        face.filter(|face| (-behind..=in_front).contains(&face.height))
    }

    /// The first crossing of every beam that can tell of the object.
    pub fn crossings(&self, view: &RangeImage, interrupt: Interrupt) -> Result<Vec<BeamCrossing>> {
        crossings(&self.target, view, &self.depth(&view.header), interrupt)
    }

    /// Whether every beam that looks towards the object, or the band around it, ended before.
    fn is_behind_all(&self, view: &RangeImage) -> bool {
        let origin = view.header.origin;
        let around = self.bounds.expanded(self.model.band());
        let nearest = around.distance(&Aabb::around(&[origin]));
        !self.depth(&view.header).reaches(view, &around.corners().map(|c| c - origin), nearest)
    }

    fn depth(&self, header: &PatchHeader) -> Depth {
        Depth { farthest: self.reach(header), behind: self.behind() }
    }

    /// How far behind what a beam met it can tell anything, metres: the search band as a beam at the steepest admitted
    /// incidence sees it.
    fn behind(&self) -> f64 {
        self.model.band_in_front() / self.model.max_incidence.cos()
    }

    /// How far from the scanner a patch can tell anything, metres.
    pub fn reach(&self, header: &PatchHeader) -> f64 {
        let model = &self.model;
        let returns = f64::from(header.range[1]) + self.behind() + self.kernel_radius();
        if header.flags & PatchHeader::FLAG_NO_RETURNS != 0 { returns.max(model.no_return_range) } else { returns }
    }

    fn kernel_radius(&self) -> f64 {
        with_model!(self.model.kind, M => M::kernel_radius(&self.model))
    }
}

/// Angle beyond the patch's cone within which a sample is still in the kernel of its beams, radians.
pub fn margin(header: &PatchHeader) -> f64 {
    KERNEL_SPACINGS * header.spacing.angle() + 1e-6
}
