//! What the rules read: the file in all its stages, and facts about it that are worked out once, when first asked for.

mod reach;
mod spoilt;
mod uses;

use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;

use scenec_interpret::{Definition, DefinitionId, Interpretation, Occurrence, Role, SymbolId};
use scenec_scene::{Base, Light, Material, Scene, SettingInfo, Settings, Steps};
use scenec_syntax::{Content, Line, Lines, Space, Statement, line};
use scenec_text::{SourceFile, Span};

use crate::geometry::Geometry;

pub(crate) use reach::Reach;
use spoilt::Spoilt;
use uses::{Edits, Uses};

/// A line of so many bytes is remembered once it was read.
const LONG: u32 = 1024;

/// One file in all its stages.
pub(crate) struct Context<'a> {
    pub(crate) source: &'a SourceFile,
    pub(crate) interpretation: &'a Interpretation,
    /// Long lines that were read again, by their numbers: many findings about one must not read it each time.
    long_lines: RefCell<HashMap<u32, Line>>,
    reach: OnceCell<Option<Reach>>,
    geometry: OnceCell<Geometry>,
    uses: OnceCell<Uses>,
    edits: OnceCell<Edits>,
    spoilt: OnceCell<Spoilt<'a>>,
    variables: OnceCell<Vec<&'a Definition>>,
}

impl<'a> Context<'a> {
    pub(crate) fn new(source: &'a SourceFile, interpretation: &'a Interpretation) -> Self {
        Self {
            source,
            interpretation,
            long_lines: RefCell::default(),
            reach: OnceCell::new(),
            geometry: OnceCell::new(),
            uses: OnceCell::new(),
            edits: OnceCell::new(),
            spoilt: OnceCell::new(),
            variables: OnceCell::new(),
        }
    }

