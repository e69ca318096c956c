//! What of a door or a window may move: the parts that do not belong to its frame.
//!
//! The plane of the object is the one that most of its surface is parallel to. What reaches the object's outline in
//! that plane, and is no glass, is frame (below it, of a door, only what is low: leaves reach the floor too). The rest are leaves where it is
//! as large as one and stands along both sides and below, as a plate or a ring does and mullions do not; and whatever
//! lies within a leaf: panes, bars, handles. Told apart by items first; where that finds no leaf, by what hangs together.
//! Names (`looks/words.rs`) come before the geometry; in a window of which everything is named as a leaf, they tell
//! nothing. A door of which nothing can be told apart moves as a whole; such
//! a window does not move.

use super::looks::{Role, is_fixed};
use super::outline::{Outline, Unit};
use super::{Part, Product};

/// Smallest extents of a leaf, shares of the object's.
const MIN_LEAF: f64 = 0.12;
/// Share of a leaf's sides along which it must stand.
const MIN_SIDE: f64 = 0.5;
/// How much of the box around it a plate fills.
const PLATE: f64 = 0.8;
/// Height of a threshold, share of the door's.
const MAX_THRESHOLD: f64 = 0.25;

/// Marks what may move of a door or a window.
pub fn mark(product: &mut Product) {
    let is_door = product.ifc_class.starts_with("IfcDoor");
    let is_window = product.ifc_class.starts_with("IfcWindow");
    let is_fixed = product.is_fixed || (is_window && is_fixed(&product.name));
    if !(is_door || is_window) || is_fixed || product.triangles.is_empty() {
        return;
    }
    let Some(outline) = Outline::of(product) else { return };
    let by_item = outline.units_by_part(product);
    let mut moving = leaves(&by_item, &outline, product, is_door);
    if moving.is_empty() {
        moving = leaves(&outline.units_by_component(product), &outline, product, is_door);
    }
    if moving.is_empty() && is_door {
        moving = (0..product.triangles.len()).collect();
    }
    set(product, &moving);
}

/// The triangles of leaves and of what lies within them.
fn leaves(units: &[Unit], outline: &Outline, product: &Product, is_door: bool) -> Vec<usize> {
    let part = |u: &Unit| &product.parts[usize::from(u.part)];
    let is_opaque_other = |u: &Unit| part(u).role != Role::Leaf && !part(u).is_transparent;
    let are_told_apart = is_door || units.iter().any(is_opaque_other);
    let is_named = |u: &Unit| part(u).role == Role::Leaf && are_told_apart;
    let is_frame = |u: &Unit| match part(u).role {
        Role::Frame if !is_door => true,
        Role::Unknown | Role::Leaf if is_named(u) || part(u).is_transparent => false,
        // The stiles and rails of a door's leaf are called a frame, too.
        _ => outline.is_reached_by(u, if is_door { MAX_THRESHOLD } else { f64::INFINITY }),
    };
    let inner: Vec<&Unit> = units.iter().filter(|u| !is_frame(u)).collect();
    let is_pane = |u: &Unit| !is_door && (part(u).is_transparent || outline.fill(u, product) > PLATE);
    let solid = inner.iter().copied().filter(|u| is_named(u) || !is_pane(u)).collect();
    let is_leaf = |group: &Vec<&Unit>| {
        let stands = || outline.sides(group, product).iter().all(|&s| s >= MIN_SIDE);
        group.iter().any(|u| is_named(u)) || (outline.is_large(group, MIN_LEAF) && stands())
    };
    let leaves: Vec<Unit> = outline.groups(solid).into_iter().filter(is_leaf).map(|g| Unit::around(&g)).collect();
    let moving = inner.into_iter().filter(|u| leaves.iter().any(|leaf| outline.is_within(u, leaf)));
    moving.flat_map(|u| u.triangles.iter().copied()).collect()
}

/// Marks triangles' parts as movable; a part of which only some move is parted.
fn set(product: &mut Product, moving: &[usize]) {
    let mut moves = vec![false; product.triangles.len()];
    moving.iter().for_each(|&t| moves[t] = true);
    for p in 0..product.parts.len() {
        let of_part = || (0..moves.len()).filter(|&t| usize::from(product.part_numbers[t]) == p);
        if !of_part().any(|t| moves[t]) {
            continue;
        }
        if of_part().all(|t| moves[t]) {
            product.parts[p].is_movable = true;
            continue;
        }
        let own: Vec<usize> = of_part().filter(|&t| moves[t]).collect();
        let apart = Part { is_movable: true, ..product.parts[p].clone() };
        let number = product.number_for(apart);
        own.into_iter().for_each(|t| product.part_numbers[t] = number);
    }
}
