//! Applying the repairs that findings offer.
//!
//! It must not know files: a text comes in, a text goes out.

use std::collections::BTreeMap;

use scenec_text::{Edit, Fix, Severity, SourceFile};

use crate::finding::{Finding, find};
use crate::levels::Levels;

/// How often a file is gone over: a repair may bring up the next one.
const ROUNDS: usize = 32;

/// A file after its repairs.
#[derive(Debug)]
pub(crate) struct Mended {
    pub(crate) source: SourceFile,
    /// What is left to say about it.
    pub(crate) findings: Vec<Finding>,
    /// How many repairs were applied.
    pub(crate) count: usize,
}

/// Whether a finding would be repaired.
pub(crate) fn applies(finding: &Finding, unsafe_too: bool) -> bool {
    finding
        .diagnostic
        .fix
        .as_ref()
        .is_some_and(|fix| fix.safe || unsafe_too)
}

/// Applies repairs until none is left, or until they go round in circles. Of two that touch the same place one waits
/// for the next round; repairs that bring up an error are taken back.
///
/// The text must be what is in the file: every byte UTF-8.
pub(crate) fn mend(source: SourceFile, findings: Vec<Finding>, levels: &Levels, unsafe_too: bool) -> Mended {
    let mut mended = Mended {
        source,
        findings,
        count: 0,
    };
    for _ in 0..ROUNDS {
        let fixes = mended.findings.iter().filter(|finding| applies(finding, unsafe_too));
        let fixes = fixes.filter_map(|finding| finding.diagnostic.fix.as_ref());
        let (text, count) = apply(mended.source.text(), fixes);
        if count == 0 {
            break;
        }
        // Repairs that make a file too large for this program are no repairs.
        let Ok(source) = SourceFile::new(mended.source.name(), text) else {
            break;
        };
        let findings = find(&source, &[], levels);
        if errors(&findings) > errors(&mended.findings) {
            break;
        }
        mended = Mended {
            source,
            findings,
            count: mended.count + count,
        };
    }
    mended
}

/// Findings that leave a file without a meaning, whatever the levels say of others.
fn errors(findings: &[Finding]) -> usize {
    let fatal = |finding: &&Finding| finding.diagnostic.severity() == Severity::Error;
    findings.iter().filter(fatal).count()
}

/// The text with as many of the repairs as have room beside each other, and how many those are.
fn apply<'a>(text: &str, fixes: impl Iterator<Item = &'a Fix>) -> (String, usize) {
    let mut taken: BTreeMap<u32, &Edit> = BTreeMap::new();
    let mut count = 0;
    for fix in fixes {
        let fits = |edit: &Edit| text.get(edit.span.range()).is_some() && has_room(&taken, edit);
        if !fix.edits.is_empty() && fix.edits.iter().all(fits) {
            taken.extend(fix.edits.iter().map(|edit| (edit.span.start, edit)));
            count += 1;
        }
    }
    let mut mended = String::with_capacity(text.len());
    let mut at = 0;
    for edit in taken.values() {
        mended.push_str(text.get(at..edit.span.start as usize).unwrap_or_default());
        mended.push_str(&edit.text);
        at = edit.span.end as usize;
    }
    mended.push_str(text.get(at..).unwrap_or_default());
    (mended, count)
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
    use scenec_text::{Edit, Fix, Span};

    use super::apply;

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
        assert_eq!(apply(text, fixes.iter()), (expect.0.to_owned(), expect.1), "{edits:?}");
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
        assert_eq!(apply("abcdef", fixes.iter()), ("bcdf".to_owned(), 1));
    }
}
