//! The allocator of everything that Rust code takes in a backend: it counts, and it survives a refusal.
//!
//! A Rust program that finds no memory aborts, and an aborted backend takes every session with it. An allocator may
//! neither unwind nor report (`GlobalAlloc`'s contract), so this one gives up a ballast instead, and the next poll (see
//! [`super::memory`]) raises PostgreSQL's own error 53200. Where the ballast is not enough, this session alone ends.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicBool, AtomicIsize, AtomicPtr, AtomicUsize, Ordering::Relaxed};
use std::time::Duration;

use super::memory::end_session;

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
/// Given up when the session ends for want of memory: enough for its last message.
static LAST_WORDS: AtomicPtr<u8> = AtomicPtr::new(null_mut());
const LAST_WORDS_LAYOUT: Layout = Layout::new::<[u8; 256 << 10]>();
/// A thread beside the main one waits for memory that nobody gives back.
static STUCK: AtomicBool = AtomicBool::new(false);
/// How long it waits for what the other threads free on their way out.
const PATIENCE: Duration = Duration::from_secs(2);
/// The ballast is held from this many bytes on: a session that asks little of asbuilt carries none.
const BALLAST_FROM: isize = 1 << 20;

/// Smaller pieces are not counted: a mass or a point then costs nothing extra, and hardly anything large is made of
/// pieces this small.
const COUNTED: usize = 64;

/// A thread adds to [`LIVE`] once this much has accumulated.
const FLUSH: isize = 64 << 10;

thread_local! {
    /// What this thread took (or gave back) since it last added to [`LIVE`].
    static PENDING: Cell<isize> = const { Cell::new(0) };
    /// Whether this thread's caller handles a null.
    static HANDLED: Cell<bool> = const { Cell::new(false) };
}

/// Until told otherwise, this thread's refusals are handled by who asks: null is no abort then.
pub fn refusals_are_handled(are: bool) {
    let _ = HANDLED.try_with(|handled| handled.set(are));
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

/// Whether the system can give this much at once, and the ballast beside it.
pub fn has_room(bytes: usize) -> bool {
    if live().saturating_add_unsigned(bytes) > BALLAST_FROM && !hold_ballast() {
        return false;
    }
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
    if LIVE.load(Relaxed) > BALLAST_FROM && BALLAST.load(Relaxed).is_null() && refusal().is_none() && !hold_ballast() {
        // Without one, the next allocation might be the last.
        REFUSED.store(BALLAST_LAYOUT.size(), Relaxed);
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

/// Whether there is a ballast now.
#[cold]
fn hold_ballast() -> bool {
    hold(&LAST_WORDS, LAST_WORDS_LAYOUT) && hold(&BALLAST, BALLAST_LAYOUT)
}

fn hold(place: &AtomicPtr<u8>, layout: Layout) -> bool {
    if place.load(Relaxed).is_null() {
        let fresh = unsafe { System.alloc(layout) };
        if place.compare_exchange(null_mut(), fresh, Relaxed, Relaxed).is_err() && !fresh.is_null() {
            unsafe { System.dealloc(fresh, layout) };
        }
    }
    !place.load(Relaxed).is_null()
}

fn give_up(place: &AtomicPtr<u8>, layout: Layout) {
    let held = place.swap(null_mut(), Relaxed);
    if !held.is_null() {
        unsafe { System.dealloc(held, layout) };
    }
}

/// Gives up the ballast and tries once more. Null is what Rust aborts at, and an abort would take every session along:
/// the main thread then ends its own; another waits for what the rest frees, as all stop at their next poll.
#[cold]
fn retried(bytes: usize, alloc: impl Fn() -> *mut u8) -> *mut u8 {
    REFUSED.store(bytes.max(1), Relaxed);
    give_up(&BALLAST, BALLAST_LAYOUT);
    let p = alloc();
    if !p.is_null() || HANDLED.try_with(Cell::get) == Ok(true) {
        return p;
    }
    if is_main_thread() {
        give_up(&LAST_WORDS, LAST_WORDS_LAYOUT);
        end_session(bytes);
        return null_mut();
    }
    let since = std::time::Instant::now();
    loop {
        std::thread::sleep(Duration::from_millis(10));
        let p = alloc();
        if !p.is_null() {
            STUCK.store(false, Relaxed);
            return p;
        }
        STUCK.store(since.elapsed() > PATIENCE, Relaxed);
    }
}

/// Whether a thread waits for memory in vain.
pub fn is_stuck() -> bool {
    STUCK.load(Relaxed)
}

fn is_main_thread() -> bool {
    unsafe { libc::gettid() == libc::getpid() }
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
