//! What the features ask again and again, worked out once for a document when first asked: what each variable is, what
//! edits each object, and which objects the submitted one is made of.
//!
//! It reads statements and the symbol table rather than the scene, so that it serves a file with errors as well.

mod group;
mod reach;

use scenec_interpret::{DefinitionId, Occurrence, Role, SymbolId};
use scenec_scene::SETTINGS;
use scenec_syntax::{Content, Space, Statement, ValueKind};
use scenec_text::Span;

use crate::Document;
use group::Groups;

pub(crate) use reach::Taken;

/// The facts of one document.
#[derive(Clone, Debug)]
pub(crate) struct Facts {
    /// What each definition of a variable binds it to.
    values: Vec<Option<f64>>,
    /// What each definition of a combination takes.
    operands: Vec<Option<[Option<DefinitionId>; 2]>>,
    /// How many base objects each definition of an object is made of, the same one counted each time.
    leaves: Vec<u64>,
    /// The definitions of each symbol.
    bindings: Groups,
    /// The occurrences that edit what each definition made.
    edits: Groups,
    /// The occurrences that read each definition.
    uses: Groups,
    /// The symbols that are settings, each with its number in the table of settings.
    settings: Vec<(usize, SymbolId)>,
    submission: Option<Submission>,
    taken: Vec<Option<Taken>>,
}

/// The statement that submits, and what.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Submission {
    pub(crate) line: Span,
    pub(crate) object: DefinitionId,
}

impl Facts {
    /// A pass over the lines, and one back over the definitions.
    pub(crate) fn of(document: &Document) -> Self {
        let symbols = &document.interpretation().symbols;
        let count = symbols.definitions().len();
        let places = || (0..).zip(document.occurrences());
        let with_role = |role: Role| {
            places().filter_map(move |(number, place)| {
                let id = place.definition.filter(|_| place.role == role)?;
                Some((id.index(), number))
            })
        };
        let bindings = (0..)
            .zip(symbols.definitions())
            .map(|(number, definition)| (definition.symbol.0 as usize, number));
        let mut facts = Self {
            values: vec![None; count],
            operands: vec![None; count],
            leaves: vec![0; count],
            bindings: Groups::new(symbols.symbols().len(), bindings),
            edits: Groups::new(count, with_role(Role::Edit)),
            uses: Groups::new(count, with_role(Role::Use)),
            settings: settings(document),
            submission: None,
            taken: Vec::new(),
        };
        facts.read(document);
        facts.taken = reach::of(document, &facts);
        facts
    }

    /// What the statements say, in the order of the file.
    fn read(&mut self, document: &Document) {
        let mut rest = document.occurrences();
        for line in document.lines() {
            let on_line = rest.iter().take_while(|place| place.span.start < line.span.end).count();
            let (places, after) = rest.split_at(on_line);
            rest = after;
            if let Content::Statement(statement) = &line.content {
                self.note(statement, line.span, places);
            }
        }
    }

    fn note(&mut self, statement: &Statement, line: Span, places: &[Occurrence]) {
        let bound = |number: usize| places.get(number).and_then(|place| place.definition);
        let Some(id) = bound(0) else {
            return;
        };
        match statement {
            Statement::Variable { value, .. } => {
                let number = match value.kind {
                    ValueKind::Number(number) => Some(number),
                    ValueKind::Pi => Some(std::f64::consts::PI),
                    ValueKind::Name(_) => bound(1).and_then(|id| self.value(id)),
                };
                set(&mut self.values, id, number.map(|number| value.signed(number)));
            }
            Statement::Object { .. } => set(&mut self.leaves, id, 1),
            Statement::Combination { .. } => {
                let leaves = |number| bound(number).map_or(0, |id| self.leaves(id));
                let sum = leaves(1).saturating_add(leaves(2));
                set(&mut self.leaves, id, sum);
                set(&mut self.operands, id, Some([bound(1), bound(2)]));
            }
            Statement::Submit { .. } if self.submission.is_none() => {
                self.submission = Some(Submission { line, object: id });
            }
            _ => {}
        }
    }

