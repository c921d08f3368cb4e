//! The symbol table: every name of a file and every place where it stands.

use std::num::NonZeroU32;

use scenec_syntax::Space;
use scenec_text::Span;

/// Number of a symbol in its table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct SymbolId(pub u32);

/// A name in a name space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Symbol {
    /// Its name space.
    pub space: Space,
    /// The name as it first stands in the file, without a sigil.
    pub name: Span,
}

/// What a statement does with a name.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Role {
    /// Binds it, or would if the statement were not ignored.
    Define,
    /// Changes what it is bound to: a transform, or the material of an object.
    Edit,
    /// Reads it.
    Use,
}

/// Number of a definition in its table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct DefinitionId(NonZeroU32);

impl DefinitionId {
    /// The number as an index.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0.get() as usize - 1
    }
}

/// A statement that bound a name. One that was ignored, or was spoilt by an error, is none.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Definition {
    /// Which name.
    pub symbol: SymbolId,
    /// The statement.
    pub line: Span,
}

/// A place where a name stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Occurrence {
    /// The name without a sigil.
    pub span: Span,
    /// Which name.
    pub symbol: SymbolId,
    /// What the statement does with it.
    pub role: Role,
    /// The definition that it makes, edits or reads; `None` where there is none.
    pub definition: Option<DefinitionId>,
}

/// Every name of a file. Lines that fit no statement are left out.
#[derive(Clone, Debug, Default)]
pub struct SymbolTable {
    symbols: Vec<Symbol>,
    places: Vec<Place>,
    definitions: Vec<Definition>,
}

/// An occurrence in twelve bytes, since a file has more of them than of anything else: it is as long as its symbol.
#[derive(Clone, Copy, Debug)]
struct Place {
    start: u32,
    symbol: SymbolId,
    /// The role in the lowest two bits, above them the number of the definition, or 0. A file of 2^32 bytes has fewer than
    /// 2^30 definitions: none is shorter than `a:=1` and a line feed.
    link: u32,
}

impl Place {
    const fn new(start: u32, symbol: SymbolId, role: Role, definition: Option<DefinitionId>) -> Self {
        let number = match definition {
            Some(DefinitionId(number)) => number.get(),
            None => 0,
        };
        let link = number << 2 | role as u32;
        Self { start, symbol, link }
    }

    const fn role(self) -> Role {
        match self.link & 3 {
            0 => Role::Define,
            1 => Role::Edit,
            _ => Role::Use,
        }
    }

    fn definition(self) -> Option<DefinitionId> {
        NonZeroU32::new(self.link >> 2).map(DefinitionId)
    }
}

impl SymbolTable {
    /// With room for about so many symbols and what belongs to them.
    pub(crate) fn with_room(room: usize) -> Self {
        Self {
            symbols: Vec::with_capacity(room),
            places: Vec::with_capacity(room * 4),
            definitions: Vec::with_capacity(room),
        }
    }

    /// The symbols in the order in which they first stand in the file; a [`SymbolId`] is an index into them.
    #[must_use]
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// The symbol with this number.
    #[must_use]
    pub fn symbol(&self, id: SymbolId) -> Option<Symbol> {
        self.symbols.get(id.0 as usize).copied()
    }

    /// Every occurrence of every symbol, in the order of the file.
    pub fn occurrences(&self) -> impl ExactSizeIterator<Item = Occurrence> + DoubleEndedIterator + Clone + '_ {
        self.places.iter().map(|place| self.occurrence_of(*place))
    }

    /// The occurrence with this number, counted from 0 in the order of the file.
    #[must_use]
    pub fn occurrence(&self, number: usize) -> Option<Occurrence> {
        self.places.get(number).map(|place| self.occurrence_of(*place))
    }

    /// The occurrences that begin in a span, in the order of the file.
    pub fn occurrences_in(
        &self,
        span: Span,
    ) -> impl ExactSizeIterator<Item = Occurrence> + DoubleEndedIterator + Clone + '_ {
        let start = self.places.partition_point(|place| place.start < span.start);
        let after = self.places.get(start..).unwrap_or_default();
        let count = after.partition_point(|place| place.start < span.end);
        let inside = after.get(..count).unwrap_or_default();
        inside.iter().map(|place| self.occurrence_of(*place))
    }

    /// Every definition, in the order of the file; a [`DefinitionId`] is an index into them.
    #[must_use]
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// Every definition with its number, in the order of the file.
    pub fn numbered_definitions(&self) -> impl Iterator<Item = (DefinitionId, Definition)> + '_ {
        let ids = (1..=u32::MAX).filter_map(NonZeroU32::new).map(DefinitionId);
        ids.zip(self.definitions.iter().copied())
    }

    /// The statement that made a definition.
    pub(crate) fn line(&self, definition: DefinitionId) -> Option<Span> {
        let made = self.definitions.get(definition.index());
        made.map(|definition| definition.line)
    }

    /// The name at an offset; one just behind a name counts, as a text cursor there does.
    #[must_use]
    pub fn at(&self, offset: u32) -> Option<Occurrence> {
        let after = self.places.partition_point(|place| place.start <= offset);
        let place = self.occurrence(after.checked_sub(1)?)?;
        (offset <= place.span.end).then_some(place)
    }

    /// Every place where a symbol stands, in the order of the file.
    pub fn places(&self, symbol: SymbolId) -> impl Iterator<Item = Occurrence> + '_ {
        let here = move |place: &&Place| place.symbol == symbol;
        self.places.iter().filter(here).map(|place| self.occurrence_of(*place))
    }

    fn occurrence_of(&self, place: Place) -> Occurrence {
        let symbol = self.symbol(place.symbol);
        let length = symbol.map_or(0, |symbol| symbol.name.len());
        Occurrence {
            span: Span::new(place.start, place.start.saturating_add(length)),
            symbol: place.symbol,
            role: place.role(),
            definition: place.definition(),
        }
    }

    pub(crate) fn add(&mut self, space: Space, name: Span) -> SymbolId {
        let id = SymbolId(u32::try_from(self.symbols.len()).unwrap_or(u32::MAX));
        self.symbols.push(Symbol { space, name });
        id
    }

    pub(crate) fn record(&mut self, symbol: SymbolId, span: Span, role: Role, definition: Option<DefinitionId>) {
        self.places.push(Place::new(span.start, symbol, role, definition));
    }

    /// Notes that the statement at `line` bound the name; its place has been recorded among the last ones.
    pub(crate) fn define(&mut self, symbol: SymbolId, line: Span) -> Option<DefinitionId> {
        self.definitions.push(Definition { symbol, line });
        let number = u32::try_from(self.definitions.len()).ok()?;
        let id = NonZeroU32::new(number).map(DefinitionId);
        let places = self.places.iter_mut().rev();
        let own = places.take_while(|place| place.start >= line.start);
        if let Some(place) = own.last() {
            *place = Place::new(place.start, place.symbol, place.role(), id);
        }
        id
    }
}
