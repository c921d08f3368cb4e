//! A file with what was found in it, each finding as grave as its levels have it.
//!
//! This is the one door to the stages behind `check`. It must not know how findings are shown.

use scenec_text::{Diagnostic, Severity, SourceFile};

use crate::levels::Levels;

/// A finding that is to be shown.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Finding {
    /// How grave it counts, which the command line or a configuration may have changed.
    pub(crate) severity: Severity,
    pub(crate) diagnostic: Diagnostic,
}

/// A file and what was found in it, in the order of the file.
#[derive(Clone, Debug)]
pub(crate) struct Checked {
    pub(crate) source: SourceFile,
    pub(crate) findings: Vec<Finding>,
}

/// Everything there is to say about a file. `reading` is what reading it has found already.
pub(crate) fn find(source: &SourceFile, reading: &[Diagnostic], levels: &Levels) -> Vec<Finding> {
    let mut diagnostics = scenec_lint::check(source).diagnostics;
    diagnostics.extend_from_slice(reading);
    diagnostics.sort_by_key(|finding| finding.span().start);
    let shown = |diagnostic: Diagnostic| {
        let severity = levels.of(diagnostic.code)?;
        Some(Finding { severity, diagnostic })
    };
    diagnostics.into_iter().filter_map(shown).collect()
}

/// What can be shown: a diagnostic as it is, or with another severity.
pub(crate) trait Shown {
    fn severity(&self) -> Severity;
    fn diagnostic(&self) -> &Diagnostic;
}

impl Shown for Finding {
    fn severity(&self) -> Severity {
        self.severity
    }

    fn diagnostic(&self) -> &Diagnostic {
        &self.diagnostic
    }
}

impl Shown for Diagnostic {
    fn severity(&self) -> Severity {
        Self::severity(self)
    }

    fn diagnostic(&self) -> &Diagnostic {
        self
    }
}
