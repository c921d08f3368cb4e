//! Numbers by keys that are not kept: a key is computed again from what its number stands for. Of a million surfaces the
//! keys alone would take more room than the tree.

use std::hash::{BuildHasher, Hash};

use hashbrown::{DefaultHashBuilder, HashTable};

/// Which numbers are filed, each under what its key hashes to.
#[derive(Default)]
pub(crate) struct Register {
    places: HashTable<(u64, u32)>,
    hashing: DefaultHashBuilder,
}

impl Register {
    /// The number that is filed under a key.
    pub(crate) fn find<K: Hash + Eq>(&self, key: &K, key_of: impl Fn(u32) -> K) -> Option<u32> {
        let hash = self.hashing.hash_one(key);
        let same = |place: &(u64, u32)| place.0 == hash && key_of(place.1) == *key;
        self.places.find(hash, same).map(|place| place.1)
    }

    /// Files a number under a key that has none.
    pub(crate) fn file<K: Hash>(&mut self, key: &K, number: u32) {
        let hash = self.hashing.hash_one(key);
        self.places.insert_unique(hash, (hash, number), |place| place.0);
    }
}
