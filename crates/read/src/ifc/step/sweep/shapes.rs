//! What is read of the file, by the geometry library.

use std::f64::consts::TAU;

use ifc_lite_core::{DecodedEntity, IfcType};
use ifc_lite_geometry::placement::Axis1Placement;
use ifc_lite_geometry::{Matrix4, Point3, Vector3};

use super::super::library::Library;
use super::path::Path;
use super::rings::mitred;
use super::roll::Roll;
use super::section::Section;
use super::skin::Skin;
use super::turned::Axis;
use super::{Built, SweepKind, taper, turned};

/// A solid of more points than this is left to the library.
const MAX_POINTS: usize = 1 << 20;
/// Degrees of a revolution from ring to ring.
const STEP_DEGREES: f64 = 7.5;
/// Radians by which an angle may miss a whole turn.
const WHOLE_TURN: f64 = 1e-4;

pub struct Shapes<'a>(Library<'a>);

impl<'a> Shapes<'a> {
    pub fn new(text: &'a [u8], angle: Option<f64>) -> Self {
        Self(Library::new(text, angle))
    }

    pub fn build(&mut self, id: u32, kind: SweepKind) -> Built {
        let Ok(solid) = self.0.decoder.decode_by_id(id) else { return Built::default() };
        let built = match kind {
            SweepKind::Along => self.along(&solid),
            SweepKind::Disk => self.disk(&solid, None),
            SweepKind::RoundedDisk => self.disk(&solid, Some(solid.get_float(5).unwrap_or(0.0))),
            SweepKind::Revolution => self.revolved(&solid),
            SweepKind::TaperedExtrusion | SweepKind::TaperedRevolution => self.tapered(&solid, kind),
        };
        built.unwrap_or_default()
    }

    /// SweptArea, Position, Directrix, StartParam, EndParam, ReferenceSurface or FixedReference.
    fn along(&mut self, solid: &DecodedEntity) -> Option<Built> {
        let sections = self.sections(solid, 0)?;
        let path = self.path(solid, 2)?;
        let roll = self.roll(solid);
        let place = self.0.placement(solid, 1)?;
        let skins = roll.and_then(|roll| follow(&sections, &path, &roll));
        let skins = skins.map(|skins| skins.into_iter().map(|s| s.moved(&place)).collect());
        Some(Built { skins, doubt: doubt(&path) })
    }

    /// Directrix, Radius, InnerRadius, StartParam, EndParam; smooth ones are left to the library.
    fn disk(&mut self, solid: &DecodedEntity, fillet: Option<f64>) -> Option<Built> {
        let path = self.path(solid, 0)?;
        if fillet.is_none() && path.corners() == 0 {
            return None;
        }
        let section = Section::disk(solid.get_float(1)?, solid.get_float(2))?;
        let said = doubt(&path);
        let path = path.rounded(fillet.unwrap_or(0.0));
        let skins = path.and_then(|path| follow(&[section], &path, &Roll::Carried));
        Some(Built { skins, doubt: said })
    }

    /// SweptArea, Position, ExtrudedDirection and Depth or Axis and Angle, EndSweptArea.
    fn tapered(&mut self, solid: &DecodedEntity, kind: SweepKind) -> Option<Built> {
        let (starts, ends) = (self.sections(solid, 0)?, self.sections(solid, 4)?);
        let place = self.0.placement(solid, 1)?;
        let moves = match kind {
            SweepKind::TaperedRevolution => self.turns(solid)?,
            _ => self.lift(solid)?,
        };
        let skin = |(start, end): (&Section, &Section)| Some(taper::skin(start, end, &moves)?.moved(&place));
        let skins: Option<Vec<Skin>> = starts.iter().zip(&ends).map(skin).collect();
        let doubt = "its two profiles have different corners: the faces between them are a guess".to_owned();
        Some(Built { skins: skins.filter(|_| starts.len() == ends.len()), doubt: Some(doubt) })
    }

    /// From the start of a tapered extrusion to its end.
    fn lift(&mut self, solid: &DecodedEntity) -> Option<Vec<Matrix4<f64>>> {
        let way = Vector3::from(self.0.direction(solid, 2)?).try_normalize(0.0)?;
        Some(vec![Matrix4::identity(), Matrix4::new_translation(&(way * solid.get_float(3)?))])
    }

