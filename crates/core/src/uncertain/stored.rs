//! Fixed-size values as plain numbers: coordinates first, then the covariance's upper triangle row by row.

use nalgebra::SMatrix;

use crate::error::{Error, Result};
use crate::geometry::check_coordinates;
use crate::num::text::number;

/// A value of `N` numbers.
pub trait Stored<const N: usize>: Sized {
    /// SQL name of the type.
    const NAME: &'static str;
    /// How many of the numbers precede the covariance; a `;` separates the two in text.
    const COORDINATES: usize;

    /// The numbers.
    fn to_numbers(&self) -> [f64; N];

    /// The value of numbers that were checked when they were stored.
    fn from_stored(numbers: &[f64; N]) -> Self;

    /// The same value if it obeys every rule of its type, otherwise the rule that it breaks. Changes no bit of a valid
    /// one.
    fn checked(self) -> Result<Self>;

    /// The same value with its covariance [`super::covariance::settled`].
    fn settled(self) -> Self;

    /// A value as a construction leaves it.
    fn built(self) -> Result<Self> {
        self.settled().in_range()
    }

    /// The same value if its numbers are finite and its coordinates within 1e9 m, which a construction may violate.
    fn in_range(self) -> Result<Self> {
        let numbers = self.to_numbers();
        check_coordinates("a coordinate", &numbers[..Self::COORDINATES])?;
        match numbers.iter().find(|x| !x.is_finite()) {
            Some(x) => Err(Error::argument("a covariance", "finite", x)),
            None => Ok(self),
        }
    }

    /// Text form `(coordinates;covariance)`, shortest decimals that read back the same; an exact value leaves out
    /// its covariance.
    fn to_text(&self) -> String {
        let numbers = self.to_numbers();
        let list = |part: &[f64]| part.iter().map(|&x| number(x)).collect::<Vec<_>>().join(",");
        let (coordinates, covariance) = numbers.split_at(Self::COORDINATES);
        if covariance.iter().all(|x| x.to_bits() == 0) {
            format!("({})", list(coordinates))
        } else {
            format!("({};{})", list(coordinates), list(covariance))
        }
    }

    /// Reads [`Stored::to_text`]'s form.
    fn from_text(text: &str) -> Result<Self> {
        let bad = || Error::syntax(Self::NAME, text);
        let body = text.trim().strip_prefix('(').and_then(|t| t.strip_suffix(')')).ok_or_else(bad)?;
        let (coordinates, covariance) = body.split_once(';').map_or((body, None), |(a, b)| (a, Some(b)));
        let mut numbers = [0.0; N];
        let (head, tail) = numbers.split_at_mut(Self::COORDINATES);
        read_list(coordinates, head).ok_or_else(bad)?;
        if let Some(covariance) = covariance {
            read_list(covariance, tail).ok_or_else(bad)?;
        }
        Self::from_numbers(&numbers)
    }

    /// The value of numbers from outside, checked.
    fn from_numbers(numbers: &[f64; N]) -> Result<Self> {
        if let Some(x) = numbers.iter().find(|x| !x.is_finite()) {
            return Err(Error::argument("a number of the value", "finite", x));
        }
        Self::from_stored(numbers).checked()
    }
}

fn read_list(text: &str, out: &mut [f64]) -> Option<()> {
    let mut words = text.split(',');
    for slot in out {
        *slot = words.next()?.trim().parse().ok()?;
    }
    words.next().is_none().then_some(())
}

/// Writes the upper triangle of `m` row by row behind the first `at` numbers.
pub(super) fn put_triangle<const N: usize, const M: usize>(numbers: &mut [f64; N], at: usize, m: &SMatrix<f64, M, M>) {
    let places = (0..M).flat_map(|i| (i..M).map(move |j| (i, j)));
    numbers[at..].iter_mut().zip(places).for_each(|(slot, place)| *slot = m[place]);
}

/// The symmetric matrix whose upper triangle stands behind the first `at` numbers.
pub(super) fn get_triangle<const N: usize, const M: usize>(numbers: &[f64; N], at: usize) -> SMatrix<f64, M, M> {
    let mut m = SMatrix::zeros();
    let places = (0..M).flat_map(|i| (i..M).map(move |j| (i, j)));
    for (&x, (i, j)) in numbers[at..].iter().zip(places) {
        m[(i, j)] = x;
        m[(j, i)] = x;
    }
    m
}
