//! Internal aggregate states.

use asbuilt_core::{Error, Result};
use pgrx::{PgMemoryContexts, pg_sys};

use super::memory::Account;
use super::{Args, FromArg, SqlValue};

/// A state that lives in the aggregate's memory context and is dropped with it.
#[derive(Debug)]
pub struct AggState<T> {
    pointer: *mut Kept<T>,
}

/// PostgreSQL drops a state when it chooses; what that frees is credited to its account.
#[derive(Debug)]
struct Kept<T> {
    account: Account,
    /// `None` once dropped. In a box of its own, so that freeing it is credited to the account, too.
    state: Option<Box<T>>,
}

impl<T> Kept<T> {
    /// A new state, on the open account.
    fn new(state: T) -> Self {
        Self { account: Account::current(), state: Some(Box::new(state)) }
    }
}

impl<T> Drop for Kept<T> {
    fn drop(&mut self) {
        let _opened = self.account.open();
        self.state = None;
    }
}

impl<T> AggState<T> {
    /// The state.
    pub fn get(&mut self) -> &mut T {
        let kept = unsafe { &mut *self.pointer };
        kept.state.as_deref_mut().expect("a state that PostgreSQL has dropped is not asked for")
    }

    /// Hands the state back to the executor.
    pub fn ret(&self) -> SqlValue {
        SqlValue::Raw(self.pointer.into())
    }
}

/// The memory context of the aggregate that calls.
fn context(args: &Args) -> Result<pg_sys::MemoryContext> {
    let mut context: pg_sys::MemoryContext = std::ptr::null_mut();
    if unsafe { pg_sys::AggCheckCallContext(args.fcinfo(), &mut context) } == 0 {
        return Err(Error::argument("an aggregate's support function", "called by its aggregate", "a plain call"));
    }
    Ok(context)
}

impl<T> FromArg<'_> for AggState<T> {
    const SQL_TYPE: &'static str = "internal";

    fn from_arg(args: &Args, i: usize) -> Result<Self> {
        context(args)?;
        Ok(Self { pointer: args.datum(i).cast_mut_ptr() })
    }
}

/// The state of a transition function: a new one at the first row.
#[derive(Debug)]
pub struct StateOrNew<T>(pub AggState<T>);

impl<T: Default> FromArg<'_> for StateOrNew<T> {
    const SQL_TYPE: &'static str = "internal";
    const NULLABLE: bool = true;

    fn from_arg(args: &Args, i: usize) -> Result<Self> {
        state_or_new(args, Option::from_arg(args, i)?, || Ok(T::default())).map(Self)
    }
}

/// The state, or a new one from `fresh`.
pub fn state_or_new<T>(
    args: &Args,
    state: Option<AggState<T>>,
    fresh: impl FnOnce() -> Result<T>,
) -> Result<AggState<T>> {
    if let Some(state) = state {
        return Ok(state);
    }
    let context = PgMemoryContexts::For(context(args)?);
    Ok(AggState { pointer: { context }.leak_and_drop_on_delete(Kept::new(fresh()?)) })
}

/// A state read back from its serialised form, in the current memory context.
pub fn deserialised_state<T>(state: T) -> AggState<T> {
    AggState { pointer: PgMemoryContexts::CurrentMemoryContext.leak_and_drop_on_delete(Kept::new(state)) }
}
