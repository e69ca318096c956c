//! On which threads many objects are worked on.

use rayon::prelude::*;

use crate::Result;

/// Where the work is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Threads {
    /// On the caller's thread.
    Own,
    /// On those of the rayon pool that the caller has installed.
    Pool,
}

impl Threads {
    /// Calls `work` for every item, in any order; the first error in the items' order is returned.
    pub fn for_each<T: Send>(self, items: &mut [T], work: impl Fn(&mut T) -> Result<()> + Sync) -> Result<()> {
        match self {
            Self::Own => items.iter_mut().try_for_each(work),
            Self::Pool => items.par_iter_mut().with_max_len(1).map(&work).collect::<Vec<_>>().into_iter().collect(),
        }
    }

    /// `work` of every item, in the items' order.
    pub fn map<T: Sync, U: Send>(self, items: &[T], work: impl Fn(&T) -> Result<U> + Sync) -> Result<Vec<U>> {
        match self {
            Self::Own => items.iter().map(work).collect(),
            Self::Pool => items.par_iter().with_max_len(1).map(&work).collect::<Vec<_>>().into_iter().collect(),
        }
    }
}
