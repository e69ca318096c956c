//! ANALYZE: statistics of our own about a column.

use pgrx::pg_sys;
use pgrx::pg_sys::submodules::panic::pgrx_extern_c_guard;

use super::{Args, Ret, interrupt, type_name};

/// Kind of our statistics in `pg_statistic`; numbers from 10000 on are for private use.
pub const BOX_STATISTICS: i16 = 11_820;

/// Makes the numbers that are kept about a column.
pub trait Statistics {
    /// From the sampled values, each as argument 0, of the type named; `None` for nothing to say.
    fn of(type_name: &str, sample: &mut dyn Iterator<Item = Args>) -> Option<Vec<f64>>;
}

/// typanalyze(internal): has the column in argument 0 analysed by `S`; how many rows are sampled follows its statistics
/// target.
pub fn analysed_by<S: Statistics>(args: &Args) -> Ret {
    unsafe {
        let column: *mut pg_sys::VacAttrStats = args.datum(0).cast_mut_ptr();
        if !pg_sys::std_typanalyze(column) {
            return Ret::Bool(false);
        }
        (*column).compute_stats = Some(compute::<S>);
        Ret::Bool(true)
    }
}

unsafe extern "C-unwind" fn compute<S: Statistics>(
    column: *mut pg_sys::VacAttrStats,
    fetch: pg_sys::AnalyzeAttrFetchFunc,
    rows: std::ffi::c_int,
    _total: f64,
) {
    unsafe {
        pgrx_extern_c_guard(move || {
            let Some(fetch) = fetch else { return };
            let (mut nulls, mut width) = (0, 0);
            let mut sample = (0..rows).filter_map(|row| {
                interrupt();
                let mut null = false;
                let value = fetch(column, row, &mut null);
                if null {
                    nulls += 1;
                    return None;
                }
                width += stored_width(column, value);
                Some(Args::of_value(value))
            });
            let numbers = S::of(&type_name((*column).attrtypid), &mut sample);
            sample.for_each(drop);
            if rows > 0 {
                keep(column, rows, nulls, width, numbers);
            }
        });
    }
}

unsafe fn stored_width(column: *mut pg_sys::VacAttrStats, value: pg_sys::Datum) -> usize {
    unsafe {
        match (*(*column).attrtype).typlen {
            -1 => pgrx::varlena::varsize_any(value.cast_mut_ptr()),
            len => len as usize,
        }
    }
}

/// Fills in what every column has, and the numbers as the first slot.
unsafe fn keep(column: *mut pg_sys::VacAttrStats, rows: i32, nulls: i32, width: usize, numbers: Option<Vec<f64>>) {
    unsafe {
        let c = &mut *column;
        c.stats_valid = true;
        c.stanullfrac = nulls as f32 / rows as f32;
        c.stawidth = (width / (rows - nulls).max(1) as usize) as i32;
        // Nearly all values differ.
        c.stadistinct = -(1.0 - c.stanullfrac);
        let Some(numbers) = numbers else { return };
        let bytes = numbers.len() * size_of::<pg_sys::Datum>();
        let values: *mut pg_sys::Datum = pg_sys::MemoryContextAlloc(c.anl_context, bytes).cast();
        for (i, x) in numbers.iter().enumerate() {
            values.add(i).write(pg_sys::Datum::from(x.to_bits() as usize));
        }
        c.stakind[0] = BOX_STATISTICS;
        c.stavalues[0] = values;
        c.numvalues[0] = numbers.len() as i32;
        c.statypid[0] = pg_sys::FLOAT8OID;
        c.statyplen[0] = size_of::<f64>() as i16;
        c.statypbyval[0] = true;
        c.statypalign[0] = b'd' as std::ffi::c_char;
    }
}
