//! What is known at the current line: the four name spaces and the scene so far.

use hashbrown::HashMap;
use scenec_scene::{DEFAULT_MATERIAL, Light, Material, Solid, SolidId, SolidKind, Steps};
use scenec_syntax::{Space, Value, ValueKind};
use scenec_text::{Code, Diagnostic, Severity, Span};

use crate::bindings::{Lamp, Object, Paint, Variable};
use crate::names::{Gap, NameId, Names, Unknown};
use crate::{Role, SymbolTable};

/// For so many bytes of a text there is room for one object from the start.
const BYTES_PER_OBJECT: usize = 80;

/// What became of submissions so far.
#[derive(Default)]
pub(crate) struct Submission {
    /// The first one of an existing object, with its statement.
    pub(crate) done: Option<(SolidId, Span)>,
    /// One that was ignored.
    pub(crate) ignored: Option<Span>,
    /// Whether an error spoilt one.
    pub(crate) poisoned: bool,
}

/// Everything known at the current line.
pub(crate) struct State<'a> {
    pub(crate) text: &'a str,
    pub(crate) variables: Names<'a, Variable>,
    pub(crate) objects: Names<'a, Object>,
    pub(crate) paints: Names<'a, Paint>,
    pub(crate) lamps: Names<'a, Lamp>,
    /// The edits of objects since a combination took them.
    pub(crate) stale: HashMap<NameId, Vec<Span>>,
    pub(crate) materials: Vec<Material>,
    pub(crate) lights: Vec<Light>,
    pub(crate) solids: Vec<Solid>,
    pub(crate) steps: Steps,
    pub(crate) submission: Submission,
    pub(crate) unknown: Vec<Unknown>,
    pub(crate) symbols: SymbolTable,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Whether there was an error.
    pub(crate) failed: bool,
}

impl<'a> State<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        // Memory that is never touched costs nothing, and lists that grow are copied again and again.
        let room = text.len() / BYTES_PER_OBJECT;
        Self {
            text,
            variables: Names::new(text, Space::Variable),
            objects: Names::with_room(text, Space::Object, room),
            paints: Names::new(text, Space::Material),
            lamps: Names::new(text, Space::Light),
            stale: HashMap::new(),
            materials: vec![DEFAULT_MATERIAL],
            lights: Vec::new(),
            solids: Vec::with_capacity(room),
            steps: Steps::with_room(room),
            submission: Submission::default(),
            unknown: Vec::new(),
            symbols: SymbolTable::with_room(room),
            diagnostics: Vec::new(),
            failed: false,
        }
    }

    pub(crate) fn report(&mut self, finding: Diagnostic) {
        self.failed |= finding.severity() == Severity::Error;
        self.diagnostics.push(finding);
    }

    /// The object that a statement uses or edits, if there is one.
    pub(crate) fn object(&mut self, span: Span, role: Role) -> Result<NameId, Gap> {
        self.objects.look_up(span, role, &mut self.symbols, &mut self.unknown)
    }

    /// The material that a statement uses, if there is one.
    pub(crate) fn paint(&mut self, span: Span) -> Result<NameId, Gap> {
        self.paints
            .look_up(span, Role::Use, &mut self.symbols, &mut self.unknown)
    }

    /// The numbers of a statement's values; every name among them that is not bound is reported, once a statement.
    pub(crate) fn numbers<const N: usize>(&mut self, values: &[Value; N]) -> Result<[f64; N], Gap> {
        let mut numbers = [0.0; N];
        let mut gap = None;
        let reported = self.unknown.len();
        for (number, value) in numbers.iter_mut().zip(values) {
            match self.number(*value, reported) {
                Ok(found) => *number = found,
                Err(found) => gap = gap.max(Some(found)),
            }
        }
        gap.map_or(Ok(numbers), Err)
    }

    fn number(&mut self, value: Value, reported: usize) -> Result<f64, Gap> {
        let span = match value.kind {
            ValueKind::Number(number) => return Ok(value.signed(number)),
            ValueKind::Pi => return Ok(value.signed(std::f64::consts::PI)),
            ValueKind::Name(span) => span,
        };
        let before = self.unknown.len();
        let id = self
            .variables
            .look_up(span, Role::Use, &mut self.symbols, &mut self.unknown);
        let (earlier, new) = self.unknown.split_at(before);
        let again = |new: &Unknown| {
            earlier
                .iter()
                .skip(reported)
                .any(|other| (other.space, other.id) == (new.space, new.id))
        };
        if new.first().is_some_and(again) {
            self.unknown.pop();
        }
        let variable = self.variables.entries[id?].bound_mut().ok_or(Gap::Poisoned)?;
        variable.used = true;
        variable.last_read = Some(span);
        Ok(value.signed(variable.value))
    }

    /// Adds a solid.
    pub(crate) fn push_solid(&mut self, kind: SolidKind, span: Span) -> SolidId {
        let id = SolidId(u32::try_from(self.solids.len()).unwrap_or(u32::MAX));
        self.solids.push(Solid { kind, span });
        id
    }

    /// Warns that what `first` bound was never used before `second` bound the name again.
    pub(crate) fn overwritten(&mut self, space: Space, name: &str, first: Span, second: Span) {
        let name = scenec_syntax::quote(&format!("{}{name}", space.sigil()));
        let finding = Diagnostic::new(
            Code::OverwrittenUnused,
            format!("{name} is bound again before anything used it"),
            first,
            "nothing uses this",
        );
        self.report(
            finding
                .label(second, "it is bound again here")
                .help("remove the first statement, or choose another name"),
        );
    }
}
