//! What is at a place of a document, and what it is bound to: look-ups that several features share.

use scenec_interpret::{Definition, DefinitionId, Occurrence, Role, Symbol, SymbolId};
use scenec_scene::Material;
use scenec_syntax::{Content, Space, Statement, Value, ValueKind};
use scenec_text::{Diagnostic, Span};

use crate::Document;

impl Document {
    /// The words at a span.
    pub(crate) fn words(&self, span: Span) -> &str {
        span.of(self.text())
    }

    /// An offset that a client gave, brought to where a cursor can stand: between two characters, and not past the end
    /// of its line.
    pub(crate) fn cursor(&self, offset: u32) -> u32 {
        let line = self
            .source()
            .line_span(self.source().line_of(offset))
            .unwrap_or_default();
        let mut offset = offset.clamp(line.start, line.end.max(line.start));
        while !self.text().is_char_boundary(offset as usize) {
            offset -= 1;
        }
        offset
    }

    /// The number of the line of an offset, counted from 1 as people do.
    pub(crate) fn line_number(&self, offset: u32) -> u32 {
        self.source().line_of(offset) + 1
    }

    /// The statement of the line that an offset lies on, with its place; `None` for a line that fits none.
    pub(crate) fn statement_at(&self, offset: u32) -> Option<(&Statement, Span)> {
        let line = self.line_at(offset)?;
        match &line.content {
            Content::Statement(statement) => Some((statement, line.span)),
            Content::Comment | Content::Broken(_) => None,
        }
    }

    /// The names on the statement at a span, in the order of the line.
    pub(crate) fn places_on(&self, statement: Span) -> &[Occurrence] {
        let places = self.occurrences();
        let start = places.partition_point(|place| place.span.start < statement.start);
        let end = places.partition_point(|place| place.span.start < statement.end);
        places.get(start..end).unwrap_or_default()
    }

    /// The name at a span, if it stands on a line that fits a statement.
    pub(crate) fn occurrence(&self, name: Span) -> Option<&Occurrence> {
        let places = self.occurrences();
        let at = places
            .binary_search_by_key(&name.start, |place| place.span.start)
            .ok()?;
        places.get(at).filter(|place| place.span == name)
    }

    /// A row of the symbol table.
    pub(crate) fn symbol_of(&self, id: SymbolId) -> Option<&Symbol> {
        self.interpretation().symbols.symbols().get(id.0 as usize)
    }

    /// The symbol of a name, found by looking through all of them.
    pub(crate) fn symbol(&self, space: Space, name: &str) -> Option<SymbolId> {
        let mut all = (0..).map(SymbolId).zip(self.interpretation().symbols.symbols());
        let same = |symbol: &Symbol| symbol.space == space && self.words(symbol.name) == name;
        all.find(|(_, symbol)| same(symbol)).map(|(id, _)| id)
    }

    /// The definition with this number.
    pub(crate) fn definition_of(&self, id: DefinitionId) -> Option<&Definition> {
        self.interpretation().symbols.definitions().get(id.index())
    }

    /// The name that a definition binds, without a sigil.
    pub(crate) fn name_of(&self, id: DefinitionId) -> &str {
        let symbol = self.definition_of(id).and_then(|found| self.symbol_of(found.symbol));
        symbol.map_or("", |symbol| self.words(symbol.name))
    }

    /// The definition that the statement at a span makes.
    pub(crate) fn defined_by(&self, statement: Span) -> Option<DefinitionId> {
        let places = self.places_on(statement);
        places.iter().find(|place| place.role == Role::Define)?.definition
    }

    /// The first definition that the statement at a span reads.
    pub(crate) fn used_on(&self, statement: Span) -> Option<DefinitionId> {
        let places = self.places_on(statement);
        places.iter().find(|place| place.role == Role::Use)?.definition
    }

    /// What a symbol is bound to before an offset: its last definition there.
    pub(crate) fn binding(&self, symbol: SymbolId, before: u32) -> Option<DefinitionId> {
        self.facts().binding(self, symbol, before)
    }

    /// What was found on the statement at a span.
    pub(crate) fn findings_on(&self, statement: Span) -> impl Iterator<Item = &Diagnostic> {
        let all = self.diagnostics();
        let start = all.partition_point(|finding| finding.span().start < statement.start);
        let rest = all.get(start..).unwrap_or_default().iter();
        rest.take_while(move |finding| finding.span().start < statement.end.max(statement.start + 1))
    }

    /// The number that a value of a statement stands for, its sign included; `None` if it names nothing.
    pub(crate) fn number(&self, value: &Value) -> Option<f64> {
        let number = match value.kind {
            ValueKind::Number(number) => number,
            ValueKind::Pi => std::f64::consts::PI,
            ValueKind::Name(name) => {
                let place = self.interpretation().symbols.at(name.start)?;
                self.facts().value(place.definition?)?
            }
        };
        Some(value.signed(number))
    }

    /// The numbers of a statement's values, if all of them are known.
    pub(crate) fn numbers<const N: usize>(&self, values: &[Value]) -> Option<[f64; N]> {
        let mut numbers = [0.0; N];
        if values.len() != N {
            return None;
        }
        for (number, value) in numbers.iter_mut().zip(values) {
            *number = self.number(value)?;
        }
        Some(numbers)
    }

    /// The material that a definition makes.
    pub(crate) fn material(&self, id: DefinitionId) -> Option<Material> {
        let line = self.definition_of(id)?.line;
        let (statement, _) = self.statement_at(line.start)?;
        let Statement::Material { values, .. } = statement else {
            return None;
        };
        let numbers = self.numbers(values.as_slice())?;
        Some(Material::from_values(numbers, line))
    }
}
