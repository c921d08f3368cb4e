//! What is not part of the submitted object, by kind.

use scenec_scene::setting;
use scenec_syntax::{Space, Statement};
use scenec_text::Span;

use super::tree::describe;
use super::{MOST, OutlineItem, OutlineKind, more};
use crate::Document;

/// The most characters of a statement that an item repeats.
const LONGEST: usize = 60;

/// The other objects, materials, lights, settings and variables: what their names are bound to last.
pub(super) fn others(document: &Document) -> impl Iterator<Item = OutlineItem> {
    let mut lists: [List; 5] = std::array::from_fn(|_| List::default());
    let table = &document.interpretation().symbols;
    let mut last = vec![None; table.symbols().len()];
    let mut rendered = vec![false; table.symbols().len()];
    for (id, definition) in table.numbered_definitions() {
        let symbol = definition.symbol.0 as usize;
        if let (Some(last), Some(rendered)) = (last.get_mut(symbol), rendered.get_mut(symbol)) {
            *last = Some(definition.line);
            *rendered |= document.facts().taken(id).is_some();
        }
    }
    for ((symbol, line), rendered) in table.symbols().iter().zip(last).zip(rendered) {
        let place = match symbol.space {
            Space::Object if rendered => continue,
            Space::Object => 0,
            Space::Material => 1,
            Space::Light => 2,
            Space::Variable if setting(document.words(symbol.name)).is_some() => 3,
            Space::Variable => 4,
        };
        if let (Some(line), Some(list)) = (line, lists.get_mut(place)) {
            list.add(document, line);
        }
    }
    lists.into_iter().flat_map(List::finish)
}

#[derive(Default)]
struct List {
    items: Vec<OutlineItem>,
    left_out: usize,
    /// The last thing left out.
    last: (Span, Span),
}

impl List {
    fn add(&mut self, document: &Document, line: Span) {
        let Some((statement, _)) = document.statement_at(line.start) else {
            return;
        };
        if self.items.len() < MOST {
            self.items.push(item(document.text(), line, statement));
        } else {
            self.left_out += 1;
            self.last = (line, statement.name());
        }
    }

    fn finish(mut self) -> Vec<OutlineItem> {
        if self.left_out > 0 {
            self.items.push(more(self.left_out, self.last.0, self.last.1));
        }
        self.items
    }
}

fn item(text: &str, line: Span, statement: &Statement) -> OutlineItem {
    let name = statement.name().of(text);
    let values = statement.values();
    let (kind, detail) = match statement {
        Statement::Material { .. } => (OutlineKind::Material, words(text, values.get(7..).unwrap_or_default())),
        Statement::Light { .. } => (OutlineKind::Light, words(text, values.get(..3).unwrap_or_default())),
        Statement::Variable { .. } if setting(name).is_some() => (OutlineKind::Setting, words(text, values)),
        Statement::Variable { .. } => (OutlineKind::Variable, words(text, values)),
        _ => match describe(text, statement) {
            Some((kind, what)) => (kind, format!("{what}, not rendered")),
            None => (OutlineKind::Base, String::new()),
        },
    };
    OutlineItem {
        name: format!("{}{name}", statement.form().info().space.sigil()),
        detail,
        kind,
        line,
        name_span: statement.name(),
        children: Vec::new(),
    }
}

/// Values as they are written, with one space between them.
fn words(text: &str, values: &[scenec_syntax::Value]) -> String {
    let words: Vec<&str> = values.iter().map(|value| value.span.of(text)).collect();
    let words = words.join(" ");
    match words.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", words.get(..end).unwrap_or_default()),
        None => words,
    }
}
