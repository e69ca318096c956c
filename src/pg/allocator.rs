//! The allocator of everything that Rust code takes in a backend: it counts, and it survives a refusal.
//!
//! A Rust program that finds no memory aborts, and an aborted backend takes every session with it. An allocator may
//! neither unwind nor report (`GlobalAlloc`'s contract), so this one gives up a ballast instead, and the next poll (see
//! [`super::memory`]) raises PostgreSQL's own error 53200.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicIsize, AtomicPtr, AtomicUsize, Ordering::Relaxed};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

struct Counting;

/// Live bytes, except for what each thread has not added yet.
static LIVE: AtomicIsize = AtomicIsize::new(0);
static PEAK: AtomicIsize = AtomicIsize::new(0);
/// The most that lived since [`give_back`] last did.
static HIGH: AtomicIsize = AtomicIsize::new(0);

/// Bytes that the system refused when the ballast was given up; 0 if it refused none.
static REFUSED: AtomicUsize = AtomicUsize::new(0);

/// Given up when the system has nothing else: enough for what the work takes until it next polls.
static BALLAST: AtomicPtr<u8> = AtomicPtr::new(null_mut());
const BALLAST_LAYOUT: Layout = Layout::new::<[u8; 64 << 20]>();
/// The ballast is held from this many bytes on: a session that asks little of asbuilt carries none.
const BALLAST_FROM: isize = 4 << 20;

/// Smaller pieces are not counted: a mass or a point then costs nothing extra, and hardly anything large is made of
/// pieces this small.
const COUNTED: usize = 64;

/// A thread adds to [`LIVE`] once this much has accumulated.
const FLUSH: isize = 64 << 10;

thread_local! {
    /// What this thread took (or gave back) since it last added to [`LIVE`].
    static PENDING: Cell<isize> = const { Cell::new(0) };
}

/// Live bytes.
pub fn live() -> isize {
    flush();
    LIVE.load(Relaxed)
}

/// The most live bytes since [`forget_peak`].
pub fn peak() -> isize {
    PEAK.load(Relaxed).max(live())
}

/// Counts the peak from now on.
pub fn forget_peak() {
    PEAK.store(live(), Relaxed);
}

/// The bytes that the system refused since this was last asked; takes a new ballast then, where there is room again.
#[inline]
pub fn take_refusal() -> Option<usize> {
    let refused = refusal()?;
    renew();
    Some(refused)
}

#[cold]
fn renew() {
    REFUSED.store(0, Relaxed);
    hold_ballast();
}

/// What [`take_refusal`] will tell.
#[inline]
pub fn refusal() -> Option<usize> {
    Some(REFUSED.load(Relaxed)).filter(|&bytes| bytes > 0)
}

/// Whether the system can give this much at once.
pub fn has_room(bytes: usize) -> bool {
    let Ok(layout) = Layout::array::<u8>(bytes.max(1)) else { return false };
    let p = unsafe { System.alloc(layout) };
    if !p.is_null() {
        unsafe { System.dealloc(p, layout) };
    }
    !p.is_null()
}

/// How many bytes a piece of memory counts for.
fn weight(bytes: usize) -> isize {
    if bytes < COUNTED { 0 } else { bytes as isize }
}

#[inline]
fn count(bytes: isize) {
    if bytes == 0 {
        return;
    }
    // During a thread's last breath its cell is gone; then nobody counts.
    let due = PENDING.try_with(|pending| {
        pending.set(pending.get() + bytes);
        pending.get().abs() >= FLUSH
    });
    if due == Ok(true) {
        settle();
    }
}

#[cold]
fn settle() {
    flush();
    if LIVE.load(Relaxed) > BALLAST_FROM && BALLAST.load(Relaxed).is_null() && refusal().is_none() {
        hold_ballast();
    }
}

fn flush() {
    let pending = PENDING.try_with(Cell::take).unwrap_or(0);
    let live = LIVE.fetch_add(pending, Relaxed) + pending;
    PEAK.fetch_max(live, Relaxed);
    HIGH.fetch_max(live, Relaxed);
}

#[cfg(target_env = "gnu")]
unsafe extern "C" {
    fn malloc_trim(pad: usize) -> std::ffi::c_int;
}

/// Gives freed memory back to the system, where it is more than `worth` bytes: glibc keeps what lies below the last
/// block that lives, and whoever limits a backend's memory sees it as taken (43 of 215 MB, after four pieces of
/// evidence).
pub fn give_back(worth: usize) {
    let (live, high) = (live(), HIGH.load(Relaxed));
    // What comes and goes beside a state that stays is wanted again by the next call.
    if high - live > worth.min(isize::MAX as usize) as isize && live < high / 2 {
        HIGH.store(live, Relaxed);
        #[cfg(target_env = "gnu")]
        unsafe {
            malloc_trim(0)
        };
    }
}

#[cold]
fn hold_ballast() {
    if BALLAST.load(Relaxed).is_null() {
        let fresh = unsafe { System.alloc(BALLAST_LAYOUT) };
        if BALLAST.compare_exchange(null_mut(), fresh, Relaxed, Relaxed).is_err() && !fresh.is_null() {
            unsafe { System.dealloc(fresh, BALLAST_LAYOUT) };
        }
    }
}

/// Gives up the ballast and tries once more.
#[cold]
fn retried(bytes: usize, alloc: impl Fn() -> *mut u8) -> *mut u8 {
    REFUSED.store(bytes.max(1), Relaxed);
    let ballast = BALLAST.swap(null_mut(), Relaxed);
    if !ballast.is_null() {
        unsafe { System.dealloc(ballast, BALLAST_LAYOUT) };
    }
    alloc()
}

/// What `alloc` returns, at the second attempt if need be.
#[inline]
fn taken(bytes: usize, alloc: impl Fn() -> *mut u8) -> *mut u8 {
    let p = alloc();
    if p.is_null() { retried(bytes, alloc) } else { p }
}

/// The same, counted where it was given. To count may take a new ballast: before, that would use up the room which a
/// caller has just been told of.
#[inline]
fn counted(bytes: usize, alloc: impl Fn() -> *mut u8) -> *mut u8 {
    let p = taken(bytes, alloc);
    if !p.is_null() {
        count(weight(bytes));
    }
    p
}

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        counted(layout.size(), || unsafe { System.alloc(layout) })
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        counted(layout.size(), || unsafe { System.alloc_zeroed(layout) })
    }

    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        unsafe { System.dealloc(p, layout) };
        count(-weight(layout.size()));
    }

    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let fresh = taken(size, || unsafe { System.realloc(p, layout, size) });
        if !fresh.is_null() {
            count(weight(size) - weight(layout.size()));
        }
        fresh
    }
}
