//! Finding what a file makes by a part of its name.

use scenec_syntax::Space;
use scenec_text::Span;

use crate::Document;
use crate::names::{statement, subject};

/// The most that one search gives.
const MOST: usize = 256;

/// Something that a statement makes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FoundSymbol {
    /// The name with its sigil.
    pub name: String,
    /// Its name space.
    pub space: Space,
    /// Whether it is one that the language reads.
    pub setting: bool,
    /// The last statement that makes it.
    pub line: Span,
    /// The name in it, without a sigil.
    pub name_span: Span,
}

/// Whatever has the letters of `query` in its name, in their order and in either case; a sigil before them picks a name
/// space. In the order of the file, the first few hundred.
#[must_use]
pub fn symbols(document: &Document, query: &str) -> Vec<FoundSymbol> {
    let query = query.trim();
    let sigil = [Space::Object, Space::Material, Space::Light]
        .into_iter()
        .find(|space| query.starts_with(space.sigil()));
    let letters: Vec<char> = query
        .strip_prefix(sigil.map_or("", Space::sigil))
        .unwrap_or(query)
        .chars()
        .flat_map(char::to_lowercase)
        .collect();
    let text = document.text();
    let table = &document.interpretation().symbols;
    let mut last = vec![None; table.symbols().len()];
    for definition in table.definitions() {
        if let Some(last) = last.get_mut(definition.symbol.0 as usize) {
            *last = Some(definition.line);
        }
    }
    let found = table.symbols().iter().zip(last).filter_map(|(symbol, line)| {
        let name = symbol.name.of(text);
        let line = document.line_at(line?.start)?;
        if sigil.is_some_and(|space| space != symbol.space) || !matches(name, &letters) {
            return None;
        }
        Some(FoundSymbol {
            name: format!("{}{name}", symbol.space.sigil()),
            space: symbol.space,
            setting: symbol.space == Space::Variable && scenec_scene::setting(name).is_some(),
            line: statement(line).map(|_| line.span)?,
            name_span: subject(line)?,
        })
    });
    found.take(MOST).collect()
}

fn matches(name: &str, letters: &[char]) -> bool {
    let mut rest = letters.iter().peekable();
    for character in name.chars().flat_map(char::to_lowercase) {
        rest.next_if(|letter| **letter == character);
    }
    rest.peek().is_none()
}
