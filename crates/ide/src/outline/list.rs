//! What is not part of the submitted object, by kind.

use scenec_interpret::Definition;
use scenec_scene::setting;
use scenec_syntax::{Space, Statement};
use scenec_text::Span;

use super::tree::describe;
use super::{MOST, OutlineItem, OutlineKind, more};
use crate::Document;
use crate::names::statement;

/// The most characters of a statement that an item repeats.
const LONGEST: usize = 60;

/// The other objects, materials, lights, settings and variables. `shown` tells which definitions are part of the tree.
pub(super) fn others(document: &Document, shown: &[bool]) -> Vec<OutlineItem> {
    let mut lists: [List; 5] = std::array::from_fn(|_| List::default());
    let table = &document.interpretation().symbols;
    let mut last = vec![usize::MAX; table.symbols().len()];
    let mut in_tree = vec![false; table.symbols().len()];
    for (index, definition) in table.definitions().iter().enumerate() {
        let symbol = definition.symbol.0 as usize;
        if let (Some(last), Some(in_tree)) = (last.get_mut(symbol), in_tree.get_mut(symbol)) {
            *last = index;
            *in_tree |= shown.get(index).copied().unwrap_or_default();
        }
    }
    for (index, definition) in table.definitions().iter().enumerate() {
        let symbol = definition.symbol.0 as usize;
        if last.get(symbol) != Some(&index) || in_tree.get(symbol) != Some(&false) {
            continue;
        }
        let space = table.symbols().get(symbol).map(|symbol| symbol.space);
        let name = table
            .symbols()
            .get(symbol)
            .map(|symbol| symbol.name.of(document.text()));
        let place = match space {
            Some(Space::Object) => 0,
            Some(Space::Material) => 1,
            Some(Space::Light) => 2,
            Some(Space::Variable) if name.and_then(setting).is_some() => 3,
            _ => 4,
        };
        if let Some(list) = lists.get_mut(place) {
            list.add(document, definition);
        }
    }
    lists.into_iter().flat_map(List::finish).collect()
}

#[derive(Default)]
struct List {
    items: Vec<OutlineItem>,
    left_out: usize,
    /// The last thing left out.
    last: (Span, Span),
}

impl List {
    fn add(&mut self, document: &Document, definition: &Definition) {
        let statement = document.line_at(definition.line.start).and_then(statement);
        let Some(statement) = statement else { return };
        if self.items.len() < MOST {
            self.items.push(item(document.text(), definition.line, statement));
        } else {
            self.left_out += 1;
            self.last = (definition.line, statement.name());
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
