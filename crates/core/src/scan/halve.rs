//! Lists halved until their parts are patches.

use super::beam::MAX_BEAMS;
use crate::{Interrupt, Result, poll};

/// Halves things into equal counts across the axis that `wide` names until it names none; appends the numbers of every
/// part, sorted. `at` is a thing's coordinate on an axis.
pub fn halve<T>(
    things: &mut [T],
    number: &impl Fn(&T) -> u32,
    at: &impl Fn(&T, usize) -> f64,
    wide: &impl Fn(&[T]) -> Option<usize>,
    out: &mut Vec<Vec<u32>>,
    interrupt: Interrupt,
) -> Result<()> {
    poll(interrupt)?;
    if things.is_empty() {
        return Ok(());
    }
    let Some(axis) = wide(things) else {
        let mut part: Vec<u32> = things.iter().map(number).collect();
        part.sort_unstable();
        out.push(part);
        return Ok(());
    };
    // Share out whole patches, so that the last ones are not half empty.
    let patches = things.len().div_ceil(MAX_BEAMS).max(2);
    let middle = (things.len() * (patches / 2) / patches).clamp(1, things.len() - 1);
    things.select_nth_unstable_by(middle, |a, b| at(a, axis).total_cmp(&at(b, axis)).then(number(a).cmp(&number(b))));
    let (low, high) = things.split_at_mut(middle);
    halve(low, number, at, wide, out, interrupt)?;
    halve(high, number, at, wide, out, interrupt)
}
