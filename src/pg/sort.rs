//! Sorting keys by one number each, for a sorted index build.

use pgrx::pg_sys;
use pgrx::pg_sys::submodules::panic::pgrx_extern_c_guard;

use super::{Args, SqlValue};

// By its own address PostgreSQL knows it and sorts without calling it; pgrx has a wrapper only.
unsafe extern "C-unwind" {
    fn ssup_datum_unsigned_cmp(x: pg_sys::Datum, y: pg_sys::Datum, support: pg_sys::SortSupport) -> std::ffi::c_int;
}

/// The number that a fixed-length key of `N` bytes is sorted by.
pub trait SortKey<const N: usize> {
    /// The value's number.
    fn of(key: &[u8; N]) -> u64;
}

/// sortsupport(internal): keys are compared by these numbers, which are kept beside them where the sort allows.
pub fn sorted_by<P: SortKey<N>, const N: usize>(args: &Args) -> SqlValue {
    unsafe {
        let support = &mut *args.datum(0).cast_mut_ptr::<pg_sys::SortSupportData>();
        support.comparator = Some(compare::<P, N>);
        if support.abbreviate {
            support.comparator = Some(ssup_datum_unsigned_cmp);
            support.abbrev_converter = Some(place::<P, N>);
            support.abbrev_abort = Some(never);
            support.abbrev_full_comparator = Some(compare::<P, N>);
        }
        SqlValue::Raw(pg_sys::Datum::from(0usize))
    }
}

unsafe extern "C-unwind" fn compare<P: SortKey<N>, const N: usize>(
    x: pg_sys::Datum,
    y: pg_sys::Datum,
    _support: pg_sys::SortSupport,
) -> std::ffi::c_int {
    unsafe { pgrx_extern_c_guard(|| place_of::<P, N>(x).cmp(&place_of::<P, N>(y)) as std::ffi::c_int) }
}

unsafe extern "C-unwind" fn place<P: SortKey<N>, const N: usize>(
    key: pg_sys::Datum,
    _support: pg_sys::SortSupport,
) -> pg_sys::Datum {
    unsafe { pgrx_extern_c_guard(|| pg_sys::Datum::from(place_of::<P, N>(key) as usize)) }
}

unsafe fn place_of<P: SortKey<N>, const N: usize>(key: pg_sys::Datum) -> u64 {
    P::of(unsafe { &*key.cast_mut_ptr::<[u8; N]>() })
}

unsafe extern "C-unwind" fn never(_tuples: std::ffi::c_int, _support: pg_sys::SortSupport) -> bool {
    false
}
