//! Buildings as drawn, from IFC.

use std::collections::HashSet;
use std::path::Path;

use anyhow::Result;
use asbuilt_core::geometry::{Aabb, Closedness, Solid, Vec3};
use asbuilt_fieldscan::{Tree, Triangle};
use asbuilt_read::ifc::{self, Product};

use super::leaf::leaves;

/// Share of its surface from which an object counts as glazed.
const GLAZED_SHARE: f64 = 0.2;

/// What an object is, as far as it matters to how it can be wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Walls, slabs, roofs, columns, stairs and what else holds or covers.
    Structure,
    /// Windows, and what is mostly glass.
    Glazed,
    /// Doors.
    Door,
    /// Furniture and sanitary ware.
    Furniture,
    /// Rods and rails: members, beams, railings, pipes.
    Slim,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Structure, Self::Glazed, Self::Door, Self::Furniture, Self::Slim];

    /// In words.
    pub fn name(self) -> &'static str {
        ["structure", "windows and glazed", "doors", "furniture", "slim"][self as usize]
    }

    fn of(class: &str, glazed: f64) -> Self {
        let class = class.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|w| class.contains(w));
        match () {
            () if has(&["door"]) => Self::Door,
            () if has(&["window"]) || glazed > GLAZED_SHARE => Self::Glazed,
            () if has(&["furni", "sanitary", "flowterminal"]) => Self::Furniture,
            () if has(&["member", "beam", "railing", "flowsegment", "pipe", "duct", "cable"]) => Self::Slim,
            () => Self::Structure,
        }
    }
}

/// An object as drawn.
#[derive(Debug)]
pub struct Object {
    /// GlobalId.
    pub id: String,
    /// IFC class.
    pub class: String,
    /// Name.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Its body, world metres.
    pub solid: Solid,
    /// By triangle: whether it is of glass.
    pub transparent: Vec<bool>,
    /// By triangle: number of the leaf that it turns with.
    pub leaf: Vec<Option<usize>>,
    /// Whether its triangles look outward.
    pub is_closed: bool,
    /// Another object drawn at the same place.
    pub twin: bool,
}

impl Object {
    /// Whether it has a leaf that can be open.
    pub fn can_open(&self) -> bool {
        self.kind == Kind::Door && self.leaf.iter().any(Option::is_some)
    }

    fn of(product: &Product) -> Result<Option<Self>> {
        let Some(solid) = product.solid()? else { return Ok(None) };
        let count = solid.triangles().len();
        let transparent: Vec<bool> = (0..count).map(|t| solid.is_transparent(t)).collect();
        let parts: Vec<usize> = (0..count).map(|t| solid.parts().map_or(0, |parts| parts.number_of(t))).collect();
        let area = |t: usize| {
            let [a, b, c] = solid.corners(t);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        let glass: f64 = (0..transparent.len()).filter(|t| transparent[*t]).map(area).sum();
        let kind = Kind::of(&product.ifc_class, glass / solid.area());
        let leaf = if kind == Kind::Door { leaves(&solid, &parts) } else { vec![None; transparent.len()] };
        let is_closed = solid.closedness() != Closedness::Open;
        let (id, class, name) = (product.global_id.clone(), product.ifc_class.clone(), product.name.clone());
        Ok(Some(Self { id, class, name, kind, solid, transparent, leaf, is_closed, twin: false }))
    }
}

/// A building as drawn.
#[derive(Debug)]
pub struct Layout {
    /// Its objects; wholes whose parts have bodies of their own are left out.
    pub objects: Vec<Object>,
    /// All their triangles; a surface's number is its object's.
    pub tree: Tree,
    /// Around all but the terrain, world metres.
    pub bounds: Aabb,
}

impl Layout {
    /// Reads an IFC file.
    pub fn read(path: &Path) -> Result<Self> {
        let model = ifc::read_within(path)?;
        let with_body = model.products.iter().filter(|p| !p.triangles.is_empty());
        let wholes: HashSet<&str> = with_body.clone().filter_map(|p| p.part_of.as_deref()).collect();
        let mut objects = Vec::new();
        for product in with_body.filter(|p| !wholes.contains(p.global_id.as_str())) {
            objects.extend(Object::of(product)?);
        }
        let triangles = objects.iter().enumerate().flat_map(|(i, o)| {
            (0..o.solid.triangles().len()).map(move |t| Triangle { corners: o.solid.corners(t), surface: i as u32 })
        });
        let tree = Tree::new(triangles);
        let built = objects.iter().filter(|o| o.class != "IfcSite");
        let bounds = built.map(|o| o.solid.bounds()).reduce(|a, b| a.union(&b)).unwrap_or(Aabb::EMPTY);
        Ok(Self { objects, tree, bounds })
    }

    /// The height of the ground, world metres: where doors stand lowest; without doors, the bottom of all.
    pub fn ground(&self) -> f64 {
        let doors = self.objects.iter().filter(|o| o.kind == Kind::Door).map(|o| o.solid.bounds().min[2]);
        let lowest = doors.fold(f64::INFINITY, f64::min);
        if lowest.is_finite() { lowest } else { self.bounds.min[2] }
    }

    /// The object, other than `but`, whose drawn surface comes nearest to a place and is parallel to a `normal` there,
    /// and whether it looks the other way; within `reach` metres.
    pub fn coincident(&self, place: &Vec3, normal: &Vec3, but: usize, reach: f64) -> Option<(usize, bool)> {
        const PARALLEL: f64 = 0.94;
        let mut best: Option<(f64, usize, bool)> = None;
        self.tree.near(place, reach, |t| {
            if t.surface as usize == but || t.normal().dot(normal).abs() < PARALLEL {
                return;
            }
            let distance = (t.nearest(place) - place).norm();
            if distance <= best.map_or(reach, |b| b.0) {
                best = Some((distance, t.surface as usize, t.normal().dot(normal) < 0.0));
            }
        });
        best.map(|(_, object, is_opposite)| (object, is_opposite))
    }
}
