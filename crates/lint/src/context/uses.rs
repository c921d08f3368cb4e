//! How often each definition is read, and where it is edited.

use scenec_interpret::{DefinitionId, Role, SymbolId, SymbolTable};

/// How often every definition of a file is read.
pub(super) struct Uses {
    reads: Vec<u32>,
    /// The last definition of each symbol.
    last: Vec<Option<DefinitionId>>,
    /// Whether any definition of a symbol is read.
    ever: Vec<bool>,
}

impl Uses {
    pub(super) fn of(symbols: &SymbolTable) -> Self {
        let mut reads = vec![0_u32; symbols.definitions().len()];
        let mut ever = vec![false; symbols.symbols().len()];
        let mut last = vec![None; symbols.symbols().len()];
        for (id, definition) in symbols.numbered_definitions() {
            if let Some(last) = last.get_mut(definition.symbol.0 as usize) {
                *last = Some(id);
            }
        }
        for place in symbols.occurrences().filter(|place| place.role == Role::Use) {
            let Some(index) = place.definition.map(DefinitionId::index) else {
                continue;
            };
            if let Some(ever) = ever.get_mut(place.symbol.0 as usize) {
                *ever = true;
            }
            if let Some(count) = reads.get_mut(index) {
                *count += 1;
            }
        }
        Self { reads, last, ever }
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
}

/// Where every definition of a file is edited; only findings ask for that.
pub(super) struct Edits {
    /// The edits of definition `i` are `list[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    /// Numbers of occurrences.
    list: Vec<u32>,
}

impl Edits {
    /// Two passes over the occurrences: one counts the edits, one sorts them by what they edit.
    pub(super) fn of(symbols: &SymbolTable) -> Self {
        let edits = || {
            let numbered = (0..).zip(symbols.occurrences());
            let edits = numbered.filter(|(_, place)| place.role == Role::Edit);
            edits.filter_map(|(number, place)| Some((number, place.definition?.index())))
        };
        let mut starts = vec![0_u32; symbols.definitions().len() + 1];
        for (_, index) in edits() {
            if let Some(count) = starts.get_mut(index + 1) {
                *count += 1;
            }
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut next = starts.clone();
        let mut list = vec![0; total as usize];
        for (number, index) in edits() {
            if let Some(next) = next.get_mut(index)
                && let Some(edit) = list.get_mut(*next as usize)
            {
                *edit = number;
                *next += 1;
            }
        }
        Self { starts, list }
    }

    pub(super) fn edits(&self, definition: DefinitionId) -> &[u32] {
        let bound = |index: usize| self.starts.get(index).map_or(0, |start| *start as usize);
        let index = definition.index();
        self.list.get(bound(index)..bound(index + 1)).unwrap_or_default()
    }
}
