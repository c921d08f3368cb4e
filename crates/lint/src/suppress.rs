//! Comments that silence findings.

use scenec_syntax::Line;
use scenec_text::{Diagnostic, SourceFile};

/// Leaves out the findings that comments of the file silence.
#[must_use]
pub fn suppress(_source: &SourceFile, _lines: &[Line], findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    findings
}
