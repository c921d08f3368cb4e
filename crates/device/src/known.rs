//! What devices were measured at in earlier runs, and careful guesses where they never were.

use std::time::Duration;

use crate::assemble::Precision;
use crate::cache::{Cache, Hash};
use crate::info::DeviceInfo;

/// Times in nanoseconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Known {
    /// What the compiler takes for a program that is not kept.
    pub(crate) compiling: f64,
    /// What all else takes before the first ray.
    pub(crate) starting: f64,
    /// How many times faster than the built-in tracer the device is once it runs.
    pub(crate) gain: f64,
}

/// What asking the drivers for their devices takes, nanoseconds, where that was never measured.
const ASKING: f64 = 40e6;

impl Known {
    /// A device of which nothing is known.
    pub(crate) const GUESS: Self = Self {
        compiling: 600e6,
        starting: 100e6,
        gain: 4.0,
    };

    /// What is known of a device.
    pub(crate) fn of(cache: &Cache, info: &DeviceInfo, precision: Precision) -> Self {
        let numbers = read(cache, key(info, precision));
        numbers.map_or(Self::GUESS, |[compiling, starting, gain]| Self {
            compiling,
            starting,
            gain,
        })
    }

    /// Remembers it, if it is news: times come and go, and each writing waits for the disk.
    pub(crate) fn remember(self, cache: &Cache, info: &DeviceInfo, precision: Precision) {
        let before = Self::of(cache, info, precision);
        let news = [
            (self.compiling, before.compiling),
            (self.starting, before.starting),
            (self.gain, before.gain),
        ];
        if news.into_iter().any(|(new, old)| differs(new, old)) {
            write(cache, key(info, precision), [self.compiling, self.starting, self.gain]);
        }
    }
}

/// Remembers what a device took to start, and to compile if it did.
pub(crate) fn remember_start(info: &DeviceInfo, precision: Precision, starting: Duration, compiling: Option<Duration>) {
    let mut known = Known::of(&cache(), info, precision);
    known.starting = starting.as_secs_f64() * 1e9;
    if let Some(time) = compiling {
        known.compiling = time.as_secs_f64() * 1e9;
    }
    known.remember(&cache(), info, precision);
}

/// Remembers that a device traced for so many nanoseconds what would take the built-in tracer so many.
pub fn remember_gain(info: &DeviceInfo, precision: Precision, traced: f64, built_in: f64) {
    let known = Known {
        gain: built_in / traced,
        ..Known::of(&cache(), info, precision)
    };
    known.remember(&cache(), info, precision);
}

/// What asking the drivers takes.
pub(crate) fn asking(cache: &Cache) -> f64 {
    read(cache, asking_key()).map_or(ASKING, |[time]| time)
}

/// Remembers what asking the drivers took, if it is news.
pub(crate) fn remember_asking(cache: &Cache, time: f64) {
    if differs(time, asking(cache)) {
        write(cache, asking_key(), [time]);
    }
}

/// What was measured on this machine.
pub(crate) fn cache() -> Cache {
    Cache::of_user("devices")
}

/// Whether a number is sound, and half of what it was or less, or twice that or more.
fn differs(new: f64, old: f64) -> bool {
    new.is_finite() && new > 0.0 && !(0.5..=2.0).contains(&(new / old))
}

fn asking_key() -> Hash {
    Hash::of(&[b"asking"])
}

fn key(info: &DeviceInfo, precision: Precision) -> Hash {
    let [a, b, c, d] = info.identity();
    Hash::of(&[a, b, c, d, precision.to_string().as_bytes()])
}

fn read<const N: usize>(cache: &Cache, key: Hash) -> Option<[f64; N]> {
    let bytes = cache.get(key)?;
    let (words, rest) = bytes.as_chunks::<8>();
    let numbers: [f64; N] = words
        .iter()
        .map(|word| f64::from_le_bytes(*word))
        .collect::<Vec<_>>()
        .try_into()
        .ok()?;
    let sound = |number: &f64| number.is_finite() && *number > 0.0;
    (rest.is_empty() && numbers.iter().all(sound)).then_some(numbers)
}

fn write<const N: usize>(cache: &Cache, key: Hash, numbers: [f64; N]) {
    cache.put(key, numbers.map(f64::to_le_bytes).as_flattened());
}

#[cfg(test)]
mod tests {
    use super::{ASKING, Known, asking, asking_key, remember_asking};
    use crate::DeviceKind;
    use crate::assemble::Precision;
    use crate::cache::tests::Room;
    use crate::select::tests::device;

    #[test]
    fn what_was_measured_is_known_in_the_next_run() {
        let room = Room::new("known");
        let cache = room.cache(1 << 16);
        let info = device(0, "P", "D", DeviceKind::Gpu);
        let measured = Known {
            compiling: 2e8,
            starting: 5e7,
            gain: 30.0,
        };
        assert_eq!(Known::of(&cache, &info, Precision::F32), Known::GUESS);
        measured.remember(&cache, &info, Precision::F32);
        Known { gain: 33.0, ..measured }.remember(&cache, &info, Precision::F32);
        assert_eq!(Known::of(&cache, &info, Precision::F32), measured);
        assert_eq!(Known::of(&cache, &info, Precision::F64), Known::GUESS);
    }

    #[test]
    fn numbers_that_make_no_sense_are_none() {
        let room = Room::new("senseless");
        let cache = room.cache(1 << 16);
        assert_eq!(asking(&cache), ASKING);
        for time in [0.0, f64::NAN, f64::INFINITY, -1.0] {
            remember_asking(&cache, time);
            assert_eq!(asking(&cache), ASKING);
        }
        for bytes in [&[][..], &[1; 7], &[0; 8], &[1; 16], &f64::NAN.to_le_bytes()] {
            cache.put(asking_key(), bytes);
            assert_eq!(asking(&cache), ASKING, "{bytes:?}");
        }
        remember_asking(&cache, 9e6);
        assert_eq!(asking(&cache), 9e6);
    }
}
