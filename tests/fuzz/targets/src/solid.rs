//! Meshes: stored form, built, EWKB.

use asbuilt_core::geometry::{Aabb, Solid, SurfaceKind, Vec3, group_faces};
use asbuilt_core::verify::Samples;
use asbuilt_core::voxel::{FillRule, Grid, VoxelSet};

use crate::bounded;
use crate::checksum::mended;
use crate::input::Input;

pub fn decode(data: &[u8]) {
    for bytes in [data.to_vec(), mended(data)] {
        let _ = Solid::header(&bytes);
        let _ = bounded(|i| Solid::from_stored(&bytes, i)).map(|s| questions(&s));
        if let Ok(solid) = bounded(|i| Solid::from_bytes(&bytes, i)) {
            round_trip(&solid);
            questions(&solid);
        }
    }
}

pub fn build(data: &[u8]) {
    let mut input = Input(data);
    let n = usize::from(input.byte() % 24) + 1;
    let vertices: Vec<Vec3> = (0..n).map(|_| Vec3::from(input.vector())).collect();
    let mut triangles = vec![];
    while !input.is_empty() && triangles.len() < 100 {
        triangles.push([0; 3].map(|_| u32::from(input.byte()) % (n as u32 + 1)));
    }
    if let Ok(solid) = bounded(|i| Solid::interruptible(vertices, triangles, i)) {
        round_trip(&solid);
        questions(&solid);
    }
}

pub fn ewkb(data: &[u8]) {
    if let Ok(solid) = bounded(|i| Solid::from_ewkb(data, i)) {
        round_trip(&solid);
        questions(&solid);
    }
}

fn round_trip(solid: &Solid) {
    let Ok(bytes) = bounded(|i| solid.to_bytes(i)) else { return };
    match bounded(|i| Solid::from_bytes(&bytes, i)) {
        // The volume of an open surface is not a number, so unequal to itself: compare what is stored.
        Ok(again) => assert_eq!(bounded(|i| again.to_bytes(i)).ok(), Some(bytes), "a solid changed through its bytes"),
        Err(asbuilt_core::Error::Interrupted) => {}
        Err(e) => panic!("a solid is refused as its own bytes: {e}"),
    }
}

/// Every question that SQL puts to a solid.
fn questions(solid: &Solid) {
    let (bounds, area) = (solid.bounds(), solid.area());
    let _ = (solid.volume(), solid.closedness(), bounded(|i| solid.fingerprint(i)));
    for kind in [SurfaceKind::Polyhedral, SurfaceKind::Tin] {
        if let Ok(bytes) = bounded(|i| solid.to_ewkb(kind, i)) {
            let _ = bounded(|i| Solid::from_ewkb(&bytes, i));
        }
    }
    let _ = bounded(|i| group_faces(solid, i));
    // Some hundreds of samples, some thousands of voxels: the fuzzer's seconds are for many inputs.
    let spacing = (area / 400.0).sqrt();
    if spacing.is_finite() && spacing > 0.0 {
        let _ = bounded(|i| Samples::on(solid, spacing, i));
    }
    voxels(solid, &bounds);
}

fn voxels(solid: &Solid, bounds: &Aabb) {
    let voxel = (bounds.diagonal() / 24.0).clamp(1e-4, 100.0);
    let Ok(grid) = Grid::new(voxel, *bounds, 0.0, 0.0) else { return };
    for rule in [FillRule::Centre, FillRule::Cover, FillRule::Surface] {
        if let Ok(mask) = bounded(|i| VoxelSet::of(solid, &grid, rule, i)) {
            let _ = bounded(|i| mask.into_model(grid, i));
        }
    }
}
