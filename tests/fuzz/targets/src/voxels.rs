//! Occupancies and changes out of their stored forms.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::voxel::{ChangeClass, ChangeSettings, Occupancy, VoxelChange};

use crate::bounded;
use crate::checksum::mended;

pub fn occupancy(data: &[u8]) {
    for bytes in [data.to_vec(), mended(data)] {
        let _ = Occupancy::header(&bytes);
        let Ok(o) = bounded(|i| Occupancy::from_bytes(&bytes, i)) else { continue };
        let Ok(stored) = bounded(|i| o.to_bytes(i)) else { continue };
        match bounded(|i| Occupancy::from_bytes(&stored, i)) {
            Ok(again) => assert_eq!(o, again, "an occupancy changed through its bytes"),
            Err(asbuilt_core::Error::Interrupted) => {}
            Err(e) => panic!("an occupancy is refused as its own bytes: {e}"),
        }
        questions(&o);
    }
}

fn questions(o: &Occupancy) {
    let _ = bounded(|i| o.for_each(1, i, |_, _, _| ()));
    let _ = bounded(|i| o.tally(3, None, i));
    let _ = bounded(|i| o.denoised(2, 1, i));
    let _ = bounded(|i| o.downsampled(i));
    let _ = bounded(|i| o.clipped(&lower_half(&o.grid().tile), i));
    for axis in 0..3 {
        // A picture of the whole slice: only of small ones, as SQL would refuse large ones.
        let _ = bounded(|i| o.slice(axis, o.grid().tile.centre()[axis].clamp(-1e3, 1e3), 1, i));
    }
    let mut twice = o.clone();
    let _ = bounded(|i| twice.merge(o, i));
    for tolerance in [0.0, o.grid().voxel] {
        let settings = ChangeSettings { threshold: 1, tolerance };
        if let Ok(c) = bounded(|i| VoxelChange::between(o, &twice, settings, i)) {
            questions_of_change(&c);
        }
    }
}

pub fn change(data: &[u8]) {
    for bytes in [data.to_vec(), mended(data)] {
        let _ = VoxelChange::header(&bytes);
        let Ok(c) = bounded(|i| VoxelChange::from_bytes(&bytes, i)) else { continue };
        let Ok(stored) = bounded(|i| c.to_bytes(i)) else { continue };
        match bounded(|i| VoxelChange::from_bytes(&stored, i)) {
            Ok(again) => assert_eq!(c, again, "a change changed through its bytes"),
            Err(asbuilt_core::Error::Interrupted) => {}
            Err(e) => panic!("a change is refused as its own bytes: {e}"),
        }
        questions_of_change(&c);
    }
}

fn questions_of_change(c: &VoxelChange) {
    let _ = bounded(|i| c.for_each(i, |_, _| ()));
    for class in [ChangeClass::New, ChangeClass::Disappeared, ChangeClass::Confirmed] {
        let _ = bounded(|i| c.components(class, 1, c.grid().voxel, i));
    }
    let _ = bounded(|i| c.tally(None, 0.0, i));
    let _ = bounded(|i| c.clipped(&lower_half(&c.grid().tile), i));
    let mut twice = c.clone();
    let _ = bounded(|i| twice.merge(c, i));
}

fn lower_half(tile: &Aabb) -> Aabb {
    Aabb { min: tile.min, max: tile.centre().into() }
}
