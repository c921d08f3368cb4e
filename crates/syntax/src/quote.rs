//! Words of the source inside messages.

/// The most characters of a word that a message repeats.
const LONGEST: usize = 40;

/// A word of the source between back ticks, cut short if it is long.
#[must_use]
pub fn quote(word: &str) -> String {
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("`{}…`", word.get(..end).unwrap_or_default()),
        None => format!("`{word}`"),
    }
}

#[cfg(test)]
mod tests {
    use super::quote;

    #[test]
    fn long_words_are_cut_between_characters() {
        assert_eq!(quote("ball"), "`ball`");
        assert_eq!(quote(&"é".repeat(41)), format!("`{}…`", "é".repeat(40)));
    }
}
