//! References that led nowhere, now that every line of the file is known.

use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic, Span};

use crate::names::{Names, Unknown};
use crate::state::State;
use crate::suggest::Suggestions;

/// Reports each of them, with the line that would have helped or the name that may have been meant.
pub(super) fn report(state: &mut State<'_>, suggestions: &mut Suggestions) {
    for unknown in std::mem::take(&mut state.unknown) {
        let finding = match unknown.space {
            Space::Variable => describe(&state.variables, &unknown, Code::UnknownVariable, suggestions),
            Space::Material => describe(&state.paints, &unknown, Code::UnknownMaterial, suggestions),
            Space::Object | Space::Light => describe(&state.objects, &unknown, Code::UnknownObject, suggestions),
        };
        state.report(finding);
    }
}

fn describe<T>(names: &Names<'_, T>, unknown: &Unknown, code: Code, suggestions: &mut Suggestions) -> Diagnostic {
    let entry = &names.entries[unknown.id];
    let noun = unknown.space.noun();
    let word = quote(&format!("{}{}", unknown.space.sigil(), entry.name));
    let message = format!("the {noun} {word} does not exist here, so this statement is ignored");
    let finding = Diagnostic::new(code, message, unknown.span, format!("no such {noun}"));
    if let Some(ignored) = unknown.ignored {
        return finding.label(ignored, format!("this would have made {word}, but was ignored itself"));
    }
    if let Some(later) = entry.first_bound {
        return finding
            .label(later, format!("{word} is only made here"))
            .help("a statement knows only what stands before it: move this one down, or the other up");
    }
    let before = |line: Option<Span>| line.is_some_and(|line| line.start < unknown.span.start);
    let known = names
        .entries
        .iter()
        .map(|other| before(other.first_bound).then_some(other.name));
    match suggestions.closest(entry.name, known) {
        Some(near) => finding.help(format!(
            "did you mean {}?",
            quote(&format!("{}{near}", unknown.space.sigil()))
        )),
        None => finding,
    }
}
