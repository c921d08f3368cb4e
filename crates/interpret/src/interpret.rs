//! One pass over the lines, then the end of the file.

use std::borrow::Borrow;

use scenec_scene::{Light, Material, Scene, Settings, Steps};
use scenec_syntax::{Content, Line, read_ahead};
use scenec_text::{Diagnostic, Severity, SourceFile, Span};

use crate::state::State;
use crate::{SymbolTable, finish, statements};

/// What a file means.
#[derive(Clone, Debug)]
pub struct Interpretation {
    /// The scene; `None` if the file has any error, one of the parser or the file's reader included.
    pub scene: Option<Scene>,
    /// What there is of a scene where `scene` is `None`; empty otherwise.
    pub fragments: Fragments,
    /// Every name and where it stands.
    pub symbols: SymbolTable,
}

/// The parts of a scene that never came to be, as in a [`Scene`]: what its statements say is known all the same.
#[derive(Clone, Debug, Default)]
pub struct Fragments {
    /// The settings, if all of them are there and in range.
    pub settings: Option<Settings>,
    /// Every material ever defined; number 0 is the default one.
    pub materials: Vec<Material>,
    /// The lights as they stand at the end of the file.
    pub lights: Vec<Light>,
    /// The transforms as they were written.
    pub steps: Steps,
}

/// Interprets a file one line after the other.
pub struct Interpreter<'a> {
    source: &'a SourceFile,
    state: State<'a>,
    /// The last line so far, its comment included.
    end: Option<Span>,
}

impl<'a> Interpreter<'a> {
    /// Before the first line.
    #[must_use]
    pub fn new(source: &'a SourceFile) -> Self {
        Self {
            source,
            state: State::new(source.text()),
            end: None,
        }
    }

    /// Takes the next line, as [`scenec_syntax::Lines`] reads it.
    pub fn line(&mut self, line: &Line) {
        self.end = Some(line.comment.map_or(line.span, |comment| line.span.to(comment)));
        match &line.content {
            Content::Comment => {}
            Content::Statement(statement) => statements::run(&mut self.state, line.span, statement),
            Content::Broken(broken) => statements::broken(&mut self.state, line.span, broken),
        }
    }

    /// Takes the next lines.
    pub fn lines(&mut self, lines: &[Line]) {
        lines.iter().for_each(|line| self.line(line));
    }

    /// What all lines together mean. The findings are ordered by place; what a broken line or a bad byte caused has been
    /// reported and is passed over.
    #[must_use]
    pub fn finish(mut self) -> (Interpretation, Vec<Diagnostic>) {
        self.state.failed |= !self.source.holes().is_empty();
        finish::finish(self.state, self.end)
    }
}

/// Interprets all lines of `source`, in their order.
#[must_use]
pub fn interpret<L: Borrow<Line>>(
    source: &SourceFile,
    lines: impl IntoIterator<Item = L>,
) -> (Interpretation, Vec<Diagnostic>) {
    let mut interpreter = Interpreter::new(source);
    let mut lines = lines.into_iter();
    // A line is looked at where it lies: to move it takes time.
    while let Some(line) = &lines.next() {
        interpreter.line(line.borrow());
    }
    interpreter.finish()
}

/// Interprets a file while its lines are read ahead; the parser's findings come apart.
#[must_use]
pub fn interpret_ahead(source: &SourceFile) -> ((Interpretation, Vec<Diagnostic>), Vec<Diagnostic>) {
    let mut interpreter = Interpreter::new(source);
    let findings = read_ahead(source, |lines| interpreter.lines(&lines));
    (interpreter.finish(), findings)
}

/// Parses and interprets a file. The findings of both stages come in one list, ordered by place.
#[must_use]
pub fn analyse(source: &SourceFile) -> (Interpretation, Vec<Diagnostic>) {
    let ((interpretation, more), mut diagnostics) = interpret_ahead(source);
    diagnostics.extend(more);
    diagnostics.sort_by_key(|finding| finding.span().start);
    (interpretation, diagnostics)
}

/// The scene of a text that has no file, or the codes of the errors in it: none if it is too large to be read.
///
/// # Errors
/// There is no scene.
pub fn scene_of(text: &str) -> Result<Scene, Vec<String>> {
    let source = SourceFile::new("text", text).map_err(|_| Vec::new())?;
    let (interpretation, diagnostics) = analyse(&source);
    let errors = diagnostics.iter().filter(|one| one.severity() == Severity::Error);
    interpretation
        .scene
        .ok_or_else(|| errors.map(|one| one.code.id().to_owned()).collect())
}
