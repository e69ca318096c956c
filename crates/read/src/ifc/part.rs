//! The parts of a product, as they are stored with its solid.

use anyhow::Result;
use asbuilt_core::geometry::{self, Parts, Solid};
use serde::{Deserialize, Serialize};

use super::Product;
use super::looks::{Look, Role};

/// A part of a product: one of its items, or what of it moves.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Part {
    pub name: Option<String>,
    pub is_transparent: bool,
    pub is_movable: bool,
    pub role: Role,
}

impl From<Look> for Part {
    fn from(look: Look) -> Self {
        Self { name: look.name, is_transparent: look.is_transparent, is_movable: false, role: look.role }
    }
}

impl Part {
    /// As it is stored; of a long name the beginning.
    fn stored(&self) -> geometry::Part {
        let name = self.name.as_ref().map(|name| {
            let mut short = name.replace('\0', "");
            while short.len() > Parts::MAX_NAME_LEN {
                short.pop();
            }
            short
        });
        geometry::Part { name, is_transparent: self.is_transparent, is_movable: self.is_movable }
    }
}

impl Product {
    /// Takes numbers by triangle and what is told of each; a mesh of which nothing is told is one part.
    pub fn take_parts(&mut self, part_numbers: Vec<u16>, parts: Vec<Part>) {
        let are_told =
            part_numbers.len() == self.triangles.len() && part_numbers.iter().all(|&p| usize::from(p) < parts.len());
        (self.part_numbers, self.parts) =
            if are_told { (part_numbers, parts) } else { (vec![0; self.triangles.len()], vec![Part::default()]) };
    }

    /// Adds a part and gives its number; when all numbers are taken, that of a part with the same flags.
    pub fn number_for(&mut self, part: Part) -> u16 {
        if self.parts.len() < Parts::MAX_PARTS {
            self.parts.push(part);
            return (self.parts.len() - 1) as u16;
        }
        let is_alike = |p: &Part| p.is_transparent == part.is_transparent && p.is_movable == part.is_movable;
        self.parts.iter().position(is_alike).unwrap_or_default() as u16
    }

    /// Its mesh and parts alone.
    pub fn shape(&self) -> Self {
        Self {
            vertices: self.vertices.clone(),
            triangles: self.triangles.clone(),
            part_numbers: self.part_numbers.clone(),
            parts: self.parts.clone(),
            ..Self::default()
        }
    }

    /// Whether any of it is transparent, and whether any of it may move.
    pub fn flags(&self) -> [bool; 2] {
        let drawn = || self.part_numbers.iter().filter_map(|&p| self.parts.get(usize::from(p)));
        [drawn().any(|p| p.is_transparent), drawn().any(|p| p.is_movable)]
    }

    /// The solid with its parts.
    pub(super) fn with_parts(&self, solid: Solid) -> Result<Solid> {
        if self.part_numbers.is_empty() {
            return Ok(solid);
        }
        let parts = Parts::new(self.part_numbers.clone(), self.parts.iter().map(Part::stored).collect())?;
        Ok(solid.with_parts(parts)?)
    }
}
