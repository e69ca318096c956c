//! ANALYZE: statistics of our own about a column, beside PostgreSQL's.

use pgrx::pg_sys;
use pgrx::pg_sys::ffi::pg_guard_ffi_boundary;
use pgrx::pg_sys::submodules::panic::pgrx_extern_c_guard;

use super::scratch::scratch_context;
use super::{Args, SqlValue, own_type_name};

/// Kind of our statistics in `pg_statistic`; numbers from 10000 on are for private use.
pub const BOX_STATISTICS: i16 = 11_820;

/// Makes the numbers that are kept about a column.
pub trait Statistics {
    /// From the sampled values of the named type, each as argument 0; `None` where there is nothing to say.
    fn of(type_name: &str, sample: &mut dyn Iterator<Item = Args>) -> Option<Vec<f64>>;
}

/// What is kept in the column's `extra_data` until it is analysed.
struct Plan {
    type_name: String,
    standard: pg_sys::AnalyzeAttrComputeStatsFunc,
    standard_data: *mut std::ffi::c_void,
}

/// typanalyze(internal): has the column in argument 0 analysed as usual, and then by `S`; its statistics target decides
/// how many rows are sampled.
pub fn analysed_by<S: Statistics>(args: &Args) -> SqlValue {
    unsafe {
        let column: *mut pg_sys::VacAttrStats = args.datum(0).cast_mut_ptr();
        if !pg_sys::std_typanalyze(column) {
            return SqlValue::Bool(false);
        }
        if let Some(type_name) = own_type_name(args, (*column).attrtypid) {
            let plan = Plan { type_name, standard: (*column).compute_stats, standard_data: (*column).extra_data };
            let context = pgrx::PgMemoryContexts::For((*column).anl_context);
            (*column).extra_data = { context }.leak_and_drop_on_delete(plan).cast();
            (*column).compute_stats = Some(compute::<S>);
        }
        SqlValue::Bool(true)
    }
}

unsafe extern "C-unwind" fn compute<S: Statistics>(
    column: *mut pg_sys::VacAttrStats,
    fetch: pg_sys::AnalyzeAttrFetchFunc,
    rows: std::ffi::c_int,
    total: f64,
) {
    unsafe {
        pgrx_extern_c_guard(move || {
            let plan = &*(*column).extra_data.cast::<Plan>();
            (*column).extra_data = plan.standard_data;
            // PostgreSQL's own functions, called by their addresses: pgrx guards those only that it knows by name.
            if let Some(standard) = plan.standard {
                pg_guard_ffi_boundary(|| standard(column, fetch, rows, total));
            }
            let (Some(fetch), true) = (fetch, (*column).stats_valid) else { return };
            // What a value needs is given back before the next.
            let scratch = scratch_context(c"asbuilt analyze");
            let before = pg_sys::MemoryContextSwitchTo(scratch);
            let mut sample = (0..rows).filter_map(|row| {
                pg_sys::vacuum_delay_point();
                pg_sys::MemoryContextReset(scratch);
                let mut null = false;
                let value = pg_guard_ffi_boundary(|| fetch(column, row, &mut null));
                (!null).then(|| Args::of_value(value))
            });
            let numbers = S::of(&plan.type_name, &mut sample);
            pg_sys::MemoryContextSwitchTo(before);
            pg_sys::MemoryContextDelete(scratch);
            if let Some(numbers) = numbers {
                keep(column, &numbers);
            }
        });
    }
}

/// Puts the numbers into the first slot that is free.
unsafe fn keep(column: *mut pg_sys::VacAttrStats, numbers: &[f64]) {
    unsafe {
        let c = &mut *column;
        let Some(slot) = c.stakind.iter().position(|&kind| kind == 0) else { return };
        let values: *mut pg_sys::Datum = pg_sys::MemoryContextAlloc(c.anl_context, size_of_val(numbers)).cast();
        for (i, x) in numbers.iter().enumerate() {
            values.add(i).write(pg_sys::Datum::from(x.to_bits() as usize));
        }
        c.stakind[slot] = BOX_STATISTICS;
        c.stavalues[slot] = values;
        c.numvalues[slot] = numbers.len() as i32;
        c.statypid[slot] = pg_sys::FLOAT8OID;
        c.statyplen[slot] = size_of::<f64>() as i16;
        c.statypbyval[slot] = true;
        c.statypalign[slot] = b'd' as std::ffi::c_char;
    }
}
