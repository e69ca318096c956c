//! Time and memory that long work may take; may be asked on any of its threads.

use std::collections::{HashMap, TryReserveError};
use std::hash::{BuildHasher, Hash};

use crate::error::{Error, Result};

/// Whom long work asks whether it may go on.
///
/// A closure of `bool` is a budget without a limit of memory; `true` means: stop with [`Error::Interrupted`].
pub trait Budget: Sync {
    /// Asked at intervals; an error unwinds the work.
    fn poll(&self) -> Result<()>;

    /// Asked before this many bytes are taken at once; an error where there is no room for them.
    fn room(&self, bytes: usize) -> Result<()>;

    /// Until told otherwise, a refusal of the system is handled where it is met.
    fn refusals_are_handled(&self, _are: bool) {}
}

impl<F: Fn() -> bool + Sync> Budget for F {
    fn poll(&self) -> Result<()> {
        if self() { Err(Error::Interrupted) } else { Ok(()) }
    }

    fn room(&self, _bytes: usize) -> Result<()> {
        Ok(())
    }
}

/// The [`Budget`] of the work at hand.
pub type Interrupt<'a> = &'a dyn Budget;

/// An [`Interrupt`] that never says stop.
pub const NEVER: Interrupt = &|| false;

/// Turns a budget that says stop into the error that unwinds the work.
pub(crate) fn poll(interrupt: Interrupt) -> Result<()> {
    interrupt.poll()
}

/// [`poll`] in every `1024`th round of a loop.
pub(crate) fn poll_now_and_then(round: usize, interrupt: Interrupt) -> Result<()> {
    if round.is_multiple_of(1024) { poll(interrupt) } else { Ok(()) }
}

/// Smaller pieces are taken without asking for room: what they add up to is noticed by [`Budget::poll`].
const SMALL: usize = 1 << 16;

/// An error where there is no room for `count` elements of `T` that are about to be taken.
pub(crate) fn room<T>(count: usize, interrupt: Interrupt) -> Result<()> {
    let bytes = count.saturating_mul(size_of::<T>());
    if bytes < SMALL { Ok(()) } else { interrupt.room(bytes) }
}

/// Collections that ask for room before they grow: growing doubles them, which could exceed a limit by as much.
pub trait Grow {
    /// Makes room for `additional` elements, as much as [`Vec::reserve`] would.
    fn grow(&mut self, additional: usize, interrupt: Interrupt) -> Result<()>;
}

fn refused(bytes: usize) -> Error {
    Error::OutOfMemory { bytes }
}

/// Reserves so many bytes; where the system refuses them, that is an error.
fn reserved(
    interrupt: Interrupt,
    bytes: usize,
    reserve: impl FnOnce() -> std::result::Result<(), TryReserveError>,
) -> Result<()> {
    interrupt.refusals_are_handled(true);
    let outcome = reserve();
    interrupt.refusals_are_handled(false);
    outcome.map_err(|_| refused(bytes))
}

impl<T> Grow for Vec<T> {
    fn grow(&mut self, additional: usize, interrupt: Interrupt) -> Result<()> {
        let (len, capacity) = (self.len(), self.capacity());
        if additional <= capacity - len {
            return Ok(());
        }
        let wanted = len.saturating_add(additional);
        // Doubled where there is room for it, else by an eighth: a limit is to be reached, not halved.
        let mut target = capacity.saturating_mul(2).max(wanted);
        if room::<T>(target - capacity, interrupt).is_err() {
            target = (capacity + capacity / 8).max(wanted);
            room::<T>(target - capacity, interrupt)?;
        }
        reserved(interrupt, target.saturating_mul(size_of::<T>()), || self.try_reserve_exact(target - len))
    }
}

impl<K: Eq + Hash, V, S: BuildHasher> Grow for HashMap<K, V, S> {
    fn grow(&mut self, additional: usize, interrupt: Interrupt) -> Result<()> {
        let capacity = self.capacity();
        if additional <= capacity - self.len() {
            return Ok(());
        }
        // hashbrown doubles at 7/8, keeps a byte a place, and holds old and new together while it moves.
        let places = (self.len() + additional).max(2 * capacity).saturating_mul(8) / 7;
        let bytes = places.next_power_of_two().saturating_mul(size_of::<(K, V)>() + 1);
        if bytes >= SMALL {
            interrupt.room(bytes)?;
        }
        reserved(interrupt, bytes, || self.try_reserve(additional))
    }
}

/// A budget of work that may take no more than this many bytes at once, and any amount of time.
#[derive(Debug, Clone, Copy)]
pub struct AtOnce(pub usize);

impl Budget for AtOnce {
    fn poll(&self) -> Result<()> {
        Ok(())
    }

    fn room(&self, bytes: usize) -> Result<()> {
        if bytes > self.0 { Err(refused(bytes)) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_reaches_its_limit_and_no_further() {
        let most = AtOnce(1 << 20);
        let mut list = Vec::new();
        let refused = (0u64..).find(|&i| list.grow(1, &most).map(|()| list.push(i)).is_err()).unwrap();
        // The last step that it may take is one of 1 MiB: it holds more than that, and not much.
        assert!(refused >= 1 << 17 && list.capacity() <= 9 << 17, "{refused}, {}", list.capacity());
        assert_eq!(list.len() as u64, refused);
    }

    #[test]
    fn a_map_asks_before_it_doubles() {
        let most = AtOnce(1 << 20);
        let mut map: HashMap<u64, u64> = HashMap::new();
        let refused = (0u64..).find(|&i| map.grow(1, &most).map(|()| map.insert(i, i)).is_err()).unwrap();
        assert!((10_000..100_000).contains(&refused) && map.len() as u64 == refused);
    }
}
