//! What was built otherwise than drawn.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::{Solid, Vec3};
use nalgebra::{Rotation3, Unit};
use serde::Deserialize;

use crate::read::ifc::Product;

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

/// How an object was built otherwise; several may hold together.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    /// Moved by this, metres.
    #[serde(default)]
    pub shift: [f64; 3],
    /// Tilted by this about a horizontal axis through its foot, degrees …
    #[serde(default)]
    pub tilt_deg: f64,
    /// … which is this direction.
    #[serde(default = "x_axis")]
    pub tilt_axis: [f64; 3],
    /// Not built.
    #[serde(default)]
    pub missing: bool,
}

fn x_axis() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}

/// A cuboid between two corners, or an upright cylinder.
#[derive(Debug, Deserialize)]
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
    pub fn read(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).with_context(|| format!("{}: cannot read it", path.display()))?;
        serde_json::from_str(&text).with_context(|| {
            format!(
                "{}: expected {{\"objects\": {{\"NAME\": {{\"shift\": [x,y,z], \"tilt_deg\": d, \"missing\": true}}}}, \
                \"added\": [{{\"name\": …, \"min\": [x,y,z], \"max\": [x,y,z]}}]}}",
                path.display()
            )
        })
    }

    /// Everything that stands in the scene, as meshes.
    pub fn build(&self, products: &[Product]) -> Result<Vec<Solid>> {
        for name in self.objects.keys() {
            if !products.iter().any(|p| p.name == *name || p.global_id == *name) {
                let known: Vec<&str> = products.iter().map(|p| p.name.as_str()).take(30).collect();
                bail!("no object is called \"{name}\"; the model has {}", known.join(", "));
            }
        }
        let mut out = Vec::new();
        for p in products {
            let Some(solid) = p.solid()? else { continue };
            match self.objects.get(&p.name).or_else(|| self.objects.get(&p.global_id)) {
                None => out.push(solid),
                Some(change) if change.missing => {}
                Some(change) => out.push(change.apply(&solid)?),
            }
        }
        for added in &self.added {
            out.push(match added {
                Added::Cuboid { min, max, .. } => Solid::cuboid(*min, *max)?,
                Added::Cylinder { foot, radius, height, .. } => Solid::cylinder(*foot, *radius, *height, 64)?,
            });
        }
        Ok(out)
    }
}

impl Change {
    fn apply(&self, solid: &Solid) -> Result<Solid> {
        let b = solid.bounds();
        let mut foot = b.centre();
        foot.z = b.min[2];
        let Some(axis) = Unit::try_new(Vec3::from(self.tilt_axis), 1e-9) else {
            bail!("tilt_axis {:?} is no direction", self.tilt_axis);
        };
        let rotation = Rotation3::from_axis_angle(&axis, self.tilt_deg.to_radians());
        let moved = solid.vertices().iter().map(|v| rotation * (v - foot) + foot + Vec3::from(self.shift)).collect();
        Ok(Solid::new(moved, solid.triangles().to_vec())?)
    }
}
