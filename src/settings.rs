//! What `SET` and `SHOW` know.

use pgrx::{GucContext, GucFlags, GucRegistry, GucSetting};

static MAX_GRID_MEMORY_KB: GucSetting<i32> = GucSetting::<i32>::new(1 << 20);

/// Declares the settings; called once when the library is loaded.
pub fn declare() {
    GucRegistry::define_int_guc(
        c"asbuilt.max_grid_memory",
        c"Most memory that voxel grids take in a process.",
        c"Occupancy and change beyond it end with an error; aggregate tile by tile (ab_tiles), or use larger voxels.",
        &MAX_GRID_MEMORY_KB,
        1024,
        i32::MAX,
        GucContext::Userset,
        GucFlags::UNIT_KB,
    );
}

/// Bytes that voxel grids may take in this process.
pub fn max_grid_memory() -> usize {
    usize::try_from(MAX_GRID_MEMORY_KB.get()).unwrap_or(0) << 10
}
