//! Long sorts that can be interrupted.

use crate::{Grow, Interrupt, Result, poll, poll_now_and_then};

/// Items sorted in one go, a few milliseconds.
const RUN: usize = 1 << 16;

/// Sorts `items` in ascending order: runs of 65 536 by the standard library, merged pairwise. Asks `interrupt` in
/// between, which a single standard sort of millions could not do.
pub fn sort<T: Copy + Ord>(items: &mut Vec<T>, interrupt: Interrupt) -> Result<()> {
    for run in items.chunks_mut(RUN) {
        poll(interrupt)?;
        run.sort_unstable();
    }
    let mut width = RUN;
    let mut merged = Vec::new();
    merged.grow(if items.len() > RUN { items.len() } else { 0 }, interrupt)?;
    while width < items.len() {
        merged.clear();
        for pair in items.chunks(2 * width) {
            let (left, right) = pair.split_at(width.min(pair.len()));
            merge(left, right, &mut merged, interrupt)?;
        }
        std::mem::swap(items, &mut merged);
        width *= 2;
    }
    Ok(())
}

fn merge<T: Copy + Ord>(mut left: &[T], mut right: &[T], out: &mut Vec<T>, interrupt: Interrupt) -> Result<()> {
    let mut round = 0;
    while let (Some(&l), Some(&r)) = (left.first(), right.first()) {
        poll_now_and_then(round, interrupt)?;
        round += 1;
        if l <= r {
            out.push(l);
            left = &left[1..];
        } else {
            out.push(r);
            right = &right[1..];
        }
    }
    out.extend_from_slice(left);
    out.extend_from_slice(right);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Error, NEVER};
    use rand::{Rng, SeedableRng};

    #[test]
    fn equals_the_standard_sort() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        for n in [0, 1, 2, RUN - 1, RUN, RUN + 1, 3 * RUN + 17, 5 * RUN] {
            let mut items: Vec<(u32, usize)> = (0..n).map(|i| (rng.random_range(0..1000), i)).collect();
            let mut want = items.clone();
            want.sort_unstable();
            sort(&mut items, NEVER).unwrap();
            assert!(items == want, "{n}");
        }
    }

    #[test]
    fn stops_when_told() {
        assert_eq!(sort(&mut vec![2, 1], &|| true), Err(Error::Interrupted));
    }
}
