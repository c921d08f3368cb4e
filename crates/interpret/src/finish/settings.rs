//! The settings, as they stand at the end of the file.

use scenec_scene::{Material, SETTINGS, SettingInfo, Settings};
use scenec_text::{Code, Diagnostic, Span};

use crate::bindings::Variable;
use crate::names::Binding;
use crate::state::State;

/// The settings, and whether each of them is given and in range; where not, another value stands for it. Reports what is
/// missing or out of range.
pub(super) fn gather(state: &mut State<'_>, last: Span) -> (Settings, bool) {
    let mut findings = Vec::new();
    let mut missing = Vec::new();
    let mut complete = true;
    for row in SETTINGS {
        match found(state, row) {
            Found::Value(variable) => {
                if !row.range.holds(variable.value) {
                    findings.push(out_of_range(state, row, variable));
                    complete = false;
                }
            }
            Found::Twice(first, second) => {
                findings.push(twice(row, first, second));
                complete = false;
            }
            Found::Poisoned => complete = false,
            Found::Missing(ignored) if row.default.is_none() => missing.push((row, ignored)),
            Found::Missing(_) => {}
        }
    }
    if !missing.is_empty() {
        findings.push(report_missing(state, &missing, last));
        complete = false;
    }
    for finding in findings {
        state.report(finding);
    }
    (Settings::gather(|name| value(state, name)), complete)
}

/// Whether these settings are as the file wants them, by its own words or by default, and in range.
pub(super) fn known(state: &State<'_>, names: &[&str]) -> bool {
    let known = |name: &&str| {
        scenec_scene::setting(name).is_some_and(|row| match found(state, row) {
            Found::Value(variable) => row.range.holds(variable.value),
            Found::Missing(_) => row.default.is_some(),
            Found::Twice(..) | Found::Poisoned => false,
        })
    };
    names.iter().all(known)
}

enum Found<'s> {
    Value(&'s Variable),
    Twice(&'s Variable, &'s Variable),
    Poisoned,
    /// Nothing sets it; the last line that would have, but was ignored.
    Missing(Option<Span>),
}

fn found<'s>(state: &'s State<'_>, row: &SettingInfo) -> Found<'s> {
    let names = [Some(row.name), row.alias];
    let entries = names.map(|name| name.and_then(|name| state.variables.find(name)));
    let poisoned = |entry: &&crate::names::Entry<Variable>| matches!(entry.binding, Binding::Poisoned);
    if entries.iter().flatten().any(poisoned) {
        return Found::Poisoned;
    }
    match entries.map(|entry| entry.and_then(|entry| entry.bound())) {
        [Some(name), Some(alias)] => Found::Twice(name, alias),
        [Some(one), None] | [None, Some(one)] => Found::Value(one),
        [None, None] => Found::Missing(
            names
                .into_iter()
                .flatten()
                .find_map(|name| state.variables.ignored(name)),
        ),
    }
}

fn value(state: &State<'_>, name: &str) -> Option<f64> {
    match found(state, scenec_scene::setting(name)?) {
        Found::Value(variable) => Some(variable.value),
        _ => None,
    }
}

fn out_of_range(state: &State<'_>, row: &SettingInfo, variable: &Variable) -> Diagnostic {
    let name = row
        .alias
        .filter(|alias| variable.line.of(state.text).starts_with(alias))
        .unwrap_or(row.name);
    Diagnostic::new(
        Code::SettingOutOfRange,
        format!("`{name}` must be {}", row.range.words()),
        variable.written,
        format!("is {}", variable.value),
    )
    .help(format!("`{name}` holds {}", row.meaning))
}

fn twice(row: &SettingInfo, name: &Variable, alias: &Variable) -> Diagnostic {
    let other = row.alias.unwrap_or(row.name);
    let (first, second) = if name.line.start <= alias.line.start {
        (name, alias)
    } else {
        (alias, name)
    };
    Diagnostic::new(
        Code::SettingTwice,
        format!(
            "`{}` and `{other}` are the same setting, and the file sets both",
            row.name
        ),
        second.line,
        "set again here under its other name",
    )
    .label(first.line, "first set here")
    .help("remove one of the two")
}

fn report_missing(state: &State<'_>, missing: &[(&SettingInfo, Option<Span>)], last: Span) -> Diagnostic {
    let names: Vec<_> = missing.iter().map(|(row, _)| format!("`{}`", row.name)).collect();
    let message = match names.as_slice() {
        [one] => format!("the setting {one} is missing"),
        _ => format!("{} settings are missing: {}", names.len(), names.join(", ")),
    };
    let label = if names.len() == 1 {
        "the file ends without it"
    } else {
        "the file ends without them"
    };
    let mut finding = Diagnostic::new(Code::MissingSettings, message, last, label);
    for (row, ignored) in missing {
        if let Some(ignored) = ignored {
            finding = finding.label(*ignored, format!("this would have set `{}`, but was ignored", row.name));
        }
    }
    if state.text.contains('\r') && !state.text.contains('\n') {
        // All of it is one line, which a comment may have swallowed.
        return finding.help(
            "lines end at a line feed, and this file has carriage returns alone: save it with LF or CRLF line ends",
        );
    }
    let bounces = |material: &Material| material.reflect != 0.0 || material.refract != 0.0;
    let bounces = state.materials.iter().any(bounces);
    let lines: Vec<_> = missing
        .iter()
        .map(|(row, _)| match row.name {
            // More would be of no use to anything in the file.
            "raydepth" if !bounces => "raydepth := 0".to_owned(),
            name => format!("{name} := {}", row.usual),
        })
        .collect();
    finding.help(format!("add, with values of your own:\n{}", lines.join("\n")))
}