    pub(crate) fn text(&self) -> &'a str {
        self.source.text()
    }

    /// The scene, if the file has no error.
    pub(crate) const fn scene(&self) -> Option<&'a Scene> {
        self.interpretation.scene.as_ref()
    }

    /// The settings, if all of them are given and in range, whatever else is wrong with the file.
    pub(crate) fn settings(&self) -> Option<&'a Settings> {
        let fragments = self.interpretation.fragments.settings.as_ref();
        self.scene().map_or(fragments, |scene| Some(&scene.settings))
    }

    /// Every material that a statement defines, those of a file with errors too.
    pub(crate) fn materials(&self) -> impl Iterator<Item = (&'a Material, Span)> {
        let fragments = &self.interpretation.fragments.materials;
        let all = self.scene().map_or(fragments, |scene| &scene.materials);
        all.iter().filter_map(|material| Some((material, material.span?)))
    }

    /// The materials that statements define and that show in the submitted object.
    pub(crate) fn shown_materials(&self) -> impl Iterator<Item = (&'a Material, Span)> {
        let scene = self.scene().zip(self.reach());
        let all = scene.into_iter().flat_map(|(scene, reach)| {
            let numbered = scene.materials.iter().enumerate();
            numbered.filter(|(index, _)| reach.material(*index))
        });
        all.filter_map(|(_, material)| Some((material, material.span?)))
    }

    /// The lights as they stand at the end of the file, those of a file with errors too.
    pub(crate) fn lights(&self) -> &'a [Light] {
        let fragments = &self.interpretation.fragments.lights;
        self.scene().map_or(fragments, |scene| &scene.lights)
    }

    /// The transforms as they were written, those of a file with errors too.
    pub(crate) fn steps(&self) -> &'a Steps {
        let fragments = &self.interpretation.fragments.steps;
        self.scene().map_or(fragments, |scene| &scene.steps)
    }

    /// What the submitted object is made of; `None` where there is no scene.
    pub(crate) fn reach(&self) -> Option<&Reach> {
        self.reach.get_or_init(|| self.scene().map(Reach::of)).as_ref()
    }

    /// The base object that the transform with this number moved, if that is part of the submitted object. In a file with
    /// errors: if none of them can have to do with the object.
    pub(crate) fn moved(&self, step: usize) -> Option<Base> {
        match self.reach() {
            Some(reach) => reach.step(step),
            None => self.spoilt().moved(step),
        }
    }

    /// Whether an error may have to do with nothing using a name of this space: a line that was to use it, or that was to
    /// submit what uses it.
    pub(crate) fn may_be_used(&self, space: Space, name: &str) -> bool {
        self.scene().is_none() && self.spoilt().may_use(space, name)
    }

    fn spoilt(&self) -> &Spoilt<'a> {
        self.spoilt.get_or_init(|| Spoilt::of(self))
    }

    /// The scene with what is certain about its geometry.
    pub(crate) fn geometry(&self) -> Option<(&'a Scene, &Geometry)> {
        let scene = self.scene()?;
        Some((scene, self.geometry.get_or_init(|| Geometry::of(scene))))
    }

    /// Every line that is not blank, read again.
    pub(crate) fn lines(&self) -> impl Iterator<Item = Line> + 'a {
        Lines::new(self.source)
    }

    /// Every statement with its place, read again.
    pub(crate) fn statements(&self) -> impl Iterator<Item = (Span, Statement)> + 'a {
        self.lines().filter_map(|line| match line.content {
            Content::Statement(statement) => Some((line.span, statement)),
            Content::Comment | Content::Broken(_) => None,
        })
    }

    /// The line that holds `place`, which may be its first byte or any other of its words.
    pub(crate) fn line_at(&self, place: Span) -> Option<Line> {
        let number = self.source.line_of(place.start);
        let span = self.source.line_span(number)?;
        if span.len() < LONG {
            return line(self.source, number);
        }
        let mut long_lines = self.long_lines.borrow_mut();
        if let Some(known) = long_lines.get(&number) {
            return Some(known.clone());
        }
        let read = line(self.source, number)?;
        long_lines.insert(number, read.clone());
        Some(read)
    }

    /// The statement of the line that holds `place`.
    pub(crate) fn statement_at(&self, place: Span) -> Option<Statement> {
        match self.line_at(place)?.content {
            Content::Statement(statement) => Some(statement),
            Content::Comment | Content::Broken(_) => None,
        }
    }

    /// The place of a statement's value, by its number; the whole statement if it has no such value.
    pub(crate) fn value_at(&self, statement: Span, number: usize) -> Span {
        let found = self.statement_at(statement);
        let value = found.as_ref().and_then(|found| found.values().get(number));
        value.map_or(statement, |value| value.span)
    }

    /// The names on the line of a statement, in order; the first is the one that it begins with.
    pub(crate) fn places_on(
        &self,
        statement: Span,
    ) -> impl ExactSizeIterator<Item = Occurrence> + DoubleEndedIterator + Clone + 'a {
        self.interpretation.symbols.occurrences_in(statement)
    }

    /// Every definition with its number.
    pub(crate) fn definitions(&self) -> &'a [Definition] {
        self.interpretation.symbols.definitions()
    }

    /// The definition with this number.
    pub(crate) fn definition(&self, id: DefinitionId) -> Option<&'a Definition> {
        self.definitions().get(id.index())
    }

    /// The definition that a statement makes.
    pub(crate) fn definition_at(&self, statement: Span) -> Option<DefinitionId> {
        let mut places = self.places_on(statement);
        places.find(|place| place.role == Role::Define)?.definition
    }

    /// The name that a definition binds, without a sigil, and its name space.
    pub(crate) fn named(&self, definition: &Definition) -> (&'a str, Option<Space>) {
        let symbol = self.interpretation.symbols.symbols().get(definition.symbol.0 as usize);
        symbol.map_or(("", None), |symbol| (symbol.name.of(self.text()), Some(symbol.space)))
    }

    /// How many times a definition is read, by statements that are ignored too.
    pub(crate) fn uses(&self, definition: DefinitionId) -> u32 {
        self.all_uses().read(definition)
    }

    /// Whether any definition of a name is read.
    pub(crate) fn ever_used(&self, symbol: SymbolId) -> bool {
        self.all_uses().ever(symbol)
    }

    /// The last definition of every name of a space, in the order in which the names first stand in the file.
    pub(crate) fn last_definitions(&self, space: Space) -> impl Iterator<Item = (DefinitionId, &'a Definition)> {
        let all = self.all_uses().last();
        all.filter_map(|id| Some((id, self.definition(id)?)))
            .filter(move |(_, definition)| self.named(definition).1 == Some(space))
    }

    /// The places that edit what a definition made, in the order of the file.
    pub(crate) fn edits(&self, definition: DefinitionId) -> impl Iterator<Item = Occurrence> {
        let symbols = &self.interpretation.symbols;
        let edits = self.edits.get_or_init(|| Edits::of(symbols)).edits(definition);
        edits.iter().filter_map(|number| symbols.occurrence(*number as usize))
    }

    /// The statement that makes something, and every one that edits it.
    pub(crate) fn definition_and_edits(&self, definition: DefinitionId) -> Vec<Span> {
        let edits = self
            .edits(definition)
            .filter_map(|edit| Some(self.line_at(edit.span)?.span));
        let made = self.definition(definition).map(|definition| definition.line);
        made.into_iter().chain(edits).collect()
    }

    fn all_uses(&self) -> &Uses {
        self.uses.get_or_init(|| Uses::of(&self.interpretation.symbols))
    }

    /// Every definition of a variable; there are few of them in large files.
    fn variables(&self) -> &[&'a Definition] {
        let variable = |definition: &&'a Definition| self.named(definition).1 == Some(Space::Variable);
        self.variables
            .get_or_init(|| self.definitions().iter().filter(variable).collect())
    }

    /// The statement that sets a setting for good, with the place of its value.
    pub(crate) fn setting(&self, row: &SettingInfo) -> Option<(Span, Span)> {
        let named = |definition: &&'a Definition| {
            let name = self.named(definition).0;
            name == row.name || Some(name) == row.alias
        };
        let line = self.variables().iter().rev().copied().find(named)?.line;
        Some((line, self.value_at(line, 0)))
    }

    /// The variables that the values of a statement name, with what each is bound to.
    pub(crate) fn variables_on(&self, statement: Span) -> impl Iterator<Item = (Span, &'a Definition)> {
        let read = self.places_on(statement).filter(|place| place.role == Role::Use);
        read.filter_map(|place| Some((place.span, self.definition(place.definition?)?)))
            .filter(|(_, definition)| self.named(definition).1 == Some(Space::Variable))
    }
}
