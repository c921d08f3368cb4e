//! A name for bytes, the same in every run and on every machine.

/// FNV-1a over 128 bits (Fowler, Noll, Vo), which takes nobody's ill will into account: whoever may write into the folder
/// may as well replace the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Hash(u128);

const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
const PRIME: u128 = (1 << 88) + 0x13b;

impl Hash {
    /// The name of these texts in this order. Each counts with its length, so that none can lend letters to the next.
    pub(crate) fn of(parts: &[&[u8]]) -> Self {
        let mut value = BASIS;
        for part in parts {
            for byte in (part.len() as u64).to_le_bytes().iter().chain(*part) {
                value = (value ^ u128::from(*byte)).wrapping_mul(PRIME);
            }
        }
        Self(value)
    }

    /// The number.
    pub(crate) const fn value(self) -> u128 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::Hash;

    fn check(a: &[&[u8]], b: &[&[u8]], same: bool) {
        assert_eq!(Hash::of(a) == Hash::of(b), same, "{a:?} {b:?}");
    }

    #[test]
    fn different_texts_have_different_names() {
        check(&[b"ab", b"c"], &[b"ab", b"c"], true);
        check(&[b"ab", b"c"], &[b"a", b"bc"], false);
        check(&[b"", b"a"], &[b"a", b""], false);
        check(&[b"a"], &[b"b"], false);
        check(&[], &[b""], false);
    }

    #[test]
    fn a_name_stays_the_same_from_version_to_version() {
        assert_eq!(Hash::of(&[]).value(), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
    }
}
