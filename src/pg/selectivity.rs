//! The input of a selectivity estimator: an operator's arguments as the planner knows them.

use pgrx::pg_sys;
use pgrx::pg_sys::ffi::pg_guard_ffi_boundary;

use super::analyze::BOX_STATISTICS;
use super::{Args, own_type_name};

/// What the planner knows of a column: statistics of ours, if it was analysed.
#[derive(Debug)]
pub struct ColumnStatistics {
    /// Name of its type, if it is one of ours.
    pub type_name: Option<String>,
    /// Share of rows that are not NULL.
    pub present: f64,
    /// What ANALYZE kept.
    pub numbers: Option<Vec<f64>>,
    /// Rows of its table that reach the operator.
    pub rows: f64,
}

/// The side of an operator that is not the column.
#[derive(Debug)]
pub enum Other {
    /// A value of a type of ours, as argument 0, and the type's name.
    Value(Args, String),
    /// NULL.
    Null,
    /// A column of another table.
    Column(ColumnStatistics),
    /// Known only when the query runs.
    Unknown,
}

/// `column OP other`, or the other way round.
#[derive(Debug)]
pub struct Restriction {
    /// The column.
    pub column: ColumnStatistics,
    /// What it is compared with.
    pub other: Other,
    /// Whether the column stands on the left.
    pub column_on_left: bool,
}

/// The arguments (root, operator, args, varRelid) of a restriction estimator; `None` where no column can be told.
pub fn restriction(args: &Args) -> Option<Restriction> {
    unsafe {
        let (root, list) = (args.datum(0).cast_mut_ptr(), args.datum(2).cast_mut_ptr());
        let mut data = pg_sys::VariableStatData::default();
        let (mut node, mut column_on_left) = (std::ptr::null_mut(), false);
        if !pg_sys::get_restriction_variable(root, list, args.i32(3), &mut data, &mut node, &mut column_on_left) {
            return None;
        }
        let column = known(args, &mut data);
        let other = other(args, root, pg_sys::estimate_expression_value(root, node));
        release(&data);
        Some(Restriction { column, other, column_on_left })
    }
}

unsafe fn other(args: &Args, root: *mut pg_sys::PlannerInfo, node: *mut pg_sys::Node) -> Other {
    unsafe {
        if pgrx::nodes::is_a(node, pg_sys::NodeTag::T_Const) {
            let constant = &*node.cast::<pg_sys::Const>();
            return match own_type_name(args, constant.consttype) {
                _ if constant.constisnull => Other::Null,
                Some(name) => Other::Value(Args::of_value(constant.constvalue), name),
                None => Other::Unknown,
            };
        }
        let mut data = pg_sys::VariableStatData::default();
        pg_sys::examine_variable(root, node, 0, &mut data);
        let column = known(args, &mut data);
        release(&data);
        if column.numbers.is_some() { Other::Column(column) } else { Other::Unknown }
    }
}

/// `left OP right` between columns of two tables.
#[derive(Debug)]
pub struct Join {
    /// The left column.
    pub left: ColumnStatistics,
    /// The right column.
    pub right: ColumnStatistics,
    /// For a semi or anti join, the rows of the inner side.
    pub inner_rows: Option<f64>,
}

/// The arguments (root, operator, args, jointype, sjinfo) of a join estimator.
pub fn join(args: &Args) -> Join {
    unsafe {
        let (root, list) = (args.datum(0).cast_mut_ptr(), args.datum(2).cast_mut_ptr());
        let special: *mut pg_sys::SpecialJoinInfo = args.datum(4).cast_mut_ptr();
        let mut data = [pg_sys::VariableStatData::default(), pg_sys::VariableStatData::default()];
        let mut reversed = false;
        let [first, second] = &mut data;
        pg_sys::get_join_variables(root, list, special, first, second, &mut reversed);
        let [left, right] = [known(args, first), known(args, second)];
        data.iter().for_each(|d| release(d));
        let kind = (*special).jointype;
        let semi = kind == pg_sys::JoinType::JOIN_SEMI || kind == pg_sys::JoinType::JOIN_ANTI;
        let inner_rows = semi.then_some(if reversed { left.rows } else { right.rows });
        Join { left, right, inner_rows }
    }
}

/// What is known about a column, as far as the user may know it: as with PostgreSQL's own estimators, an operator that
/// is not leakproof is told nothing about rows that row-level security or missing rights hide.
unsafe fn known(args: &Args, data: &mut pg_sys::VariableStatData) -> ColumnStatistics {
    unsafe {
        let rows = if data.rel.is_null() { 1.0 } else { (*data.rel).rows.max(1.0) };
        let mut out =
            ColumnStatistics { type_name: own_type_name(args, data.vartype), present: 1.0, numbers: None, rows };
        if data.statsTuple.is_null() {
            return out;
        }
        let row = pg_sys::GETSTRUCT(data.statsTuple).cast::<pg_sys::FormData_pg_statistic>();
        out.present = 1.0 - f64::from((*row).stanullfrac);
        let operator = pg_sys::get_opcode(pg_sys::Oid::from(args.datum(1).value() as u32));
        if !pg_sys::statistic_proc_security_check(data, operator) {
            return out;
        }
        let mut slot = pg_sys::AttStatsSlot::default();
        let (kind, values) = (i32::from(BOX_STATISTICS), pg_sys::ATTSTATSSLOT_VALUES as i32);
        if pg_sys::get_attstatsslot(&mut slot, data.statsTuple, kind, pg_sys::InvalidOid, values) {
            if slot.valuetype == pg_sys::FLOAT8OID {
                let number = |i: usize| f64::from_bits((*slot.values.add(i)).value() as u64);
                out.numbers = Some((0..slot.nvalues as usize).map(number).collect());
            }
            pg_sys::free_attstatsslot(&mut slot);
        }
        out
    }
}

unsafe fn release(data: &pg_sys::VariableStatData) {
    if let (false, Some(free)) = (data.statsTuple.is_null(), data.freefunc) {
        unsafe { pg_guard_ffi_boundary(|| free(data.statsTuple)) };
    }
}
