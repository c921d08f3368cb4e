//! How a comment that allows something is written.

use scenec_text::{Code, Span};

use super::place;

/// What such a comment begins with.
pub(super) const MARK: &str = "scenec:";

/// A comment that begins with the mark.
pub(super) struct Allow {
    /// The comment from its slash on.
    pub(super) comment: Span,
    /// The word behind the colon; empty if there is none.
    pub(super) verb: Span,
    /// The codes, if the verb is `allow`.
    pub(super) named: Vec<Named>,
}

/// A code in such a comment.
pub(super) struct Named {
    /// The word.
    pub(super) span: Span,
    /// The code that it names, if there is one.
    pub(super) code: Option<Code>,
    /// Whether it silenced a finding.
    pub(super) used: bool,
}

impl Allow {
    /// Reads a comment; `None` if it is an ordinary one.
    pub(super) fn read(comment: Span, text: &str) -> Option<Self> {
        let whole = comment.of(text);
        let rest = whole
            .trim_start_matches('/')
            .trim_start()
            .strip_prefix(MARK)?
            .trim_start();
        let verb = word(rest);
        let mut named = Vec::new();
        if verb == "allow" {
            for part in rest.get(verb.len()..).unwrap_or_default().split(',') {
                let part = part.trim();
                let id = word(part);
                if !id.is_empty() {
                    named.push(Named {
                        span: place(comment, whole, id),
                        code: Code::ALL.iter().copied().find(|code| code.id() == id),
                        used: false,
                    });
                }
                // What follows a code without a comma is a reason.
                if id.len() < part.len() {
                    break;
                }
            }
        }
        Some(Self {
            comment,
            verb: place(comment, whole, verb),
            named,
        })
    }
}

fn word(text: &str) -> &str {
    text.split(char::is_whitespace).next().unwrap_or_default()
}
