//! Arguments by type: what a parameter of an SQL function is declared as, and how its value is read.

use asbuilt_core::Result;
use asbuilt_core::evidence::Loa;

use super::Args;

/// A parameter of an SQL function. Outside of `pg` it is implemented only upon another implementation.
pub trait FromArg<'a>: Sized {
    /// The SQL type that the function's declaration must name; `a|b` where it may be either.
    const SQL_TYPE: &'static str;
    /// Whether NULL is a value of it. NULL for any other parameter makes the result NULL.
    const NULLABLE: bool = false;

    /// The value of argument `i`, which is not NULL unless it may be.
    fn from_arg(args: &'a Args, i: usize) -> Result<Self>;
}

/// `None` is NULL, or an argument that the declaration leaves out at the end.
impl<'a, T: FromArg<'a>> FromArg<'a> for Option<T> {
    const SQL_TYPE: &'static str = T::SQL_TYPE;
    const NULLABLE: bool = true;

    fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
        args.has(i).then(|| T::from_arg(args, i)).transpose()
    }
}

/// A value that came with no call, whose type [`super::own_type_name`] told; `None` for another type or a damaged value.
pub fn own_value<'a, T: FromArg<'a>>(value: &'a Args, type_name: &str) -> Option<T> {
    T::SQL_TYPE.split('|').any(|name| name == type_name).then(|| T::from_arg(value, 0).ok()).flatten()
}

/// Types that one method of [`Args`] reads.
macro_rules! read_by {
    ($($type:ty, $sql_type:literal, $method:ident;)*) => {$(
        impl FromArg<'_> for $type {
            const SQL_TYPE: &'static str = $sql_type;

            fn from_arg(args: &Args, i: usize) -> Result<Self> {
                Ok(args.$method(i))
            }
        }
    )*};
}

read_by! {
    f64, "float8", f64;
    i64, "int8", i64;
    i32, "int4", i32;
    i16, "int2", i16;
    bool, "bool", bool;
    String, "text", text;
}

impl FromArg<'_> for Loa {
    const SQL_TYPE: &'static str = "ab_loa";

    fn from_arg(args: &Args, i: usize) -> Result<Self> {
        args.loa(i)
    }
}

/// Markers of arguments that are not read here: PostgreSQL's own structures, and types' oids.
macro_rules! unread {
    ($($(#[$meta:meta])* $type:ident, $sql_type:literal;)*) => {$(
        $(#[$meta])*
        #[derive(Debug)]
        pub struct $type;

        impl FromArg<'_> for $type {
            const SQL_TYPE: &'static str = $sql_type;

            fn from_arg(_: &Args, _: usize) -> Result<Self> {
                Ok(Self)
            }
        }
    )*};
}

unread! {
    /// A structure of the planner, of ANALYZE or of a sort.
    Internal, "internal";
    /// The oid of a type or an operator.
    Oid, "oid";
}

/// The text that an input function gets.
#[derive(Debug)]
pub struct TextInput<'a>(&'a [u8]);

impl<'a> FromArg<'a> for TextInput<'a> {
    const SQL_TYPE: &'static str = "cstring";

    fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
        Ok(Self(args.cstring_bytes(i)))
    }
}

impl<'a> TextInput<'a> {
    /// The text.
    pub fn text(&self) -> std::borrow::Cow<'a, str> {
        String::from_utf8_lossy(self.0)
    }

    /// The same, unchecked.
    pub fn bytes(&self) -> &'a [u8] {
        self.0
    }
}

/// The message that a receive function gets.
#[derive(Debug)]
pub struct Message<'a>(&'a Args, usize);

impl<'a> FromArg<'a> for Message<'a> {
    const SQL_TYPE: &'static str = "internal";

    fn from_arg(args: &'a Args, i: usize) -> Result<Self> {
        Ok(Self(args, i))
    }
}

impl<'a> Message<'a> {
    /// What is left of it; marks it as read.
    pub fn rest(&self) -> &'a [u8] {
        self.0.message(self.1)
    }
}
