//! Applying edits and repairs.

use std::collections::BTreeMap;

use crate::{Edit, Fix};

/// The edits of as many repairs as have room beside each other, in the order of the text, and how many repairs those are.
/// A repair goes in whole or not at all; of two that touch the same place the first one does.
pub fn fitting<'a>(text: &str, fixes: impl IntoIterator<Item = &'a Fix>) -> (Vec<&'a Edit>, usize) {
    let mut taken: BTreeMap<u32, &Edit> = BTreeMap::new();
    let mut count = 0;
    for fix in fixes {
        let fits = |edit: &Edit| text.get(edit.span.range()).is_some() && has_room(&taken, edit);
        if !fix.edits.is_empty() && fix.edits.iter().all(fits) {
            taken.extend(fix.edits.iter().map(|edit| (edit.span.start, edit)));
            count += 1;
        }
    }
    (taken.into_values().collect(), count)
}

/// The text after edits that come in its order and don't overlap.
pub fn apply<'a>(text: &str, edits: impl IntoIterator<Item = &'a Edit>) -> String {
    let mut edited = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        edited.push_str(text.get(at..edit.span.start as usize).unwrap_or_default());
        edited.push_str(&edit.text);
        at = edit.span.end as usize;
    }
    edited.push_str(text.get(at..).unwrap_or_default());
    edited
}

fn has_room(taken: &BTreeMap<u32, &Edit>, edit: &Edit) -> bool {
    let before = taken.range(..=edit.span.start).next_back();
    let after = taken.range(edit.span.start..).next();
    let clear_before =
        before.is_none_or(|(start, other)| *start < edit.span.start && other.span.end <= edit.span.start);
    let clear_after = after.is_none_or(|(start, _)| *start >= edit.span.end && *start > edit.span.start);
    clear_before && clear_after
}

#[cfg(test)]
mod tests {
    use super::{apply, fitting};
    use crate::{Edit, Fix, Span};

    fn mended(text: &str, fixes: &[Fix]) -> (String, usize) {
        let (edits, count) = fitting(text, fixes);
        (apply(text, edits), count)
    }

    /// Repairs of one edit each: from, to, and what stands there then.
    fn check(text: &str, edits: &[(u32, u32, &str)], expect: (&str, usize)) {
        let fix = |(start, end, text): &(u32, u32, &str)| Fix {
            title: String::new(),
            edits: vec![Edit {
                span: Span::new(*start, *end),
                text: (*text).to_owned(),
            }],
            safe: true,
        };
        let fixes: Vec<Fix> = edits.iter().map(fix).collect();
        assert_eq!(mended(text, &fixes), (expect.0.to_owned(), expect.1), "{edits:?}");
    }

    #[test]
    fn repairs_that_have_no_room_wait() {
        check("abcdef", &[], ("abcdef", 0));
        check("abcdef", &[(4, 5, "E"), (0, 2, "")], ("cdEf", 2));
        check("abcdef", &[(1, 4, "-"), (2, 3, "!")], ("a-ef", 1));
        check("abcdef", &[(1, 4, "-"), (3, 5, "!")], ("a-ef", 1));
        check("abcdef", &[(3, 5, "!"), (1, 4, "-")], ("abc!f", 1));
        check("abcdef", &[(1, 2, "-"), (2, 2, "+")], ("a-+cdef", 2));
        check("abcdef", &[(2, 2, "+"), (2, 2, "*")], ("ab+cdef", 1));
        check("é", &[(1, 2, "!")], ("é", 0));
        check("a", &[(0, 9, "!")], ("a", 0));
    }

    #[test]
    fn a_repair_of_several_edits_is_applied_whole_or_not_at_all() {
        let edit = |start, end| Edit {
            span: Span::new(start, end),
            text: String::new(),
        };
        let fix = |edits: &[(u32, u32)]| Fix {
            title: String::new(),
            edits: edits.iter().map(|(start, end)| edit(*start, *end)).collect(),
            safe: true,
        };
        let fixes = [fix(&[(0, 1), (4, 5)]), fix(&[(2, 3), (4, 6)]), fix(&[])];
        assert_eq!(mended("abcdef", &fixes), ("bcdf".to_owned(), 1));
    }
}
