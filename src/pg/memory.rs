//! What a call may take: its account, the account's limit, and the error beyond it.
//!
//! All live memory of a backend is counted ([`super::allocator`]). A call whose memory a setting limits opens that
//! setting's account; what is taken until it closes, and what its aggregate states free later, is booked on it.

use std::sync::atomic::{AtomicBool, AtomicI64, AtomicIsize, AtomicUsize, Ordering::Relaxed};

use asbuilt_core::error::MemoryOf;
use asbuilt_core::{Budget, Error, Result};
use pgrx::PgLogLevel;

use super::allocator;
use crate::{error, settings};

/// Whose memory it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Account {
    /// Limited by `asbuilt.memory_ceiling` alone.
    Other,
    /// Voxels: `asbuilt.max_grid_memory`.
    Grid,
    /// Evidence: `asbuilt.max_evidence_memory`.
    Evidence,
}

const ACCOUNTS: [Account; 3] = [Account::Other, Account::Grid, Account::Evidence];

/// What each account held when it was last closed.
static HELD: [AtomicIsize; 3] = [const { AtomicIsize::new(0) }; 3];
/// Twice the bytes of the value that each account's calls last handed to PostgreSQL: while the next one is made,
/// whoever asked for that value holds it, and a node that keeps rows (Materialize, Sort) holds a copy of it on its way
/// to disk.
static HANDED: [AtomicUsize; 3] = [const { AtomicUsize::new(0) }; 3];
/// When the statement began in which that happened.
static STATEMENT: AtomicI64 = AtomicI64::new(0);
/// The open account, by its place in [`ACCOUNTS`].
static OPEN: AtomicUsize = AtomicUsize::new(0);
/// Live bytes when it was opened.
static BEFORE: AtomicIsize = AtomicIsize::new(0);
/// The open account's limit and that of all together: settings are read on the main thread only.
static LIMIT: AtomicUsize = AtomicUsize::new(usize::MAX);
static CEILING: AtomicUsize = AtomicUsize::new(usize::MAX);

/// What was freed goes back to the system from this part of a limit on: below it, pages that the next group of an
/// aggregate takes anew would cost more than they tell of the limit (4 % of a verification, were it 16 MB).
const WORTH_GIVING_BACK: usize = 8;

/// An account that is open until this is dropped.
#[derive(Debug)]
pub struct Opened {
    before: usize,
}

impl Account {
    /// Opens this account.
    pub fn open(self) -> Opened {
        Opened { before: switch(self as usize) }
    }

    /// The account that is open.
    pub fn current() -> Self {
        ACCOUNTS[OPEN.load(Relaxed)]
    }

    /// Notes that a value of this many bytes was handed to PostgreSQL.
    pub fn hand_over(self, bytes: usize) {
        HANDED[self as usize].store(2 * bytes, Relaxed);
    }

    fn limit(self) -> usize {
        match self {
            Self::Other => usize::MAX,
            Self::Grid => settings::max_grid_memory(),
            Self::Evidence => settings::max_evidence_memory(),
        }
    }
}

impl Drop for Opened {
    fn drop(&mut self) {
        switch(self.before);
    }
}

/// Settles what was taken on the open account, opens another, and returns which was open.
fn switch(to: usize) -> usize {
    let (live, open) = (allocator::live(), OPEN.load(Relaxed));
    HELD[open].fetch_add(live - BEFORE.swap(live, Relaxed), Relaxed);
    allocator::give_back(LIMIT.load(Relaxed) / WORTH_GIVING_BACK);
    OPEN.store(to, Relaxed);
    let statement = unsafe { pgrx::pg_sys::GetCurrentStatementStartTimestamp() };
    if STATEMENT.swap(statement, Relaxed) != statement {
        HANDED.iter().for_each(|bytes| bytes.store(0, Relaxed));
    }
    read_limits();
    open
}

