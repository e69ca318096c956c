//! What `SET` and `SHOW` know.

use pgrx::{GucContext, GucFlags, GucRegistry, GucSetting};

static MAX_GRID_MEMORY_KB: GucSetting<i32> = GucSetting::<i32>::new(1 << 20);

static MAX_EVIDENCE_MEMORY_KB: GucSetting<i32> = GucSetting::<i32>::new(2 << 20);

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
    GucRegistry::define_int_guc(
        c"asbuilt.max_evidence_memory",
        c"Most memory that ab_verify_table takes for evidence.",
        c"Beyond it the query ends with an error; verify storey by storey, or with samples farther apart.",
        &MAX_EVIDENCE_MEMORY_KB,
        1024,
        i32::MAX,
        GucContext::Userset,
        GucFlags::UNIT_KB,
    );
}

/// Bytes that the evidence of one call of `ab_verify_table` may take.
pub fn max_evidence_memory() -> usize {
    usize::try_from(MAX_EVIDENCE_MEMORY_KB.get()).unwrap_or(0) << 10
}

/// Bytes that voxel grids may take in this process.
pub fn max_grid_memory() -> usize {
    usize::try_from(MAX_GRID_MEMORY_KB.get()).unwrap_or(0) << 10
}
