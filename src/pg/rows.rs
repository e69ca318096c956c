//! Returning rows: one composite, or a materialised set.

use asbuilt_core::evidence::Loa;
use asbuilt_core::{Error, Result};
use pgrx::pg_sys;

use super::encoding::to_server;
use super::scratch::scratch_context;
use super::sql_value::{fixed, varlena};
use super::{Args, array};

/// One column of a returned row.
#[derive(Debug, Clone)]
pub enum RowField {
    /// NULL.
    Null,
    /// `integer`.
    I32(i32),
    /// `bigint`.
    I64(i64),
    /// `float8`.
    F64(f64),
    /// `text`.
    Text(String),
    /// One of our variable-length types.
    Bytes(Vec<u8>),
    /// The enum `ab_loa`.
    Loa(Loa),
    /// A value of another enum, by its label.
    Enum(&'static str),
    /// `float8[]` of three numbers.
    Vector([f64; 3]),
    /// `float8[]` of three numbers along x, y and z, NULL where one is not known.
    Axes([Option<f64>; 3]),
    /// `float8[]` with dimensions.
    Array(Vec<f64>, Vec<i32>),
    /// `integer[]` of one dimension.
    I32Array(Vec<i32>),
    /// `boolean`.
    Bool(bool),
    /// A fixed-length type passed by reference.
    Fixed(Vec<u8>),
}

impl RowField {
    /// NULL for `None`.
    pub fn or_null<T>(value: Option<T>, field: impl FnOnce(T) -> Self) -> Self {
        value.map_or(Self::Null, field)
    }

