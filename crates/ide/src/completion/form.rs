//! Statements as snippets, read off the table of forms.

use scenec_scene::{Base, DEFAULT_MATERIAL};
use scenec_syntax::{FORMS, Form, FormInfo, Space};

use super::{Completion, CompletionKind, Cursor};
use crate::fields::meaning;
use crate::words::{code, figure};

impl Cursor<'_> {
    /// Every statement, or those about a name space, as snippets. Without the sigil it is found by what it is called.
    pub(super) fn statements(&self, space: Option<Space>) -> Vec<Completion> {
        let rows = FORMS.iter().filter(|row| space.is_none_or(|space| row.space == space));
        let items = rows.map(|row| {
            let item = self.statement(row, row.text, snippet(row, 0, &AXES));
            let filter = match space {
                None => format!("{} {}", row.form.name(), row.text),
                Some(_) => item.filter,
            };
            Completion { filter, ..item }
        });
        items.collect()
    }

    /// What may follow the name that a line begins with: the rest of a statement, or an operator alone where something
    /// follows already.
    pub(super) fn operators(&self, space: Space) -> Vec<Completion> {
        let rows = FORMS.iter().filter(|row| row.space == space);
        let mut list: Vec<Completion> = Vec::new();
        for row in rows {
            let Some((_, rest)) = row.text.split_once(' ') else {
                continue;
            };
            // A rotation is three operators to whoever types one.
            let axes: &[&[&str]] = if row.form == Form::Rotate {
                &[&["x"], &["y"], &["z"]]
            } else {
                &[&AXES]
            };
            for axis in axes {
                let rest = rest.replace("#y=", &format!("#{}=", axis.first().unwrap_or(&"y")));
                let operator = rest.split(' ').next().unwrap_or_default().to_owned();
                if !self.more {
                    list.push(self.statement(row, &rest, snippet(row, 1, axis)));
                } else if list.iter().all(|item| item.label != operator) {
                    list.push(Completion {
                        detail: row.meaning.to_owned(),
                        ..self.item(CompletionKind::Operator, operator)
                    });
                }
            }
        }
        list
    }

    /// The operators that join two objects.
    pub(super) fn joints(&self) -> Vec<Completion> {
        let words = [
            "union: in either",
            "intersection: in both",
            "subtraction: in the left and not in the right",
        ];
        let joints = JOINTS.iter().zip(words);
        joints
            .map(|(joint, words)| Completion {
                detail: words.to_owned(),
                ..self.item(CompletionKind::Operator, *joint)
            })
            .collect()
    }

    fn statement(&self, row: &FormInfo, text: &str, snippet: String) -> Completion {
        Completion {
            detail: row.meaning.to_owned(),
            documentation: fields_of(row),
            insert: snippet,
            snippet: true,
            ..self.item(CompletionKind::Statement, text)
        }
    }
}

/// The axes of a rotation.
const AXES: [&str; 3] = ["x", "y", "z"];

/// What joins two objects.
const JOINTS: [&str; 3] = ["|", "&", "-"];

/// A statement without its first words, as a snippet; a rotation is about one of `axes`.
fn snippet(row: &FormInfo, skip: usize, axes: &[&str]) -> String {
    let mut writer = Writer::new();
    let words: Vec<&str> = row.text.split(' ').collect();
    let first_field = words.len() - row.fields.len();
    for (at, word) in words.iter().enumerate().skip(skip) {
        if !writer.text.is_empty() {
            writer.text.push(' ');
        }
        if let Some(field) = at.checked_sub(first_field) {
            writer.stop(&usual(row.form, field));
        } else if at == 0 {
            writer.plain(row.space.sigil());
            writer.stop(word.trim_start_matches(row.space.sigil()));
        } else if JOINTS.contains(word) {
            writer.choice(&JOINTS);
        } else if *word == "#y=" {
            writer.plain("#");
            writer.choice(axes);
            writer.plain("=");
        } else if Base::ALL.iter().any(|(_, base)| base == word) {
            writer.choice(&Base::ALL.iter().map(|(_, base)| *base).collect::<Vec<_>>());
        } else if word.chars().all(char::is_alphanumeric) {
            writer.stop(word);
        } else {
            writer.plain(word);
        }
    }
    writer.text
}

/// A value that does no harm where nothing else is put in its place.
fn usual(form: Form, field: usize) -> String {
    let value = match form {
        Form::Scale => 1.0,
        Form::Rotate => return "pi".to_owned(),
        Form::Light => [0.0, 5.0, 5.0, 1.0, 1.0, 1.0].get(field).copied().unwrap_or_default(),
        Form::Material => DEFAULT_MATERIAL.values().get(field).copied().unwrap_or_default(),
        _ => 0.0,
    };
    figure(value)
}

/// The values of a form with what they mean.
fn fields_of(row: &FormInfo) -> String {
    let fields = row.fields.iter().enumerate();
    let lines = fields.map(|(number, field)| format!("- {} {}", code(field), meaning(row.form, number)));
    let lines: Vec<_> = lines.collect();
    lines.join("\n")
}

/// Writes a snippet in the syntax that editors share.
pub(super) struct Writer {
    pub(super) text: String,
    stops: u32,
}

impl Writer {
    pub(super) const fn new() -> Self {
        Self {
            text: String::new(),
            stops: 0,
        }
    }

    /// Text as it is.
    pub(super) fn plain(&mut self, text: &str) {
        self.text.push_str(&escaped(text, &['\\', '$', '}']));
    }

    /// A place to fill in, with what stands there at first.
    pub(super) fn stop(&mut self, text: &str) {
        self.stops += 1;
        let text = escaped(text, &['\\', '$', '}']);
        self.text.push_str(&format!("${{{}:{text}}}", self.stops));
    }

    /// A place with a choice.
    pub(super) fn choice(&mut self, words: &[&str]) {
        if let [word] = words {
            return self.plain(word);
        }
        self.stops += 1;
        let words: Vec<_> = words
            .iter()
            .map(|word| escaped(word, &['\\', '$', '}', ',', '|']))
            .collect();
        self.text.push_str(&format!("${{{}|{}|}}", self.stops, words.join(",")));
    }
}

fn escaped(text: &str, special: &[char]) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        if special.contains(&character) {
            safe.push('\\');
        }
        safe.push(character);
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::{AXES, FORMS, Writer, snippet};

    #[test]
    fn what_a_snippet_takes_for_its_own_is_escaped() {
        let mut writer = Writer::new();
        writer.plain("a$b}");
        writer.stop("c\\}");
        writer.choice(&["x,y", "|"]);
        assert_eq!(writer.text, "a\\$b\\}${1:c\\\\\\}}${2|x\\,y,\\||}");
    }

    #[test]
    fn every_form_has_a_snippet_with_a_place_for_each_of_its_parts() {
        for row in FORMS {
            let text = snippet(row, 0, &AXES);
            let stops = text.matches("${").count();
            let names = row
                .text
                .split(' ')
                .filter(|word| word.chars().any(char::is_alphanumeric));
            let joints = usize::from(row.text.contains('|'));
            assert_eq!(stops, names.count() + joints, "{text}");
        }
    }
}
