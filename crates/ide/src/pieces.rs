//! A text after several rounds of edits, as one round of edits of the first text.

use scenec_text::{Edit, Span};

/// A text put together from pieces of an old one and new words.
#[derive(Clone, Debug)]
pub(crate) struct Pieces<'a> {
    old: &'a str,
    pieces: Vec<Piece>,
}

#[derive(Clone, Debug)]
enum Piece {
    Old(Span),
    New(String),
}

impl Piece {
    fn len(&self) -> u32 {
        match self {
            Self::Old(span) => span.len(),
            Self::New(words) => u32::try_from(words.len()).unwrap_or(u32::MAX),
        }
    }

    /// The part from `start` up to, not including, `end`, counted from the piece's own start.
    fn part(&self, start: u32, end: u32) -> Self {
        match self {
            Self::Old(span) => Self::Old(Span::new(span.start + start, span.start + end)),
            Self::New(words) => Self::New(Span::new(start, end).of(words).to_owned()),
        }
    }
}

impl<'a> Pieces<'a> {
    /// The old text as it is.
    pub(crate) fn new(old: &'a str) -> Self {
        let whole = Span::new(0, u32::try_from(old.len()).unwrap_or(u32::MAX));
        Self {
            old,
            pieces: vec![Piece::Old(whole)],
        }
    }

    /// Applies edits of the present text, which come in its order and don't overlap.
    pub(crate) fn apply(&mut self, edits: &[Edit]) {
        let mut next = Vec::with_capacity(self.pieces.len() + 2 * edits.len());
        let mut edits = edits.iter().peekable();
        // Where the piece at hand begins in the present text, and up to where the text is done with.
        let (mut begin, mut done) = (0, 0);
        for piece in &self.pieces {
            let end = begin + piece.len();
            while let Some(edit) = edits.next_if(|edit| edit.span.start < end) {
                if edit.span.start > done.max(begin) {
                    next.push(piece.part(done.max(begin) - begin, edit.span.start - begin));
                }
                next.push(Piece::New(edit.text.clone()));
                done = edit.span.end;
            }
            if done < end {
                next.push(piece.part(done.max(begin) - begin, end - begin));
            }
            begin = end;
        }
        next.extend(edits.map(|edit| Piece::New(edit.text.clone())));
        self.pieces = next;
    }

    /// The present text.
    pub(crate) fn text(&self) -> String {
        let words = self.pieces.iter().map(|piece| match piece {
            Piece::Old(span) => span.of(self.old),
            Piece::New(words) => words.as_str(),
        });
        words.collect()
    }

    /// The edits of the old text that give the present one.
    pub(crate) fn edits(&self) -> Vec<Edit> {
        let mut edits = Vec::new();
        let mut at = 0;
        let mut new = String::new();
        let end = Piece::Old(Span::at(u32::try_from(self.old.len()).unwrap_or(u32::MAX)));
        for piece in self.pieces.iter().chain([&end]) {
            match piece {
                Piece::New(words) => new.push_str(words),
                Piece::Old(span) => {
                    if at < span.start || !new.is_empty() {
                        edits.push(Edit {
                            span: Span::new(at, span.start),
                            text: std::mem::take(&mut new),
                        });
                    }
                    at = span.end;
                }
            }
        }
        edits
    }
}

#[cfg(test)]
mod tests {
    use scenec_text::{Edit, Span, apply};

    use super::Pieces;

    /// Rounds of edits: from, to, and what stands there then.
    fn check(old: &str, rounds: &[&[(u32, u32, &str)]], expect: &str) {
        let mut pieces = Pieces::new(old);
        for round in rounds {
            let edit = |(start, end, text): &(u32, u32, &str)| Edit {
                span: Span::new(*start, *end),
                text: (*text).to_owned(),
            };
            let edits: Vec<Edit> = round.iter().map(edit).collect();
            let stepwise = apply(&pieces.text(), &edits);
            pieces.apply(&edits);
            assert_eq!(pieces.text(), stepwise, "{rounds:?}");
        }
        assert_eq!(pieces.text(), expect, "{rounds:?}");
        assert_eq!(apply(old, &pieces.edits()), expect, "{rounds:?}");
    }

    #[test]
    fn several_rounds_are_one() {
        check("abcdef", &[], "abcdef");
        check("abcdef", &[&[(1, 2, "BB"), (4, 4, "-")]], "aBBcd-ef");
        check(
            "abcdef",
            &[&[(1, 2, "BB"), (4, 4, "-")], &[(0, 3, ""), (5, 5, "!")]],
            "cd!-ef",
        );
        check("abcdef", &[&[(0, 6, "")], &[(0, 0, "x")], &[(1, 1, "y")]], "xy");
        check("abcdef", &[&[(6, 6, "g")], &[(5, 7, "")]], "abcde");
    }
}
