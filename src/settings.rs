//! What `SET` and `SHOW` know.

use std::ffi::CStr;
use std::sync::OnceLock;

use pgrx::{GucContext, GucFlags, GucRegistry, GucSetting};

static MAX_GRID_MEMORY_KB: GucSetting<i32> = GucSetting::<i32>::new(1 << 20);

static MAX_EVIDENCE_MEMORY_KB: GucSetting<i32> = GucSetting::<i32>::new(2 << 20);

/// 0: half of the machine.
static MEMORY_CEILING_KB: GucSetting<i32> = GucSetting::<i32>::new(0);

/// Declares the settings; called once when the library is loaded.
pub fn declare() {
    memory(
        c"asbuilt.max_grid_memory",
        c"Most memory that voxel grids take in a process.",
        c"Beyond it a query ends with an error; aggregate tile by tile (ab_tiles), or use larger voxels. Like work_mem it holds for each process of a parallel query; asbuilt.memory_ceiling is its limit.",
        &MAX_GRID_MEMORY_KB,
        GucContext::Userset,
    );
    memory(
        c"asbuilt.max_evidence_memory",
        c"Most memory that evidence takes in a process.",
        c"Beyond it a query ends with an error; verify storey by storey, or with samples farther apart. Like work_mem it holds for each process of a parallel query; asbuilt.memory_ceiling is its limit.",
        &MAX_EVIDENCE_MEMORY_KB,
        GucContext::Userset,
    );
    memory(
        c"asbuilt.memory_ceiling",
        c"Most memory that asbuilt takes in a process, whatever the other settings say.",
        c"0 stands for half of the machine's (or of the control group's) memory.",
        &MEMORY_CEILING_KB,
        GucContext::Suset,
    );
    // A setting of ours that does not exist is an error from now on.
    crate::pg::reserve_settings(c"asbuilt");
}

fn memory(
    name: &'static CStr,
    short: &'static CStr,
    long: &'static CStr,
    setting: &'static GucSetting<i32>,
    context: GucContext,
) {
    let least = if setting.get() == 0 { 0 } else { 1024 };
    GucRegistry::define_int_guc(name, short, long, setting, least, i32::MAX, context, GucFlags::UNIT_KB);
}

fn bytes(setting: &GucSetting<i32>) -> usize {
    usize::try_from(setting.get()).unwrap_or(0) << 10
}

/// Bytes that evidence may take in this process.
pub fn max_evidence_memory() -> usize {
    bytes(&MAX_EVIDENCE_MEMORY_KB)
}

/// Bytes that voxel grids may take in this process.
pub fn max_grid_memory() -> usize {
    bytes(&MAX_GRID_MEMORY_KB)
}

/// Bytes that all together may take in this process.
pub fn memory_ceiling() -> usize {
    match bytes(&MEMORY_CEILING_KB) {
        0 => *HALF_OF_THE_MACHINE.get_or_init(|| machine_memory() / 2),
        ceiling => ceiling,
    }
}

static HALF_OF_THE_MACHINE: OnceLock<usize> = OnceLock::new();

/// Bytes that this machine has, or that the control group may take; a terabyte where neither is known.
fn machine_memory() -> usize {
    let told = std::fs::read_to_string("/proc/meminfo").ok();
    let kilobytes = told.as_deref().and_then(|t| t.lines().next()?.split_whitespace().nth(1)?.parse::<usize>().ok());
    let group = std::fs::read_to_string("/sys/fs/cgroup/memory.max").ok().and_then(|t| t.trim().parse().ok());
    let machine = kilobytes.map_or(1 << 40, |kb| kb << 10);
    group.map_or(machine, |limit: usize| limit.min(machine))
}
