//! A copy of a model turned about the vertical axis through the file's zero.

use std::sync::Arc;

use ifc_lite_core::build_entity_index;

use crate::ifc::meshing::Meshing;
use crate::ifc::soup::Soup;
use crate::ifc::step::turned_text;

/// The model turned by this many degrees; `None` where nothing in it can be turned.
pub fn model(text: &[u8], degrees: f64, radians: Option<f64>) -> Option<Meshing> {
    // The process that meshes ends with the file: what is kept until then needs no owner.
    let text: &'static [u8] = Vec::leak(turned_text(text, degrees)?);
    let index = Arc::new(build_entity_index(text));
    Meshing::new(text, index, radians).ok()
}

/// Turns a mesh back.
pub fn back(soup: &mut Soup, degrees: f64) {
    let (sin, cos) = (-degrees).to_radians().sin_cos();
    for v in &mut soup.vertices {
        (v[0], v[1]) = (cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]);
    }
}
