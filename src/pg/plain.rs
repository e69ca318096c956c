//! Arguments that are a fixed number of float8.

use std::marker::PhantomData;

use asbuilt_core::Result;
use asbuilt_core::evidence::Mass;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::uncertain::{Stored, UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};
use asbuilt_core::verify::EvidenceModel;

use super::{Args, FromArg};

/// What is stored as `N` float8, and its SQL type. Implemented here alone: an argument's bytes are read on its word.
pub trait PlainType<const N: usize>: Sized {
    /// The type's name.
    const SQL_TYPE: &'static str;

    /// The value of the stored numbers.
    fn of(numbers: &[f64; N]) -> Self;
}

impl PlainType<6> for Aabb {
    const SQL_TYPE: &'static str = "ab_box";

    fn of(&[a, b, c, d, e, f]: &[f64; 6]) -> Self {
        Self { min: [a, b, c], max: [d, e, f] }
    }
}

impl PlainType<3> for Mass {
    const SQL_TYPE: &'static str = "ab_mass";

    fn of(&[occupied, empty, unknown]: &[f64; 3]) -> Self {
        Self { occupied, empty, unknown }
    }
}

macro_rules! plain {
    ($($type:ty, $count:literal;)*) => {$(
        impl FromArg<'_> for $type {
            const SQL_TYPE: &'static str = <Self as PlainType<$count>>::SQL_TYPE;

            fn from_arg(args: &Args, i: usize) -> Result<Self> {
                Ok(PlainType::of(&args.numbers::<$count>(i)))
            }
        }
    )*};
}

macro_rules! uncertain {
    ($($type:ty, $count:literal;)*) => {
        $(
            impl PlainType<$count> for $type {
                const SQL_TYPE: &'static str = Self::NAME;

                fn of(numbers: &[f64; $count]) -> Self {
                    Self::from_stored(numbers)
                }
            }
        )*
        plain! { $($type, $count;)* }
    };
}

plain! { Aabb, 6; Mass, 3; }
uncertain! { UncertainPoint, 9; UncertainLine, 27; UncertainPlane, 16; UncertainPose, 36; }

/// The numbers of a `T`, as they are stored.
#[derive(Debug)]
pub struct Numbers<T, const N: usize> {
    /// In order.
    pub numbers: [f64; N],
    of: PhantomData<T>,
}

impl<T: PlainType<N>, const N: usize> FromArg<'_> for Numbers<T, N> {
    const SQL_TYPE: &'static str = T::SQL_TYPE;

    fn from_arg(args: &Args, i: usize) -> Result<Self> {
        Ok(Self { numbers: args.numbers(i), of: PhantomData })
    }
}

/// The evidence model of 0.1.0, as it is stored.
#[derive(Debug)]
pub struct FixedModel(pub [u8; EvidenceModel::LEN]);

impl FromArg<'_> for FixedModel {
    const SQL_TYPE: &'static str = "ab_evidence_model_010";

    fn from_arg(args: &Args, i: usize) -> Result<Self> {
        Ok(Self(args.fixed(i)))
    }
}
