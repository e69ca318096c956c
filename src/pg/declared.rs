//! What the functions of [`super::sql_functions`] expect SQL to declare, and how their arguments are bound.

use asbuilt_core::Result;

use super::{Args, FromArg};

/// One parameter.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    sql_type: &'static str,
    nullable: bool,
}

impl Parameter {
    /// The parameter that `T` reads.
    pub const fn of<'a, T: FromArg<'a>>() -> Self {
        Self { sql_type: T::SQL_TYPE, nullable: T::NULLABLE }
    }
}

/// One function: its C symbol and its parameters.
#[derive(Debug, Clone, Copy)]
pub struct Declared {
    /// The symbol, `pg_proc.prosrc`.
    pub symbol: &'static str,
    /// In order.
    pub parameters: &'static [Parameter],
}

impl Declared {
    /// `ab_box_expand ab_box float8`: the symbol, then the types, with a question mark where NULL is a value.
    pub fn to_text(self) -> String {
        let word = |p: &Parameter| format!(" {}{}", p.sql_type, if p.nullable { "?" } else { "" });
        self.symbol.to_owned() + &self.parameters.iter().map(word).collect::<String>()
    }
}

/// Whether an argument is NULL that must not be.
pub fn lacks(args: &Args, parameters: &[Parameter]) -> bool {
    parameters.iter().enumerate().any(|(i, p)| !p.nullable && args.is_null(i))
}

/// The value of argument `i`, and one more in `i`.
pub fn next_arg<'a, T: FromArg<'a>>(args: &'a Args, i: &mut usize) -> Result<T> {
    *i += 1;
    T::from_arg(args, *i - 1)
}
