//! Scenes with gaps: words in braces that a run fills in, and statements that are written many times over.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Deserialize;

/// The most copies of a text; a case is a file, and a file may say anything.
const MOST: u32 = 1 << 20;

/// A text that is written many times over.
#[derive(Clone, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Repeat {
    /// The word that stands for all copies.
    word: String,
    /// One copy: `{i}` becomes its number, `{x}`, `{y}` and `{z}` the number's ones, tens and hundreds, `{h}` its
    /// half, `{next}` the number that follows.
    text: String,
    /// How many, in words, so that a run can fill it in.
    count: String,
}

/// Fills in the words, then the copies.
pub(super) fn fill(text: &str, with: &BTreeMap<String, String>, repeats: &[Repeat]) -> String {
    let words = |text: &str| words(text, with);
    let mut filled = words(text);
    for repeat in repeats {
        let gap = format!("{{{}}}", repeat.word);
        if !filled.contains(&gap) {
            continue;
        }
        let copy = words(&repeat.text);
        let count = words(&repeat.count).parse::<u32>().unwrap_or(0).min(MOST);
        let mut copies = String::new();
        for i in 0..count {
            let one = [
                ("{i}", i),
                ("{next}", i + 1),
                ("{x}", i % 10),
                ("{y}", i / 10 % 10),
                ("{z}", i / 100 % 10),
                ("{h}", i / 2),
            ]
            .iter()
            .fold(copy.clone(), |text, (word, value)| {
                text.replace(word, &value.to_string())
            });
            let _ = writeln!(copies, "{}", one.trim_end());
        }
        filled = filled.replace(&gap, &copies);
    }
    filled
}

/// Fills in the words alone.
pub(super) fn words(text: &str, with: &BTreeMap<String, String>) -> String {
    with.iter().fold(text.to_owned(), |text, (word, value)| {
        text.replace(&format!("{{{word}}}"), value)
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{Repeat, fill};

    fn check(text: &str, count: &str, expect: &str) {
        let with = BTreeMap::from([("k".to_owned(), "2".to_owned())]);
        let repeat = Repeat {
            word: "all".to_owned(),
            text: "a{i} := {k}{x}{y}".to_owned(),
            count: count.to_owned(),
        };
        assert_eq!(fill(text, &with, &[repeat]), expect);
    }

    #[test]
    fn words_and_copies_are_filled_in() {
        check("x := {k} {k}{other}", "9", "x := 2 2{other}");
        check("{all}", "{k}", "a0 := 200\na1 := 210\n");
        check("{all}", "many", "");
    }
}
