//! IFC: products with their meshes, read by a child process so that a file that hangs or kills the geometry
//! kernel costs no more than an error.
//!
//! * [`step`]: the file's text, rewritten so that the geometry library can read it;
//! * [`attributes`], [`relations`]: products without their meshes;
//! * [`meshing`], [`soup`], [`cut`]: a product's mesh, its openings cut and proven;
//! * [`diagnose`]: why a product has no mesh;
//! * [`worker`], [`watch`], [`reach`]: the child's side, product by product;
//! * [`told`]: what passes between the two;
//! * [`looks`]: which of its items are glass, by styles and materials;
//! * [`reader`], [`assemble`]: the parent's side;
//! * [`part`]: the parts of a product; [`outline`], [`movable`]: which of a door or window move;
//! * [`table`]: a model as text.

mod assemble;
mod attributes;
mod cut;
mod diagnose;
#[cfg(test)]
mod field_tests;
mod looks;
mod meshing;
mod movable;
mod outline;
mod part;
mod reach;
mod reader;
mod relations;
#[cfg(test)]
mod shape_tests;
#[cfg(test)]
mod shipped_tests;
mod soup;
mod step;
#[cfg(test)]
mod structure_tests;
mod table;
mod told;
mod watch;
mod worker;

use std::collections::BTreeMap;
use std::time::Duration;

use anyhow::Result;
use asbuilt_core::geometry::{Closedness, Solid, Vec3, orient};
use serde::{Deserialize, Serialize};

use crate::{Unit, unit};

pub use part::Part;
pub use reader::{Limits, read, read_within};
pub use step::MapConversion;
pub use table::print_table;
pub use worker::{WorkerLimits, answer};

/// A building object.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Product {
    /// Its number in the file, as written there.
    pub id: u64,
    pub global_id: String,
    pub ifc_class: String,
    pub name: String,
    pub storey: Option<String>,
    /// Property values by `Set.Property`.
    pub properties: BTreeMap<String, String>,
    /// Property `LevelOfAccuracy`, its own or its whole's.
    pub level_of_accuracy: Option<String>,
    /// GlobalId of the object it is a part of.
    pub part_of: Option<String>,
    /// World metres.
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle the number of its part.
    pub part_numbers: Vec<u16>,
    pub parts: Vec<Part>,
    /// A door or window of which nothing opens.
    pub is_fixed: bool,
    /// What the geometry library said about it.
    pub note: Option<String>,
}

/// What an IFC file holds.
#[derive(Debug, Default)]
pub struct IfcModel {
    pub products: Vec<Product>,
    /// Products with a body that could not be meshed: name and reason. They are among the products, without a mesh.
    pub unmeshed: Vec<(String, String)>,
    /// Products whose coordinates the geometry library rounded: name and grid, metres.
    pub rounded: Vec<(String, f64)>,
    /// What is no building object (openings, spaces, grids), by class.
    pub left_out: BTreeMap<String, u64>,
    /// Products that have a note: name and note.
    pub noted: Vec<(String, String)>,
    /// Products whose openings had to be cut again, and came out right.
    pub mended: usize,
    pub map_conversion: Option<MapConversion>,
    /// Its unit of length in metres, where it declares one.
    pub length_unit: Option<f64>,
    /// Time of meshing and of its checks, all threads together.
    pub times: Option<(Duration, Duration)>,
    /// What to tell the user about the file as a whole.
    pub warnings: Vec<String>,
}

impl IfcModel {
    /// The user's unit counts where the file declares none; metres were assumed in that case.
    pub fn in_unit(mut self, given: Option<Unit>) -> Result<Self> {
        let Some(unit) = given else { return Ok(self) };
        if let Some(told) = self.length_unit {
            unit::check(told, given)?;
            return Ok(self);
        }
        let all = self.products.iter_mut().flat_map(|p| &mut p.vertices).flatten();
        all.for_each(|coordinate| *coordinate *= unit.metres());
        self.warnings.push(format!("it tells no unit of length; {} taken (--file-unit)", unit.name()));
        Ok(self)
    }
}

impl Product {
    /// Class, name and number: enough to find it.
    pub fn shown(&self) -> String {
        let number = format!("#{}", self.id);
        if self.name == number {
            format!("{} {number}", self.ifc_class)
        } else {
            format!("{} {} ({number})", self.ifc_class, self.name)
        }
    }

    /// Its solid: as meshed, or re-oriented where that closes it; `None` without a mesh.
    pub fn solid(&self) -> Result<Option<Solid>> {
        if self.triangles.is_empty() {
            return Ok(None);
        }
        let vertices: Vec<Vec3> = self.vertices.iter().map(|v| Vec3::from(*v)).collect();
        let solid = self.with_parts(Solid::new(vertices.clone(), self.triangles.clone())?)?;
        if solid.closedness() == Closedness::Open {
            let mut turned = self.triangles.clone();
            if orient(&vertices, &mut turned) > 0 {
                let mended = self.with_parts(Solid::new(vertices, turned)?)?;
                if mended.closedness() != Closedness::Open {
                    return Ok(Some(mended));
                }
            }
        }
        Ok(Some(solid))
    }
}