    /// SweptArea, Position, Axis, Angle, up to a whole turn. Only for a profile beside its axis.
    fn revolved(&mut self, solid: &DecodedEntity) -> Option<Built> {
        let sections = self.sections(solid, 0)?;
        let (axis, angle) = (self.axis(solid)?, self.angle(solid)?);
        let place = self.0.placement(solid, 1)?;
        let is_whole = (angle.abs() - TAU).abs() <= WHOLE_TURN;
        let moves = self.turns(solid)?;
        let points: usize = sections.iter().map(|s| s.points.len()).sum();
        if angle.abs() > TAU + WHOLE_TURN || points.saturating_mul(moves.len()) > MAX_POINTS {
            return None;
        }
        let skin = |section| Some(turned::skin(section, &axis, &moves, is_whole)?.moved(&place));
        Some(Built { skins: sections.iter().map(skin).collect(), doubt: None })
    }

    /// From the start of a revolution to its end, in steps.
    fn turns(&mut self, solid: &DecodedEntity) -> Option<Vec<Matrix4<f64>>> {
        let (axis, angle) = (self.axis(solid)?, self.angle(solid)?);
        let steps = (angle.abs().to_degrees() / STEP_DEGREES - 1e-6).ceil().clamp(1.0, 96.0);
        let turn = |k: u32| axis.along * (angle * f64::from(k) / steps);
        let turn = |k| Matrix4::new_rotation_wrt_point(turn(k), axis.origin);
        Some((0..=steps as u32).map(turn).collect())
    }

    fn axis(&mut self, solid: &DecodedEntity) -> Option<Axis> {
        let axis = self.0.at(solid, 2)?;
        let axis = Axis1Placement::read(&axis, &mut self.0.decoder).ok()?;
        let along = Vector3::from(axis.axis.unwrap_or([0.0, 0.0, 1.0])).try_normalize(0.0)?;
        Some(Axis { origin: axis.location.into(), along })
    }

    /// Angle in radians.
    fn angle(&self, solid: &DecodedEntity) -> Option<f64> {
        Some(solid.get_float(3)? * self.0.radians)
    }

    fn sections(&mut self, solid: &DecodedEntity, slot: usize) -> Option<Vec<Section>> {
        let profile = self.0.at(solid, slot)?;
        self.0.areas(&profile)?.iter().map(|area| Section::new(&area.outer, &area.holes)).collect()
    }

    fn path(&mut self, solid: &DecodedEntity, slot: usize) -> Option<Path> {
        let curve = self.0.at(solid, slot)?;
        Path::new(self.0.curve(&curve, [solid.get_float(3), solid.get_float(4)])?)
    }

    fn roll(&mut self, solid: &DecodedEntity) -> Option<Roll> {
        const REFERENCE: usize = 5;
        if solid.ifc_type == IfcType::IfcFixedReferenceSweptAreaSolid {
            return Some(Roll::Fixed(self.0.direction(solid, REFERENCE)?.into()));
        }
        let mut surface = self.0.at(solid, REFERENCE)?;
        if surface.ifc_type == IfcType::IfcCurveBoundedPlane {
            surface = self.0.at(&surface, 0)?;
        }
        match surface.ifc_type {
            IfcType::IfcPlane => Some(Roll::Fixed(self.0.placement(&surface, 0)?.transform_vector(&Vector3::z()))),
            IfcType::IfcSurfaceOfLinearExtrusion => {
                let way = Vector3::from(self.0.direction(&surface, 2)?);
                let profile = self.0.at(&surface, 0)?;
                let curve = self.0.at(&profile, 2)?;
                let frame = self.0.placement(&surface, 1)?;
                let points = self.0.curve(&curve, [None, None])?;
                let points: Vec<Point3<f64>> = points.iter().map(|p| frame.transform_point(p)).collect();
                Some(Roll::Extruded(points, frame.transform_vector(&way)))
            }
            _ => None,
        }
    }
}

fn follow(sections: &[Section], path: &Path, roll: &Roll) -> Option<Vec<Skin>> {
    let points: usize = sections.iter().map(|s| s.points.len()).sum();
    if points.saturating_mul(path.points.len()) > MAX_POINTS {
        return None;
    }
    let mut skins = Vec::new();
    for section in sections {
        for run in mitred(section, path, roll)? {
            skins.push(Skin::new([section, section], &run.rings, run.is_closed));
        }
    }
    Some(skins)
}

fn doubt(path: &Path) -> Option<String> {
    let corners = path.corners();
    (corners > 0).then(|| {
        format!(
            "its sweep goes around {corners} corners that its profile cannot follow (it meets itself there, or the \
             direction of its reference is lost): it may come out turned or too thin"
        )
    })
}
