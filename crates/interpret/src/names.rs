//! A name space: what each of its names is bound to at the current line.

mod ids;

use hashbrown::HashMap;
use scenec_syntax::Space;
use scenec_text::Span;

use crate::{DefinitionId, Role, SymbolId, SymbolTable};
use ids::Ids;

/// Number of a name in its name space.
pub(crate) type NameId = usize;

/// What a name is bound to.
pub(crate) enum Binding<T> {
    /// Nothing so far.
    Absent,
    /// Something that is not known, because of an error already reported: what uses it is passed over in silence.
    Poisoned,
    /// This.
    Bound(T),
}

/// Why a reference leads nowhere.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Gap {
    /// Nothing has that name; the statement is ignored with a warning.
    Unknown,
    /// An error already reported is in the way; the statement is passed over.
    Poisoned,
}

/// A reference to a name that was not bound, reported at the end of the file, when it is known whether it ever is.
pub(crate) struct Unknown {
    pub(crate) space: Space,
    pub(crate) id: NameId,
    pub(crate) span: Span,
    /// The statement before it that would have bound the name, but was ignored.
    pub(crate) ignored: Option<Span>,
}

/// A name and what became of it.
pub(crate) struct Entry<T> {
    /// Where it first stands.
    pub(crate) name: Span,
    pub(crate) symbol: SymbolId,
    pub(crate) binding: Binding<T>,
    /// The statement that made the binding.
    definition: Option<DefinitionId>,
    /// The first statement that bound it.
    first: Option<DefinitionId>,
}

impl<T> Entry<T> {
    const fn new(name: Span, symbol: SymbolId) -> Self {
        Self {
            name,
            symbol,
            binding: Binding::Absent,
            definition: None,
            first: None,
        }
    }

    /// The first statement that bound it.
    pub(crate) fn first_bound(&self, symbols: &SymbolTable) -> Option<Span> {
        symbols.line(self.first?)
    }

    /// The last statement that bound it.
    pub(crate) fn last_bound(&self, symbols: &SymbolTable) -> Option<Span> {
        symbols.line(self.definition?)
    }

    pub(crate) const fn bound(&self) -> Option<&T> {
        match &self.binding {
            Binding::Bound(value) => Some(value),
            Binding::Absent | Binding::Poisoned => None,
        }
    }

    pub(crate) const fn bound_mut(&mut self) -> Option<&mut T> {
        match &mut self.binding {
            Binding::Bound(value) => Some(value),
            Binding::Absent | Binding::Poisoned => None,
        }
    }

    /// Binds the name by the statement at `line`; gives what it was bound to before.
    pub(crate) fn bind(&mut self, line: Span, value: T, symbols: &mut SymbolTable) -> Option<T> {
        self.definition = symbols.define(self.symbol, line);
        self.first = self.first.or(self.definition);
        self.replace(Binding::Bound(value))
    }

    pub(crate) fn replace(&mut self, binding: Binding<T>) -> Option<T> {
        match std::mem::replace(&mut self.binding, binding) {
            Binding::Bound(value) => Some(value),
            Binding::Absent | Binding::Poisoned => None,
        }
    }
}

/// The names of one space, in the order in which they first stand in the file.
pub(crate) struct Names<'a, T> {
    text: &'a str,
    space: Space,
    ids: Ids,
    pub(crate) entries: Vec<Entry<T>>,
    /// The last statements that would have bound a name, but were ignored.
    ignored: HashMap<NameId, Span>,
}

impl<'a, T> Names<'a, T> {
    pub(crate) fn new(text: &'a str, space: Space) -> Self {
        Self::with_room(text, space, 0)
    }

    /// With room for about so many names.
    pub(crate) fn with_room(text: &'a str, space: Space, room: usize) -> Self {
        Self {
            text,
            space,
            ids: Ids::with_room(room),
            entries: Vec::with_capacity(room),
            ignored: HashMap::new(),
        }
    }

    /// The number of the name at `span`, which is new if it never stood before; notes the place.
    pub(crate) fn mention(&mut self, span: Span, role: Role, symbols: &mut SymbolTable) -> NameId {
        let (text, name) = (self.text, span.of(self.text));
        let entries = &mut self.entries;
        let new = entries.len();
        let id = self.ids.find_or_add(name, new, |id| is(text, entries, id, name));
        if id == new {
            entries.push(Entry::new(span, symbols.add(self.space, span)));
        }
        let entry = &self.entries[id];
        let known = matches!(entry.binding, Binding::Bound(_)) && role != Role::Define;
        symbols.record(entry.symbol, span, role, entry.definition.filter(|_| known));
        id
    }

    /// The number of the name at `span`, which a statement reads or edits; notes in `unknown` if nothing binds it.
    pub(crate) fn look_up(
        &mut self,
        span: Span,
        role: Role,
        symbols: &mut SymbolTable,
        unknown: &mut Vec<Unknown>,
    ) -> Result<NameId, Gap> {
        let id = self.mention(span, role, symbols);
        let entry = &self.entries[id];
        match entry.binding {
            Binding::Bound(_) => Ok(id),
            Binding::Poisoned => Err(Gap::Poisoned),
            Binding::Absent => {
                unknown.push(Unknown {
                    space: self.space,
                    id,
                    span,
                    ignored: self.ignored.get(&id).copied(),
                });
                Err(Gap::Unknown)
            }
        }
    }

    /// The number of a name, if it stood anywhere before.
    pub(crate) fn number(&self, name: &str) -> Option<NameId> {
        self.ids.find(name, |id| is(self.text, &self.entries, id, name))
    }

    /// The entry of a name, if it stood anywhere before.
    pub(crate) fn find(&self, name: &str) -> Option<&Entry<T>> {
        self.entries.get(self.number(name)?)
    }

    pub(crate) fn find_mut(&mut self, name: &str) -> Option<&mut Entry<T>> {
        let id = self.number(name)?;
        self.entries.get_mut(id)
    }

    /// Notes that the statement at `line` would have bound a name, but is ignored.
    pub(crate) fn ignore(&mut self, id: NameId, line: Span) {
        self.ignored.insert(id, line);
    }

    /// The last statement that would have bound the name, but was ignored.
    pub(crate) fn ignored(&self, name: &str) -> Option<Span> {
        self.ignored.get(&self.number(name)?).copied()
    }
}

/// Whether the entry with this number is that of the name.
fn is<T>(text: &str, entries: &[Entry<T>], id: NameId, name: &str) -> bool {
    entries.get(id).is_some_and(|entry| entry.name.of(text) == name)
}
