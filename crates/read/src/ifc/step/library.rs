//! The geometry library's reading of curves and profiles, for what is rewritten before it meshes.

use std::sync::Arc;

use ifc_lite_core::{DecodedEntity, EntityDecoder, IfcSchema, UnitScales, build_entity_index};
use ifc_lite_geometry::placement::Axis2Placement;
use ifc_lite_geometry::{Matrix4, Point3, Profile2D, ProfileProcessor, TessellationQuality};

const QUALITY: TessellationQuality = TessellationQuality::Medium;

pub struct Library<'a> {
    pub decoder: EntityDecoder<'a>,
    profiles: ProfileProcessor,
    /// Radians of the file's unit of angles.
    pub radians: f64,
}

impl<'a> Library<'a> {
    pub fn new(text: &'a [u8], angle: Option<f64>) -> Self {
        let index = Arc::new(build_entity_index(text));
        let mut decoder = EntityDecoder::with_arc_index(text, index).with_strict_reals();
        let units = UnitScales::resolve(text, None, &mut decoder);
        let radians = angle.unwrap_or(units.plane_angle_to_radians);
        decoder.seed_unit_scales(units.geometry_length_scale(), radians);
        Self { decoder, profiles: ProfileProcessor::new(IfcSchema::new()), radians }
    }

    /// The record that an attribute refers to.
    pub fn at(&mut self, of: &DecodedEntity, slot: usize) -> Option<DecodedEntity> {
        self.decoder.resolve_optional(of, slot).ok()?
    }

    pub fn direction(&mut self, of: &DecodedEntity, slot: usize) -> Option<[f64; 3]> {
        self.decoder.direction3_at(of, slot).ok()?
    }

    /// The transform of an IfcAxis2Placement3D; the identity if none is given.
    pub fn placement(&mut self, of: &DecodedEntity, slot: usize) -> Option<Matrix4<f64>> {
        let Some(placement) = self.decoder.resolve_optional(of, slot).ok()? else { return Some(Matrix4::identity()) };
        Some(Axis2Placement::read_3d(&placement, &mut self.decoder).ok()?.matrix())
    }

    /// A curve between two of its parameters.
    pub fn curve(&mut self, curve: &DecodedEntity, ends: [Option<f64>; 2]) -> Option<Vec<Point3<f64>>> {
        self.profiles.get_directrix_points(curve, &mut self.decoder, ends[0], ends[1], QUALITY).ok()
    }

    /// The areas of a profile.
    pub fn areas(&mut self, profile: &DecodedEntity) -> Option<Vec<Profile2D>> {
        self.profiles.arm_solid_budget();
        self.profiles.process_regions(profile, &mut self.decoder, QUALITY).ok()
    }
}
