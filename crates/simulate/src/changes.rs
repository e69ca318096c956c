//! What was built differently from the drawing.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use nalgebra::{Rotation3, Unit};
use serde::Deserialize;

use crate::bow::bowed;

/// An object as drawn.
#[derive(Debug)]
pub struct Drawn<'a> {
    /// Its name. Changes refer to an object by name or by GlobalId.
    pub name: &'a str,
    /// Its GlobalId.
    pub global_id: &'a str,
    /// Its body, if it has one.
    pub solid: Option<Solid>,
}

/// The file given with `--built`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Changes {
    /// By name or GlobalId.
    #[serde(default)]
    pub objects: BTreeMap<String, Change>,
    /// Things that are not in the model.
    #[serde(default)]
    pub added: Vec<Added>,
}

/// How an object was built differently; several of these may apply at once.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    /// Moved by this, metres.
    #[serde(default)]
    pub shift: [f64; 3],
    /// Tilted by this about a horizontal axis through its foot, degrees.
    #[serde(default)]
    pub tilt_deg: f64,
    /// Direction of the axis of the tilt.
    #[serde(default = "x_axis")]
    pub tilt_axis: [f64; 3],
    /// Bent: its middle (along its longest extent) is displaced by this, metres; its ends stay.
    #[serde(default)]
    pub bow: [f64; 3],
    /// Not built.
    #[serde(default)]
    pub missing: bool,
}

fn x_axis() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}

impl Default for Change {
    fn default() -> Self {
        Self { shift: [0.0; 3], tilt_deg: 0.0, tilt_axis: x_axis(), bow: [0.0; 3], missing: false }
    }
}

/// A cuboid between two corners, or an upright cylinder.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
pub enum Added {
    Cuboid {
        #[serde(rename = "name")]
        _name: String,
        min: [f64; 3],
        max: [f64; 3],
    },
    Cylinder {
        #[serde(rename = "name")]
        _name: String,
        foot: [f64; 3],
        radius: f64,
        height: f64,
    },
}

impl Changes {
    /// Reads the file given with `--built`.
    pub fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).with_context(|| format!("{}: cannot read it", path.display()))?;
        serde_json::from_str(&text).with_context(|| {
            format!(
                "{}: expected {{\"objects\": {{\"NAME\": {{\"shift\": [x,y,z], \"tilt_deg\": d, \"bow\": [x,y,z], \"missing\": \
                true}}}}, \"added\": [{{\"name\": …, \"min\": [x,y,z], \"max\": [x,y,z]}}]}}",
                path.display()
            )
        })
    }

    /// Everything that stands in the scene, as meshes.
    pub fn build(&self, drawn: &[Drawn]) -> Result<Vec<Solid>> {
        for name in self.objects.keys() {
            if !drawn.iter().any(|d| d.name == name || d.global_id == name) {
                let known: Vec<&str> = drawn.iter().map(|d| d.name).take(30).collect();
                bail!("no object is called \"{name}\"; the model has {}", known.join(", "));
            }
        }
        let mut out = Vec::new();
        for d in drawn {
            let Some(solid) = &d.solid else { continue };
            out.extend(match self.objects.get(d.name).or_else(|| self.objects.get(d.global_id)) {
                None => Some(solid.clone()),
                Some(change) => change.apply(solid)?,
            });
        }
        for added in &self.added {
            out.push(added.solid()?);
        }
        Ok(out)
    }
}

impl Added {
    /// Its mesh.
    pub fn solid(&self) -> Result<Solid> {
        Ok(match self {
            Self::Cuboid { min, max, .. } => Solid::cuboid(*min, *max)?,
            Self::Cylinder { foot, radius, height, .. } => Solid::cylinder(*foot, *radius, *height, 64)?,
        })
    }
}

impl Change {
    /// The object as built: bent, then tilted, then moved; `None` if it is missing.
    pub fn apply(&self, solid: &Solid) -> Result<Option<Solid>> {
        if self.missing {
            return Ok(None);
        }
        let b = solid.bounds();
        let mut foot = b.centre();
        foot.z = b.min[2];
        let Some(axis) = Unit::try_new(Vec3::from(self.tilt_axis), 1e-9) else {
            bail!("tilt_axis {:?} is no direction", self.tilt_axis);
        };
        let rotation = Rotation3::from_axis_angle(&axis, self.tilt_deg.to_radians());
        let bow = Vec3::from(self.bow);
        let bent = if bow == Vec3::zeros() { solid.clone() } else { bowed(solid, &bow)? };
        let shift = Vec3::from(self.shift);
        Ok(Some(bent.placed(|v| rotation * (v - foot) + foot + shift, NEVER)?))
    }
}