    /// The symbols of a setting, under each of its spellings, by its number in the table of settings.
    pub(crate) fn setting(&self, row: usize) -> impl Iterator<Item = SymbolId> {
        let all = self.settings.iter().filter(move |(number, _)| *number == row);
        all.map(|(_, symbol)| *symbol)
    }

    /// What a definition of a variable binds it to.
    pub(crate) fn value(&self, id: DefinitionId) -> Option<f64> {
        self.values.get(id.index()).copied().flatten()
    }

    /// How many base objects an object is made of; the largest number of all stands for more as well.
    pub(crate) fn leaves(&self, id: DefinitionId) -> u64 {
        self.leaves.get(id.index()).copied().unwrap_or_default()
    }

    /// The two objects that a combination takes; `None` for anything else.
    pub(crate) fn operands(&self, id: DefinitionId) -> Option<[Option<DefinitionId>; 2]> {
        self.operands.get(id.index()).copied().flatten()
    }

    /// The statement that submits an existing object.
    pub(crate) const fn submission(&self) -> Option<Submission> {
        self.submission
    }

    /// Whether a statement stands after the submission, where object statements are ignored.
    pub(crate) fn is_late(&self, statement: Span) -> bool {
        self.submission
            .is_some_and(|submission| statement.start > submission.line.start)
    }

    /// How the submitted object takes what a definition made; `None` where it does not.
    pub(crate) fn taken(&self, id: DefinitionId) -> Option<Taken> {
        self.taken.get(id.index()).copied().flatten()
    }

    /// The places that edit what a definition made, in the order of the file.
    pub(crate) fn edits<'d>(
        &'d self,
        document: &'d Document,
        id: DefinitionId,
    ) -> impl DoubleEndedIterator<Item = &'d Occurrence> {
        occurrences(document, self.edits.of(id.index()))
    }

    /// The places that read what a definition made, in the order of the file.
    pub(crate) fn uses<'d>(
        &'d self,
        document: &'d Document,
        id: DefinitionId,
    ) -> impl DoubleEndedIterator<Item = &'d Occurrence> {
        occurrences(document, self.uses.of(id.index()))
    }

    /// How many places read what a definition made.
    pub(crate) fn use_count(&self, id: DefinitionId) -> usize {
        self.uses.of(id.index()).len()
    }

    /// The last definition of a symbol before an offset.
    pub(crate) fn binding(&self, document: &Document, symbol: SymbolId, before: u32) -> Option<DefinitionId> {
        let symbols = &document.interpretation().symbols;
        let all = self.bindings.of(symbol.0 as usize);
        let starts = |number: &u32| {
            let found = symbols.definitions().get(*number as usize);
            found.is_some_and(|found| found.line.start < before)
        };
        let count = all.partition_point(starts);
        let last = all.get(count.checked_sub(1)?)?;
        document.defined_by(symbols.definitions().get(*last as usize)?.line)
    }
}

/// The symbols of a document that are settings, each with its number in the table of settings.
fn settings(document: &Document) -> Vec<(usize, SymbolId)> {
    let symbols = (0..).map(SymbolId).zip(document.interpretation().symbols.symbols());
    let variables = symbols.filter(|(_, symbol)| symbol.space == Space::Variable);
    let row = |name: &str| {
        SETTINGS
            .iter()
            .position(|row| row.name == name || row.alias == Some(name))
    };
    variables
        .filter_map(|(id, symbol)| Some((row(document.words(symbol.name))?, id)))
        .collect()
}

fn set<T>(list: &mut [T], id: DefinitionId, value: T) {
    if let Some(place) = list.get_mut(id.index()) {
        *place = value;
    }
}

fn occurrences<'d>(document: &'d Document, numbers: &'d [u32]) -> impl DoubleEndedIterator<Item = &'d Occurrence> {
    let all = document.occurrences();
    numbers.iter().filter_map(move |number| all.get(*number as usize))
}

#[cfg(test)]
mod tests;
