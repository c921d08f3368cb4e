//! Findings about one text, moved to where their places are in the next one.

use scenec_text::{CommonEnds, Diagnostic, Span};

/// The findings about `before` whose places all stand unchanged in `after`, at their new offsets; those that the edit touches are
/// left out, and so are repairs that it touches.
pub(crate) fn carry(findings: &[Diagnostic], before: &str, after: &str) -> Vec<Diagnostic> {
    if findings.is_empty() {
        return Vec::new();
    }
    let kept = CommonEnds::of(before, after);
    findings.iter().filter_map(|finding| moved(kept, finding)).collect()
}

fn moved(kept: CommonEnds, finding: &Diagnostic) -> Option<Diagnostic> {
    let mut moved = finding.clone();
    for label in &mut moved.labels {
        label.span = place(kept, label.span)?;
    }
    if let Some(fix) = &mut moved.fix {
        let places = fix.edits.iter().map(|edit| place(kept, edit.span));
        match places.collect::<Option<Vec<_>>>() {
            Some(places) => fix
                .edits
                .iter_mut()
                .zip(places)
                .for_each(|(edit, span)| edit.span = span),
            None => moved.fix = None,
        }
    }
    Some(moved)
}

fn place(kept: CommonEnds, span: Span) -> Option<Span> {
    if span.end <= kept.head {
        return Some(span);
    }
    let [before, after] = kept.tails;
    let moved = |at: u32| Some(at.checked_sub(before)? + after);
    Some(Span::new(moved(span.start)?, moved(span.end)?))
}

#[cfg(test)]
mod tests {
    use proptest::{prop_assert, prop_assert_eq, proptest};
    use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

    use super::carry;

    /// A finding at each of the words, with a repair that removes it.
    fn findings(text: &str, words: &[&str]) -> Vec<Diagnostic> {
        let at = |word: &&str| {
            let start = text.find(word).unwrap() as u32;
            let span = Span::new(start, start + word.len() as u32);
            let edits = vec![Edit {
                span,
                text: String::new(),
            }];
            Diagnostic::new(Code::CoveredSolid, *word, span, "").fix(Fix {
                title: String::new(),
                edits,
                safe: true,
            })
        };
        words.iter().map(at).collect()
    }

    /// Of the findings at `words` in `before`, those at `expect` are carried into `after`, to where these words are there.
    fn check(before: &str, after: &str, words: &[&str], expect: &[&str]) {
        let carried = carry(&findings(before, words), before, after);
        assert_eq!(carried, findings(after, expect), "{before:?} {after:?}");
    }

    #[test]
    fn findings_move_with_their_words() {
        let words = ["first", "second", "third"];
        check("first second third", "first second third", &words, &words);
        check("first second third", "first 2 third", &words, &["first", "third"]);
        check("first second third", "first, second third", &words, &words);
        check("first second third", "first second and third", &words, &words);
        check("first second third", "new", &words, &[]);
        check("first second third", "", &words, &[]);
        let long = "x\n".repeat(10_000);
        let before = format!("first {long}second {long}third");
        let after = format!("first {long}seconds {long}third");
        check(&before, &after, &words, &["first", "second", "third"]);
    }

    proptest! {
        /// What is carried says the same words of the same text.
        #[test]
        fn what_is_carried_stands_there(before in "[ab]{0,12}", after in "[ab]{0,12}", start in 0_u32..12, length in 0_u32..6) {
            let span = Span::new(start.min(before.len() as u32), (start + length).min(before.len() as u32));
            let finding = Diagnostic::new(Code::CoveredSolid, "", span, "");
            for carried in carry(&[finding], &before, &after) {
                prop_assert!(carried.span().end as usize <= after.len());
                prop_assert_eq!(carried.span().of(&after), span.of(&before));
            }
        }
    }
}
