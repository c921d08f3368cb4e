//! Numbers by keys that are not kept: a key is computed again from what its number stands for. Of a million surfaces the
//! keys alone would take more room than the tree.

use std::hash::{BuildHasher, Hash};

use hashbrown::{DefaultHashBuilder, HashTable};

/// Which numbers are filed, each beside half of what its key hashes to.
#[derive(Default)]
pub(crate) struct Register {
    places: HashTable<(u32, u32)>,
    hashing: DefaultHashBuilder,
}

impl Register {
    /// With room for so many numbers.
    pub(crate) fn with_room(room: usize) -> Self {
        Self {
            places: HashTable::with_capacity(room),
            hashing: DefaultHashBuilder::default(),
        }
    }

    /// The number that is filed under a key.
    pub(crate) fn find<K: Hash + Eq>(&self, key: &K, key_of: impl Fn(u32) -> K) -> Option<u32> {
        let half = self.half(key);
        let same = |place: &(u32, u32)| place.0 == half && key_of(place.1) == *key;
        self.places.find(spread(half), same).map(|place| place.1)
    }

    /// Files a number under a key that has none.
    pub(crate) fn file<K: Hash>(&mut self, key: &K, number: u32) {
        let half = self.half(key);
        self.places
            .insert_unique(spread(half), (half, number), |place| spread(place.0));
    }

    fn half<K: Hash>(&self, key: &K) -> u32 {
        self.hashing.hash_one(key) as u32
    }
}

/// The table goes by the lowest bits and tells neighbours apart by the highest ones.
const fn spread(half: u32) -> u64 {
    (half as u64) << 32 | half as u64
}
