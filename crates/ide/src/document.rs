//! One document with everything that is known about it.

use std::sync::OnceLock;

use scenec_interpret::{Interpretation, Occurrence};
use scenec_lint::Reading;
use scenec_scene::Scene;
use scenec_syntax::Line;
use scenec_text::{Diagnostic, SourceFile};

use crate::carry::carry;
use crate::facts::Facts;

/// Texts of fewer bytes are known all at once: the rules about solids are through before anybody would notice.
const LARGE: usize = 1 << 16;

/// A text and what every stage made of it. It never changes: an edited text is another document.
#[derive(Clone, Debug)]
pub struct Document {
    source: SourceFile,
    reading: Reading,
    /// What was found about the solids of the text before, where that is in this one.
    carried: Vec<Diagnostic>,
    /// What is found about the solids of this one, worked out when first asked for.
    solids: OnceLock<Vec<Diagnostic>>,
    diagnostics: OnceLock<Vec<Diagnostic>>,
    /// Those of the symbol table, spread out when first asked for: features look into the middle of them.
    occurrences: OnceLock<Vec<Occurrence>>,
    facts: OnceLock<Facts>,
}

impl Document {
    /// Takes a text through all stages but the rules about solids.
    #[must_use]
    pub fn new(source: SourceFile) -> Self {
        Self::read(Reading::of(&source), source, Vec::new())
    }

    fn read(reading: Reading, source: SourceFile, carried: Vec<Diagnostic>) -> Self {
        Self {
            source,
            reading,
            carried,
            solids: OnceLock::new(),
            diagnostics: OnceLock::new(),
            occurrences: OnceLock::new(),
            facts: OnceLock::new(),
        }
    }

    /// The same for a text that was edited; what is known about the solids `before` is carried over, to stand until it is
    /// known of this one.
    #[must_use]
    pub fn after(before: &Self, source: SourceFile) -> Self {
        let known = before.solids.get().unwrap_or(&before.carried);
        let carried = carry(known, before.text(), source.text());
        Self::read(before.reading.after(&before.source, &source), source, carried)
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
        &self.reading.lines
    }

    /// What the lines mean.
    #[must_use]
    pub const fn interpretation(&self) -> &Interpretation {
        &self.reading.interpretation
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
        self.reading.interpretation.scene.as_ref()
    }

    /// Everything that was found, in the order of the text. The rules about solids are applied when this is first asked for.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.diagnostics.get_or_init(|| {
            let solids = self.solids.get_or_init(|| self.reading.solids(&self.source));
            self.reading.all(&self.source, solids)
        })
    }

    /// Everything that was found, but of the solids what was found in the text before: for a large text that is known much
    /// sooner. `None` where nothing is to be gained.
    #[must_use]
    pub fn diagnostics_at_once(&self) -> Option<Vec<Diagnostic>> {
        let worth = self.text().len() >= LARGE && self.solids.get().is_none();
        worth.then(|| self.reading.all(&self.source, &self.carried))
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