    fn datum(&self, column_type: pg_sys::Oid) -> Option<pg_sys::Datum> {
        Some(match self {
            Self::Null => return None,
            Self::I32(v) => pg_sys::Datum::from(*v),
            Self::I64(v) => pg_sys::Datum::from(*v),
            Self::F64(v) => pg_sys::Datum::from(v.to_bits() as usize),
            Self::Text(s) => varlena(&to_server(s)),
            Self::Bytes(b) => varlena(b),
            Self::Loa(l) => pg_sys::Datum::from(enum_value(column_type, l.name())),
            Self::Enum(label) => pg_sys::Datum::from(enum_value(column_type, label)),
            Self::Vector(v) => array::of_f64(v, &[3]),
            Self::Axes(v) => array::of_axes(v),
            Self::Array(v, dims) => array::of_f64(v, dims),
            Self::I32Array(v) => array::of_i32(v, &[v.len() as i32]),
            Self::Bool(b) => pg_sys::Datum::from(*b),
            Self::Fixed(b) => fixed(b),
        })
    }
}

/// The oid of an enum's value, found by the type's oid so that the search path does not matter.
fn enum_value(enum_type: pg_sys::Oid, label: &str) -> pg_sys::Oid {
    let label = std::ffi::CString::new(label).unwrap_or_default();
    unsafe {
        let tuple = pg_sys::SearchSysCache2(
            pg_sys::SysCacheIdentifier::ENUMTYPOIDNAME as i32,
            enum_type.into(),
            label.as_ptr().into(),
        );
        assert!(!tuple.is_null(), "an enum has lost its value {label:?}");
        let oid = (*pg_sys::GETSTRUCT(tuple).cast::<pg_sys::FormData_pg_enum>()).oid;
        pg_sys::ReleaseSysCache(tuple);
        oid
    }
}

/// The row type that the call expects; a set of plain values is one of one column.
unsafe fn expected_row(fcinfo: pg_sys::FunctionCallInfo) -> pg_sys::TupleDesc {
    unsafe {
        let mut desc: pg_sys::TupleDesc = std::ptr::null_mut();
        let mut plain = pg_sys::InvalidOid;
        match pg_sys::get_call_result_type(fcinfo, &mut plain, &mut desc) {
            pg_sys::TypeFuncClass::TYPEFUNC_COMPOSITE => desc,
            pg_sys::TypeFuncClass::TYPEFUNC_SCALAR => {
                let desc = pg_sys::CreateTemplateTupleDesc(1);
                pg_sys::TupleDescInitEntry(desc, 1, c"value".as_ptr(), plain, -1, 0);
                desc
            }
            class => panic!("the function returns neither rows nor values but {class}"),
        }
    }
}

/// The row type of a call, looked up once a query: it is kept where the function's call site keeps its own data.
unsafe fn remembered_row(fcinfo: pg_sys::FunctionCallInfo) -> pg_sys::TupleDesc {
    unsafe {
        let site = (*fcinfo).flinfo;
        if (*site).fn_extra.is_null() {
            let before = pg_sys::MemoryContextSwitchTo((*site).fn_mcxt);
            let desc = pg_sys::BlessTupleDesc(pg_sys::CreateTupleDescCopy(expected_row(fcinfo)));
            pg_sys::MemoryContextSwitchTo(before);
            (*site).fn_extra = desc.cast();
        }
        (*site).fn_extra.cast()
    }
}

unsafe fn values(desc: pg_sys::TupleDesc, fields: &[RowField]) -> (Vec<pg_sys::Datum>, Vec<bool>) {
    let natts = unsafe { (*desc).natts } as usize;
    assert!(natts == fields.len(), "{natts} columns declared, {} given", fields.len());
    let mut nulls = vec![false; natts];
    let mut datums = vec![pg_sys::Datum::from(0usize); natts];
    for (i, field) in fields.iter().enumerate() {
        let column_type = unsafe { (*(*desc).attrs.as_ptr().add(i)).atttypid };
        match field.datum(column_type) {
            Some(d) => datums[i] = d,
            None => nulls[i] = true,
        }
    }
    (datums, nulls)
}

/// One row as a composite value.
///
/// # Safety
/// `fcinfo` must be the pointer PostgreSQL called the function with.
pub unsafe fn composite(fcinfo: pg_sys::FunctionCallInfo, fields: &[RowField]) -> pg_sys::Datum {
    unsafe {
        let desc = remembered_row(fcinfo);
        let (mut datums, mut nulls) = values(desc, fields);
        let tuple = pg_sys::heap_form_tuple(desc, datums.as_mut_ptr(), nulls.as_mut_ptr());
        pg_sys::HeapTupleHeaderGetDatum((*tuple).t_data)
    }
}

/// A materialised set of rows: spills to disk beyond `work_mem`.
#[derive(Debug)]
pub struct Rows {
    store: *mut pg_sys::Tuplestorestate,
    desc: pg_sys::TupleDesc,
    /// Holds one row's values; emptied after each.
    scratch: pg_sys::MemoryContext,
}

impl Rows {
    /// Starts the set that the call returns.
    pub fn new(args: &Args) -> Result<Self> {
        unsafe {
            let fcinfo = args.fcinfo();
            let info = (*fcinfo).resultinfo.cast::<pg_sys::ReturnSetInfo>();
            let materialise = pg_sys::SetFunctionReturnMode::SFRM_Materialize;
            if info.is_null() || (*info).allowedModes as u32 & materialise == 0 {
                return Err(Error::argument("a set-returning function", "in FROM or a select list", "elsewhere"));
            }
            let before = pg_sys::MemoryContextSwitchTo((*(*info).econtext).ecxt_per_query_memory);
            let desc = pg_sys::CreateTupleDescCopy(expected_row(fcinfo));
            let random = pg_sys::SetFunctionReturnMode::SFRM_Materialize_Random;
            let store =
                pg_sys::tuplestore_begin_heap((*info).allowedModes as u32 & random != 0, false, pg_sys::work_mem);
            (*info).returnMode = materialise;
            (*info).setResult = store;
            (*info).setDesc = desc;
            pg_sys::MemoryContextSwitchTo(before);
            Ok(Self { store, desc, scratch: scratch_context(c"asbuilt rows") })
        }
    }

    /// Number of columns that the call expects.
    pub fn width(&self) -> usize {
        unsafe { (*self.desc).natts as usize }
    }

    /// Adds a row.
    pub fn push(&mut self, fields: &[RowField]) {
        unsafe {
            let before = pg_sys::MemoryContextSwitchTo(self.scratch);
            let (mut datums, mut nulls) = values(self.desc, fields);
            pg_sys::tuplestore_putvalues(self.store, self.desc, datums.as_mut_ptr(), nulls.as_mut_ptr());
            pg_sys::MemoryContextSwitchTo(before);
            pg_sys::MemoryContextReset(self.scratch);
        }
    }
}
