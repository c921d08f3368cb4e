//! Numbers by keys that are not kept: a key is computed again from what its number stands for. Of a million surfaces the
//! keys alone would take more room than the tree.
//!
//! An entry is one number in one list. The places of a large table are all over the memory, and to get there takes longer than
//! everything else: a table that keeps notes beside its entries goes there twice.

use std::hash::{BuildHasher, Hash};
use std::hint::black_box;

use hashbrown::DefaultHashBuilder;

/// So many keys are best looked for at once, see [`Register::expect`].
pub(crate) const AT_ONCE: usize = 32;

/// The fewest slots.
const FEWEST: usize = 16;

/// Which numbers are filed, each beside half of what its key hashes to.
pub(crate) struct Register {
    /// A power of two of them, of which at least half are free: those are 0. Any other has the half in its upper half, and the
    /// number and one in its lower half.
    slots: Vec<u64>,
    taken: usize,
    hashing: DefaultHashBuilder,
}

impl Default for Register {
    fn default() -> Self {
        Self::with_room(0)
    }
}

impl Register {
    /// With room for so many numbers.
    pub(crate) fn with_room(room: usize) -> Self {
        Self {
            slots: vec![0; (2 * room).next_power_of_two().max(FEWEST)],
            taken: 0,
            hashing: DefaultHashBuilder::default(),
        }
    }

    /// Half of what a key hashes to.
    pub(crate) fn half<K: Hash>(&self, key: &K) -> u32 {
        self.hashing.hash_one(key) as u32
    }

    /// Reads where a key with this half would stand, for nothing but to have it at hand: of several that are looked for next, the
    /// processor fetches all places at once.
    pub(crate) fn expect(&self, half: u32) {
        black_box(self.slots[self.place(half)]);
    }

    /// The number that is filed under a key with this half, if it is the same.
    pub(crate) fn find(&self, half: u32, same: impl Fn(u32) -> bool) -> Option<u32> {
        let mut place = self.place(half);
        loop {
            let slot = self.slots[place];
            if slot == 0 {
                return None;
            }
            let number = slot as u32 - 1;
            if (slot >> 32) as u32 == half && same(number) {
                return Some(number);
            }
            place = self.after(place);
        }
    }

    /// Files a number under a key that has none, by its half.
    pub(crate) fn file(&mut self, half: u32, number: u32) {
        self.taken += 1;
        if 2 * self.taken > self.slots.len() {
            let larger = vec![0; 2 * self.slots.len()];
            for slot in std::mem::replace(&mut self.slots, larger) {
                if slot != 0 {
                    self.put(slot);
                }
            }
        }
        self.put(u64::from(half) << 32 | u64::from(number + 1));
    }

    fn put(&mut self, slot: u64) {
        let mut place = self.place((slot >> 32) as u32);
        while self.slots[place] != 0 {
            place = self.after(place);
        }
        self.slots[place] = slot;
    }

    const fn place(&self, half: u32) -> usize {
        half as usize & (self.slots.len() - 1)
    }

    const fn after(&self, place: usize) -> usize {
        (place + 1) & (self.slots.len() - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::Register;

    /// So many keys get the numbers under which they were filed, and others none, whatever room there was.
    fn check(count: u32, room: usize) {
        let mut register = Register::with_room(room);
        let key_of = |number| u64::from(number) * 3;
        let find = |register: &Register, key| register.find(register.half(&key), |number| key_of(number) == key);
        for number in 0..count {
            let key = key_of(number);
            assert_eq!(find(&register, key), None);
            register.file(register.half(&key), number);
        }
        for key in 0..key_of(count) {
            let expect = (key % 3 == 0).then_some((key / 3) as u32);
            assert_eq!(find(&register, key), expect, "{key}");
        }
    }

    #[test]
    fn numbers_are_found_under_their_keys() {
        for (count, room) in [(0, 0), (8, 0), (9, 0), (1000, 1000), (1000, 3)] {
            check(count, room);
        }
    }
}
