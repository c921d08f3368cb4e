//! `!x := sphere`

use scenec_scene::{Base, Leaf, MaterialId, SolidKind};
use scenec_syntax::{Statement, quote};
use scenec_text::{Code, Diagnostic, Span, closest};

use super::operand;
use crate::Role;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, base: Span) {
    let id = state.objects.mention(name, Role::Define, &mut state.symbols);
    let Some(known) = base_of(state, base) else {
        let finding = unknown_base(state, name, base);
        state.report(finding);
        operand::poison(state, id);
        return;
    };
    let leaf = Leaf {
        base: known,
        steps: None,
        material: MaterialId::DEFAULT,
    };
    let solid = state.push_solid(SolidKind::Leaf(leaf), line);
    operand::bind(state, id, solid, line);
}

/// Whether the statement is an object of no known base: that is no statement of the language at all, wherever it stands.
pub(super) fn is_malformed(state: &State<'_>, statement: &Statement) -> bool {
    matches!(statement, Statement::Object { base, .. } if base_of(state, *base).is_none())
}

fn base_of(state: &State<'_>, base: Span) -> Option<Base> {
    let word = base.of(state.text);
    Base::ALL
        .iter()
        .find(|(_, known)| *known == word)
        .map(|(base, _)| *base)
}

fn unknown_base(state: &mut State<'_>, name: Span, base: Span) -> Diagnostic {
    let (name, word) = (name.of(state.text), base.of(state.text));
    let words: Vec<_> = Base::ALL.iter().map(|(_, known)| *known).collect();
    let finding = Diagnostic::new(
        Code::UnknownBase,
        format!("unknown base object {}", quote(word)),
        base,
        format!("expected `{}`", words.join("` or `")),
    );
    let copied = state.objects.find_mut(word).and_then(|entry| entry.bound_mut());
    if let Some(object) = copied {
        object.used = true;
        let copy = quote(&format!("!{name} := {word} | {word}"));
        return finding.help(format!("to copy an object, combine it with itself: {copy}"));
    }
    match closest(word, words) {
        Some(near) => finding.help(format!("did you mean `{near}`?")),
        None => finding,
    }
}
