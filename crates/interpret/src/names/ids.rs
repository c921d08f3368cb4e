//! Which name has which number.

use std::hash::{BuildHasher, Hasher};

use hashbrown::DefaultHashBuilder;

/// The fewest slots of a table that has any; of fewer than four a quarter could not be kept free.
const FEWEST: usize = 16;

/// Of the last two characters of a name four bits each move its place, and the other bits belong to its stem: digits differ in these
/// four only.
const MOVING: u8 = 0x0F;

/// How far apart the places of two names lie that differ by one in the last byte but one. There are ten digits: names that count
/// up lie without a gap.
const ROW: u32 = 10;

/// Places are the same above so many bits where names lie together; these times a number without a pattern, 2^32 over the
/// golden ratio, are how far they give way to others.
const STRIDE_SHIFT: u32 = 14;
const STRIDE: u32 = 0x9E37_79B9;

/// The numbers of names, by what the names hash to; it does not hold the names themselves.
///
/// A name's place is that of its stem, which is the name without what tells the digits at its last two places, moved by these.
/// Large files count their names up, and so those that follow one another lie together: a hundred of them lie in a row, which the
/// processor reads ahead. The places of stems have a seed of their own for every run, which keeps a file from being made so
/// that its names meet in one place.
#[derive(Default)]
pub(super) struct Ids {
    /// A power of two of them, or none; at least a quarter is free, so that a search ends.
    slots: Vec<u64>,
    taken: usize,
    hashing: DefaultHashBuilder,
}

/// A name in eight bytes, or nothing if all are 0; mostly no look at the text is needed to tell it from another.
///
/// The upper half is the place, the lower one the number and one: that fits, since a name is at least a byte of a text whose bytes
/// do. A number and not a struct, for the system has zeros at hand and clears a page when it is touched.
#[derive(Clone, Copy)]
struct Slot(u64);

impl Slot {
    const fn new(place: u32, id: usize) -> Self {
        Self((place as u64) << 32 | (id as u64 + 1))
    }

    const fn is_free(self) -> bool {
        self.0 == 0
    }

    const fn place(self) -> u32 {
        (self.0 >> 32) as u32
    }

    const fn id(self) -> usize {
        (self.0 as u32 - 1) as usize
    }
}

impl Ids {
    /// With room for so many names.
    pub(super) fn with_room(names: usize) -> Self {
        let mut ids = Self::default();
        if names > 0 {
            ids.grow((names + names / 3 + 1).next_power_of_two().max(FEWEST));
        }
        ids
    }

    /// The number of a name, where `is` tells whether a number is that of the name; none if it is not among them.
    pub(super) fn find(&self, name: &str, is: impl Fn(usize) -> bool) -> Option<usize> {
        self.search(self.place(name), is).ok()
    }

    /// The same, but a name that is not among them is added with the number `new`.
    pub(super) fn find_or_add(&mut self, name: &str, new: usize, is: impl Fn(usize) -> bool) -> usize {
        if self.taken + self.taken / 3 >= self.slots.len() {
            self.grow((self.slots.len() * 2).max(FEWEST));
        }
        let place = self.place(name);
        match self.search(place, is) {
            Ok(id) => id,
            Err(free) => {
                self.put(free, Slot::new(place, new));
                self.taken += 1;
                new
            }
        }
    }

    fn place(&self, name: &str) -> u32 {
        let (stem, end) = name.as_bytes().split_at(name.len().saturating_sub(2));
        let mut hasher = self.hashing.build_hasher();
        let (mut still, mut moved) = (0, 0);
        for byte in end {
            still = still << 8 | u16::from(byte & !MOVING);
            moved = moved * ROW + u32::from(byte & MOVING);
        }
        hasher.write(stem);
        hasher.write_u16(still);
        ((hasher.finish() >> 32) as u32).wrapping_add(moved)
    }

    /// The number of a name, or the slot where it would be.
    fn search(&self, place: u32, is: impl Fn(usize) -> bool) -> Result<usize, usize> {
        let mask = self.slots.len().wrapping_sub(1);
        let mut at = place as usize & mask;
        // Names that lie together give way to others together, and far, lest rows of them pile up. An odd stride comes by
        // every slot before it comes back.
        let stride = (place >> STRIDE_SHIFT).wrapping_mul(STRIDE) | 1;
        while let Some(slot) = self
            .slots
            .get(at)
            .map(|slot| Slot(*slot))
            .filter(|slot| !slot.is_free())
        {
            if slot.place() == place && is(slot.id()) {
                return Ok(slot.id());
            }
            at = at.wrapping_add(stride as usize) & mask;
        }
        Err(at)
    }

    fn put(&mut self, at: usize, slot: Slot) {
        if let Some(free) = self.slots.get_mut(at) {
            *free = slot.0;
        }
    }

    fn grow(&mut self, count: usize) {
        let before = std::mem::replace(&mut self.slots, vec![0; count]);
        for slot in before.into_iter().map(Slot).filter(|slot| !slot.is_free()) {
            if let Err(free) = self.search(slot.place(), |_| false) {
                self.put(free, slot);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Ids;

    /// Every name keeps the number that it got, in a table that grows, in one that has room, and in one that has too little.
    fn check(names: &[&str]) {
        for mut ids in [Ids::default(), Ids::with_room(names.len()), Ids::with_room(1)] {
            let mut known: Vec<&str> = Vec::new();
            for name in names.iter().chain(names) {
                let expect = known.iter().position(|other| other == name);
                assert_eq!(ids.find(name, |id| known[id] == *name), expect, "{name}");
                let id = ids.find_or_add(name, known.len(), |id| known[id] == *name);
                assert_eq!(id, expect.unwrap_or(known.len()), "{name}");
                if expect.is_none() {
                    known.push(name);
                }
                // A search for what is not there ends too.
                assert_eq!(ids.find("absent", |id| known[id] == "absent"), None);
            }
        }
    }

    #[test]
    fn names_keep_their_numbers() {
        check(&[]);
        check(&["", "a", "b", "ab", "ba", "\u{e9}", "\u{e8}"]);
        let counted: Vec<String> = (0..3000).map(|number| format!("s{number}")).collect();
        check(&counted.iter().map(String::as_str).collect::<Vec<_>>());
    }
}
