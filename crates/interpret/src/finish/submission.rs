//! Whether there is something to render.

use scenec_scene::SolidId;
use scenec_text::{Code, Diagnostic, Span};

use crate::state::State;

/// The submitted solid; reports if there is none, unless an error spoilt the submission.
pub(super) fn check(state: &mut State<'_>, last: Span) -> Option<SolidId> {
    let submission = &state.submission;
    if let Some((root, _)) = submission.done {
        return Some(root);
    }
    if submission.poisoned {
        return None;
    }
    let message = "no object is submitted, so there is nothing to render";
    let finding = match submission.ignored {
        Some(ignored) => Diagnostic::new(
            Code::MissingSubmission,
            message,
            ignored,
            "this submission is ignored: its object does not exist",
        ),
        None => Diagnostic::new(
            Code::MissingSubmission,
            message,
            last,
            "the file ends without a submission",
        ),
    };
    // What is left over at the end of a file is most likely what should be seen.
    let bound = state
        .objects
        .entries
        .iter()
        .filter(|entry| entry.bound().is_some_and(|object| object.taken.is_none()));
    let top = bound.max_by_key(|entry| entry.last_bound(&state.symbols));
    let name = top.map_or("x", |entry| entry.name.of(state.text));
    let clipped = scenec_syntax::quote(&format!("!{name} <="));
    let finding = finding.help(format!("submit the object to render: {clipped}"));
    state.report(finding);
    None
}
