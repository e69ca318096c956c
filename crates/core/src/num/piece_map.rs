//! A map that may become large, in pieces that grow one after the other.

use std::collections::HashMap;
use std::fmt;
use std::hash::{BuildHasher, Hash, RandomState};

use super::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// One table of two million entries of 76 bytes is moved in 0.2 s when it grows, one of four million in 1.5 s, and a
/// cancelled query waits for that.
const PIECES: usize = 64;

/// What a [`HashMap`] is, no step of it long.
#[derive(Clone)]
pub struct PieceMap<K, V, S = RandomState> {
    hasher: S,
    /// By the key's hash; none before the first entry.
    pieces: Vec<HashMap<K, V, S>>,
}

impl<K, V, S: Default> Default for PieceMap<K, V, S> {
    fn default() -> Self {
        Self { hasher: S::default(), pieces: Vec::new() }
    }
}

impl<K: fmt::Debug, V: fmt::Debug, S> fmt::Debug for PieceMap<K, V, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.pieces.iter().flatten()).finish()
    }
}

impl<K: Eq + Hash, V: PartialEq, S: BuildHasher> PartialEq for PieceMap<K, V, S> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().all(|(key, value)| other.get(key) == Some(value))
    }
}

impl<K: Eq + Hash, V, S: BuildHasher> PieceMap<K, V, S> {
    /// By bits of the hash that tables use neither for places (the lowest) nor for tags (the highest seven).
    fn piece_of(&self, key: &K) -> usize {
        (self.hasher.hash_one(key) >> 40) as usize % PIECES
    }

    /// What is kept under a key.
    pub fn get(&self, key: &K) -> Option<&V> {
        self.pieces.get(self.piece_of(key))?.get(key)
    }

    /// The same, to be changed.
    pub fn get_mut(&mut self, key: &K) -> Option<&mut V> {
        let piece = self.piece_of(key);
        self.pieces.get_mut(piece)?.get_mut(key)
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.pieces.iter().map(HashMap::len).sum()
    }

    /// All entries, in no order.
    pub fn iter(&self) -> impl Iterator<Item = (&K, &V)> {
        self.pieces.iter().flatten()
    }

    /// Their keys, in no order.
    pub fn keys(&self) -> impl Iterator<Item = &K> {
        self.iter().map(|(key, _)| key)
    }

    /// Their values, in no order.
    pub fn values(&self) -> impl Iterator<Item = &V> {
        self.iter().map(|(_, value)| value)
    }

    /// The entries in the order of their keys, values as `view` shows them.
    pub fn in_order<'a, W>(&'a self, interrupt: Interrupt, view: impl Fn(&'a V) -> W) -> Result<Vec<(K, W)>>
    where
        K: Copy + Ord,
    {
        let (mut keys, mut all) = (Vec::<K>::new(), Vec::new());
        keys.grow(self.len(), interrupt)?;
        keys.extend(self.keys());
        sort(&mut keys, interrupt)?;
        all.grow(keys.len(), interrupt)?;
        for (round, key) in keys.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            all.extend(self.get(&key).map(|value| (key, view(value))));
        }
        Ok(all)
    }
}

impl<K: Eq + Hash, V, S: BuildHasher + Clone> PieceMap<K, V, S> {
    /// Keeps a value; what was under its key is gone.
    pub fn insert(&mut self, key: K, value: V, interrupt: Interrupt) -> Result<()> {
        self.roomy_piece(&key, interrupt)?.insert(key, value);
        Ok(())
    }

    /// What is kept under a key, made where it is missing.
    pub fn made(&mut self, key: K, interrupt: Interrupt) -> Result<&mut V>
    where
        V: Default,
    {
        self.made_by(key, V::default, interrupt)
    }

    /// The same by a function.
    pub fn made_by(&mut self, key: K, make: impl FnOnce() -> V, interrupt: Interrupt) -> Result<&mut V> {
        Ok(self.roomy_piece(&key, interrupt)?.entry(key).or_insert_with(make))
    }

    /// The piece for a key, with room for one more.
    fn roomy_piece(&mut self, key: &K, interrupt: Interrupt) -> Result<&mut HashMap<K, V, S>> {
        let hasher = &self.hasher;
        if self.pieces.is_empty() {
            self.pieces.resize_with(PIECES, || HashMap::with_hasher(hasher.clone()));
        }
        let piece = self.piece_of(key);
        let piece = &mut self.pieces[piece];
        piece.grow(1, interrupt)?;
        Ok(piece)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AtOnce, NEVER};
    use proptest::prelude::*;

    proptest! {
        /// Against a map of the standard library.
        #[test]
        fn is_a_map(all in prop::collection::vec((prop::array::uniform3(-4i32..4), 0u8..9), 0..200)) {
            let (mut own, mut other) = (PieceMap::<_, _>::default(), HashMap::new());
            for (key, value) in all {
                *own.made(key, NEVER).unwrap() += value;
                *other.entry(key).or_insert(0) += value;
            }
            prop_assert_eq!(own.len(), other.len());
            let mut in_order: Vec<_> = other.iter().map(|(key, value)| (*key, *value)).collect();
            in_order.sort_unstable();
            prop_assert_eq!(own.in_order(NEVER, |value| *value).unwrap(), in_order);
            prop_assert_eq!(own.get(&[4, 0, 0]), None);
        }
    }

    /// No growing moves more than a few hundredths of a large map, and its pieces are of one size.
    #[test]
    fn grows_in_pieces() {
        let mut map = PieceMap::<_, _>::default();
        let most = AtOnce(1 << 20);
        for i in 0..200_000 {
            // 12.8 MB together: no step takes a twelfth of it at once.
            map.insert([i % 64, i / 64 % 64, i / 4096], [0u64; 8], &most).unwrap();
        }
        let sizes: Vec<usize> = map.pieces.iter().map(HashMap::len).collect();
        assert!(sizes.iter().all(|n| (2_500..4_000).contains(n)), "{sizes:?}");
    }
}
