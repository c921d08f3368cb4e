//! How often each definition is read, and where it is edited.

use scenec_interpret::{DefinitionId, Role, SymbolId, SymbolTable};

/// Counts for every definition of a file.
pub(super) struct Uses {
    reads: Vec<u32>,
    /// The last definition of each symbol.
    last: Vec<Option<DefinitionId>>,
    /// Whether any definition of a symbol is read.
    ever: Vec<bool>,
    /// The edits of definition `i` are `edits[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    /// Numbers of occurrences.
    edits: Vec<u32>,
}

impl Uses {
    /// Two passes over the occurrences: one counts, one sorts the edits by what they edit.
    pub(super) fn of(symbols: &SymbolTable) -> Self {
        let count = symbols.definitions().len();
        let mut reads = vec![0_u32; count];
        let mut starts = vec![0_u32; count + 1];
        let mut ever = vec![false; symbols.symbols().len()];
        let mut last = vec![None; symbols.symbols().len()];
        for (id, definition) in symbols.numbered_definitions() {
            if let Some(last) = last.get_mut(definition.symbol.0 as usize) {
                *last = Some(id);
            }
        }
        for place in symbols.occurrences() {
            let Some(index) = place.definition.map(DefinitionId::index) else {
                continue;
            };
            if let (Role::Use, Some(ever)) = (place.role, ever.get_mut(place.symbol.0 as usize)) {
                *ever = true;
            }
            let counter = match place.role {
                Role::Define => None,
                Role::Use => reads.get_mut(index),
                Role::Edit => starts.get_mut(index + 1),
            };
            if let Some(counter) = counter {
                *counter += 1;
            }
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut next = starts.clone();
        let mut edits = vec![0; total as usize];
        for (number, place) in (0..).zip(symbols.occurrences()) {
            if place.role == Role::Edit
                && let Some(next) = place.definition.and_then(|id| next.get_mut(id.index()))
                && let Some(edit) = edits.get_mut(*next as usize)
            {
                *edit = number;
                *next += 1;
            }
        }
        Self {
            reads,
            last,
            ever,
            starts,
            edits,
        }
    }

    pub(super) fn last(&self) -> impl Iterator<Item = DefinitionId> {
        self.last.iter().copied().flatten()
    }

    pub(super) fn ever(&self, symbol: SymbolId) -> bool {
        self.ever.get(symbol.0 as usize).copied().unwrap_or_default()
    }

    pub(super) fn read(&self, definition: DefinitionId) -> u32 {
        self.reads.get(definition.index()).copied().unwrap_or_default()
    }

    pub(super) fn edits(&self, definition: DefinitionId) -> &[u32] {
        let bound = |index: usize| self.starts.get(index).map_or(0, |start| *start as usize);
        let index = definition.index();
        self.edits.get(bound(index)..bound(index + 1)).unwrap_or_default()
    }
}