/// On the main thread: reads the limits as they are currently set.
fn read_limits() {
    CEILING.store(settings::memory_ceiling(), Relaxed);
    LIMIT.store(Account::current().limit(), Relaxed);
}

/// Bytes on the open account, and in total, including what was handed over last.
fn taken() -> [usize; 2] {
    let (live, open) = (allocator::live(), OPEN.load(Relaxed));
    let own = HELD[open].load(Relaxed) + live - BEFORE.load(Relaxed);
    let handed = HANDED[open].load(Relaxed);
    [own, live].map(|bytes| (bytes.max(0) as usize).saturating_add(handed))
}

/// An error where `more` bytes would be too many, for the open account or for all together.
fn check(more: usize) -> Result<()> {
    let (account, ceiling) = (Account::current(), CEILING.load(Relaxed));
    let [own, all] = taken().map(|bytes| bytes.saturating_add(more));
    let limit = LIMIT.load(Relaxed).min(ceiling);
    if own > limit {
        return Err(beyond(account, own, limit, limit == ceiling));
    }
    if all > ceiling { Err(beyond(Account::Other, all, ceiling, true)) } else { Ok(()) }
}

fn beyond(account: Account, needed: usize, limit: usize, at_ceiling: bool) -> Error {
    let what = match account {
        Account::Grid => MemoryOf::Grids,
        Account::Evidence => MemoryOf::Evidence,
        Account::Other => MemoryOf::Session,
    };
    Error::Memory { what, needed, limit, at_ceiling }
}

/// The budget of a backend's calls; on threads other than its main one, interrupts are not served but obeyed.
#[derive(Debug, Clone, Copy)]
pub struct Backend;

/// The same on the threads of [`super::WorkerPool`].
#[derive(Debug, Clone, Copy)]
pub struct Helper;

/// An error where too much was taken, or the system has refused memory.
fn poll_memory() -> Result<()> {
    allocator::refusal().map_or_else(|| check(0), |bytes| Err(Error::OutOfMemory { bytes }))
}

/// The system is asked too, so that memory is not refused later to code that cannot handle a refusal.
fn room(bytes: usize) -> Result<()> {
    check(bytes)?;
    if allocator::refusal().is_none() && allocator::has_room(bytes) {
        Ok(())
    } else {
        Err(Error::OutOfMemory { bytes })
    }
}

/// The last resort, on the main thread: this session ends with 53200, and the others live. Returns only where it is
/// already ending.
pub fn end_session(bytes: usize) {
    static ENDING: AtomicBool = AtomicBool::new(false);
    if !ENDING.swap(true, Relaxed) {
        error::report(&Error::OutOfMemory { bytes }, "asbuilt").report(PgLogLevel::FATAL);
    }
}

/// While other threads work: ends the session where one of them waits for memory that nobody frees.
pub fn end_if_stuck() {
    if let Some(bytes) = allocator::refusal().filter(|_| allocator::is_stuck()) {
        end_session(bytes);
    }
}

impl Budget for Backend {
    fn poll(&self) -> Result<()> {
        super::interrupt::serve();
        read_limits();
        poll_memory()
    }

    fn room(&self, bytes: usize) -> Result<()> {
        read_limits();
        room(bytes)
    }

    fn refusals_are_handled(&self, are: bool) {
        allocator::refusals_are_handled(are);
    }
}

impl Budget for Helper {
    fn poll(&self) -> Result<()> {
        if super::interrupt::is_due() { Err(Error::Interrupted) } else { poll_memory() }
    }

    fn room(&self, bytes: usize) -> Result<()> {
        room(bytes)
    }

    fn refusals_are_handled(&self, are: bool) {
        allocator::refusals_are_handled(are);
    }
}

/// Live bytes in this backend and the most there ever were; `from_now` restarts the peak after it is returned.
pub fn memory_in_use(from_now: bool) -> [i64; 2] {
    let told = [allocator::live(), allocator::peak()].map(|bytes| bytes as i64);
    if from_now {
        allocator::forget_peak();
    }
    told
}
