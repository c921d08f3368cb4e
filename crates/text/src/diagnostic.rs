//! A finding as plain data; how it is shown is somebody else's business.

use crate::{Code, Severity, Span};

/// One finding in one source file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Which rule found it.
    pub code: Code,
    /// One sentence that names the thing.
    pub message: String,
    /// Every place that matters, the one to jump to first; never empty.
    pub labels: Vec<Label>,
    /// What to do about it.
    pub help: Option<String>,
    /// A mechanical repair, where there is one.
    pub fix: Option<Fix>,
}

/// A place and what it has to do with the finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// A short phrase; may be empty only where the message says it all.
    pub message: String,
}

/// A repair: edits that are applied together.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// What the repair does, as a command: "remove the edit".
    pub title: String,
    /// The edits; they don't overlap.
    pub edits: Vec<Edit>,
    /// Whether the picture is certain to stay as it was.
    pub safe: bool,
}

/// The words at `span` become `text`.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// What is replaced; empty to insert.
    pub span: Span,
    /// What stands there afterwards.
    pub text: String,
}

impl Diagnostic {
    /// A finding at one place.
    #[must_use]
    pub fn new(code: Code, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
            labels: vec![Label {
                span,
                message: label.into(),
            }],
            help: None,
            fix: None,
        }
    }

    /// Names one more place.
    #[must_use]
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label {
            span,
            message: message.into(),
        });
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Offers a repair.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fix = Some(fix);
        self
    }

    /// How grave it is.
    #[must_use]
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }

    /// The place to jump to.
    #[must_use]
    pub fn span(&self) -> Span {
        self.labels.first().map_or_else(Span::default, |label| label.span)
    }
}
