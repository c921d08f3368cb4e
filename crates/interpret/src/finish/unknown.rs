//! References that led nowhere, now that every line of the file is known.

use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

use crate::names::{Names, Unknown};
use crate::state::State;
use crate::suggest::Suggestions;

/// Reports each of them, with the line that would have helped or the name that may have been meant.
pub(super) fn report(state: &mut State<'_>, suggestions: &mut Suggestions) {
    for unknown in std::mem::take(&mut state.unknown) {
        let finding = match unknown.space {
            Space::Variable => describe(state, &state.variables, &unknown, Code::UnknownVariable, suggestions),
            Space::Material => describe(state, &state.paints, &unknown, Code::UnknownMaterial, suggestions),
            Space::Object | Space::Light => describe(state, &state.objects, &unknown, Code::UnknownObject, suggestions),
        };
        state.report(finding);
    }
}

fn describe<T>(
    state: &State<'_>,
    names: &Names<'_, T>,
    unknown: &Unknown,
    code: Code,
    suggestions: &mut Suggestions,
) -> Diagnostic {
    let entry = &names.entries[unknown.id];
    let name = entry.name.of(state.text);
    let noun = unknown.space.noun();
    let sigil = unknown.space.sigil();
    let word = quote(&format!("{sigil}{}", name));
    let message = format!("the {noun} {word} does not exist here, so this statement is ignored");
    let finding = Diagnostic::new(code, message, unknown.span, format!("no such {noun}"));
    if let Some(ignored) = unknown.ignored {
        return finding.label(ignored, format!("this would have made {word}, but was ignored itself"));
    }
    if let Some(later) = entry.first_bound(&state.symbols) {
        return finding
            .label(later, format!("{word} is only made here"))
            .help("a statement knows only what stands before it: move this one down, or the other up");
    }
    if let Some((other, made)) = elsewhere(state, name) {
        let theirs = quote(&format!("{}{}", other.sigil(), name));
        return finding
            .label(
                made,
                format!("{theirs} is made here, {} {}", article(other), other.noun()),
            )
            .help(format!(
                "{theirs} is {} {}, and this place takes {} {noun}: names of different kinds never meet",
                article(other),
                other.noun(),
                article(unknown.space)
            ));
    }
    let before = |line: Option<Span>| line.is_some_and(|line| line.start < unknown.span.start);
    let known = names
        .entries
        .iter()
        .map(|other| before(other.first_bound(&state.symbols)).then_some(other.name.of(state.text)));
    match suggestions.closest(name, known) {
        Some(near) => {
            let near_word = quote(&format!("{sigil}{near}"));
            finding
                .help(format!("did you mean {near_word}?"))
                .fix(rename(unknown.span, near))
        }
        None => finding,
    }
}

/// The name spaces in which the name is bound before or after, though not in the one where it was looked for.
fn elsewhere(state: &State<'_>, name: &str) -> Option<(Space, Span)> {
    let object = state
        .objects
        .find(name)
        .and_then(|entry| entry.first_bound(&state.symbols));
    let paint = state
        .paints
        .find(name)
        .and_then(|entry| entry.first_bound(&state.symbols));
    let variable = state
        .variables
        .find(name)
        .and_then(|entry| entry.first_bound(&state.symbols));
    let lamp = state
        .lamps
        .find(name)
        .and_then(|entry| entry.first_bound(&state.symbols));
    let all = [
        (Space::Object, object),
        (Space::Material, paint),
        (Space::Variable, variable),
        (Space::Light, lamp),
    ];
    all.into_iter().find_map(|(space, made)| Some((space, made?)))
}

const fn article(space: Space) -> &'static str {
    match space {
        Space::Object => "an",
        Space::Variable | Space::Material | Space::Light => "a",
    }
}

/// Writes another name; the file may then mean something else.
pub(super) fn rename(name: Span, other: &str) -> Fix {
    Fix {
        title: format!("write `{other}`"),
        edits: vec![Edit {
            span: name,
            text: other.to_owned(),
        }],
        safe: false,
    }
}
