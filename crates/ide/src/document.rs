//! One document with everything that is known about it.

use std::sync::OnceLock;

use scenec_interpret::{Interpretation, Occurrence};
use scenec_lint::{Checked, check_keeping_lines};
use scenec_scene::Scene;
use scenec_syntax::Line;
use scenec_text::{Diagnostic, SourceFile};

use crate::facts::Facts;

/// A text and what every stage made of it. It never changes: an edited text is another document.
#[derive(Clone, Debug)]
pub struct Document {
    source: SourceFile,
    lines: Vec<Line>,
    checked: Checked,
    /// Those of the symbol table, spread out when first asked for: features look into the middle of them.
    occurrences: OnceLock<Vec<Occurrence>>,
    facts: OnceLock<Facts>,
}

impl Document {
    /// Takes a text through all stages.
    #[must_use]
    pub fn new(source: SourceFile) -> Self {
        let (lines, checked) = check_keeping_lines(&source);
        Self {
            source,
            lines,
            checked,
            occurrences: OnceLock::new(),
            facts: OnceLock::new(),
        }
    }

    /// The text and its line index.
    #[must_use]
    pub const fn source(&self) -> &SourceFile {
        &self.source
    }

    /// The whole text.
    #[must_use]
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The lines that are not blank, in order.
    #[must_use]
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// What the lines mean.
    #[must_use]
    pub const fn interpretation(&self) -> &Interpretation {
        &self.checked.interpretation
    }

    /// Every place where a name stands, in the order of the text.
    #[must_use]
    pub fn occurrences(&self) -> &[Occurrence] {
        let all = || self.interpretation().symbols.occurrences().collect();
        self.occurrences.get_or_init(all)
    }

    /// The scene; `None` while the text has an error.
    #[must_use]
    pub const fn scene(&self) -> Option<&Scene> {
        self.checked.interpretation.scene.as_ref()
    }

    /// Everything that was found, in the order of the text.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.checked.diagnostics
    }

    /// What features ask again and again, worked out when first asked.
    pub(crate) fn facts(&self) -> &Facts {
        self.facts.get_or_init(|| Facts::of(self))
    }

    /// The line that an offset lies on, if it is not blank.
    #[must_use]
    pub fn line_at(&self, offset: u32) -> Option<&Line> {
        let number = self.source.line_of(offset);
        let start = self.source.line_span(number)?.start;
        let end = self.source.line_span(number)?.end;
        let index = self.lines().partition_point(|line| line.span.start < start);
        self.lines().get(index).filter(|line| line.span.start <= end)
    }
}
