//! Threads beside PostgreSQL's own.
//!
//! A backend is a process of one thread. Other threads may compute in it as long as they call no PostgreSQL function
//! and no signal is delivered to them: its handlers belong on the main thread.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use asbuilt_core::verify::Threads;
use asbuilt_core::{Error, Result};
use pgrx::pg_sys;

use super::interrupt::{client_is_here, look_for_client, serve};
use super::memory::{Backend, Helper, end_if_stuck};

thread_local! {
    /// The backend's pool, asleep between calls: pools made for every call would leave memory behind.
    static POOL: RefCell<Option<Arc<rayon::ThreadPool>>> = const { RefCell::new(None) };
}

/// The threads that a call may use: as many as a parallel plan would have processes.
#[derive(Debug)]
pub struct WorkerPool {
    /// `None`: the main thread alone.
    pool: Option<Arc<rayon::ThreadPool>>,
}

impl WorkerPool {
    /// One thread more than `max_parallel_workers_per_gather`, but no more than there are cores.
    pub fn gather() -> Self {
        let workers = unsafe { pg_sys::max_parallel_workers_per_gather }.max(0) as usize;
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let count = (workers + 1).min(cores.max(2));
        Self { pool: (count > 1).then(|| pool_of(count)).flatten() }
    }

    /// What to tell [`asbuilt_core::verify::Verifier`].
    pub fn threads(&self) -> Threads {
        if self.pool.is_some() { Threads::Pool } else { Threads::Own }
    }

    /// Runs `work` on the crew, with an interrupt to ask whether to stop; a cancel then raises its error from here.
    pub fn run<T: Send>(&self, work: impl FnOnce(asbuilt_core::Interrupt) -> Result<T> + Send) -> Result<T> {
        let Some(pool) = &self.pool else { return work(&Backend) };
        client_is_here();
        let (tell, told) = std::sync::mpsc::channel();
        let outcome = pool.in_place_scope(|scope| {
            scope.spawn(move |_| tell.send(work(&Helper)).unwrap_or_default());
            loop {
                match told.recv_timeout(LOOK) {
                    Ok(outcome) => break Some(outcome),
                    Err(RecvTimeoutError::Timeout) => {
                        look_for_client();
                        end_if_stuck();
                    }
                    // The work panicked, and the scope will go on with that.
                    Err(RecvTimeoutError::Disconnected) => break None,
                }
            }
        });
        let outcome = outcome.unwrap_or(Err(Error::Interrupted));
        if matches!(outcome, Err(Error::Interrupted)) {
            serve();
        }
        outcome
    }
}

/// While others work, the main thread checks this often whether the client is still there, if PostgreSQL is set to
/// check.
const LOOK: Duration = Duration::from_millis(100);

/// The backend's pool with this many threads; `None` where the system has none to give: the work is then done without.
fn pool_of(count: usize) -> Option<Arc<rayon::ThreadPool>> {
    POOL.with_borrow_mut(|pool| {
        if pool.as_ref().is_none_or(|p| p.current_num_threads() != count) {
            let build = || rayon::ThreadPoolBuilder::new().num_threads(count).build();
            *pool = with_signals_blocked(build).ok().map(Arc::new);
        }
        pool.clone()
    })
}

/// Threads that start in the meantime inherit the mask: no signal is ever delivered to them.
fn with_signals_blocked<T>(start: impl FnOnce() -> T) -> T {
    unsafe {
        let mut all = std::mem::zeroed();
        let mut before = std::mem::zeroed();
        libc::sigfillset(&mut all);
        libc::pthread_sigmask(libc::SIG_SETMASK, &all, &mut before);
        let out = start();
        libc::pthread_sigmask(libc::SIG_SETMASK, &before, std::ptr::null_mut());
        out
    }
}
