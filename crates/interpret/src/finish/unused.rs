//! Statements that turned out to do nothing: a variable that nothing reads, a material or an edit that came too late.

use scenec_scene::{SETTINGS, setting};
use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic, Span};

use super::unknown::rename;
use crate::bindings::{Paint, Variable};
use crate::names::Binding;
use crate::state::State;
use crate::statements::report_stale;
use crate::suggest::Suggestions;

/// Reports them all.
pub(super) fn report(state: &mut State<'_>, suggestions: &mut Suggestions) {
    let mut findings = Vec::new();
    for entry in &state.variables.entries {
        if let Some(variable) = entry.bound()
            && !variable.used
            && setting(entry.name.of(state.text)).is_none()
        {
            findings.push(unread(entry.name.of(state.text), variable, suggestions));
        }
    }
    for entry in &state.paints.entries {
        findings.extend(
            entry
                .bound()
                .and_then(|paint| redefined(entry.name.of(state.text), paint)),
        );
    }
    for finding in findings {
        state.report(finding);
    }
    let mut edited: Vec<_> = state.stale.keys().copied().collect();
    edited.sort_unstable();
    for id in edited {
        if let Some(object) = state.objects.entries[id].replace(Binding::Absent) {
            report_stale(state, id, &object);
            state.objects.entries[id].binding = Binding::Bound(object);
        }
    }
}

fn unread(name: &str, variable: &Variable, suggestions: &mut Suggestions) -> Diagnostic {
    let word = quote(name);
    if let Some(read) = variable.last_read {
        return Diagnostic::new(
            Code::UnusedVariable,
            format!("nothing reads {word} after it is set here"),
            variable.line,
            "nothing reads this value",
        )
        .label(read, "an earlier value was last read here")
        .help("move the assignment before the statement that should use it, or remove it");
    }
    let finding = Diagnostic::new(
        Code::UnusedVariable,
        format!("nothing reads the variable {word}"),
        variable.line,
        "neither a setting nor used",
    );
    let settings = SETTINGS
        .iter()
        .flat_map(|row| std::iter::once(row.name).chain(row.alias));
    match suggestions.closest(name, settings.map(Some)) {
        Some(near) => {
            // The statement begins with the name.
            let start = variable.line.start;
            let written = Span::new(start, start + u32::try_from(name.len()).unwrap_or_default());
            finding
                .help(format!("did you mean the setting `{near}`?"))
                .fix(rename(written, near))
        }
        None => finding.help("remove it, or use it"),
    }
}

fn redefined(name: &str, paint: &Paint) -> Option<Diagnostic> {
    let taken = paint.taken.filter(|_| !paint.used)?;
    let word = quote(&format!("{}{name}", Space::Material.sigil()));
    Some(
        Diagnostic::new(
            Code::MaterialRedefined,
            format!("{word} is redefined, but no object takes it afterwards"),
            paint.line,
            "no object has this material",
        )
        .label(taken, format!("an object took {word} here as it stood"))
        .help("move the definition before the object takes it, or give it to the object again"),
    )
}
