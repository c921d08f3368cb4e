//! Every safe repair of a file, until there is none left.

use scenec_text::{Edit, Fix, Severity, SourceFile, fitting};

use crate::Document;
use crate::pieces::Pieces;

/// How often a text is gone over: a repair may bring up the next one.
const ROUNDS: usize = 32;

/// The edits that make every safe repair, and those that come up through them. Repairs that bring up an error are left
/// out.
#[must_use]
pub fn fix_all(document: &Document) -> Vec<Edit> {
    let mut pieces = Pieces::new(document.text());
    let mut present: Option<Document> = None;
    for _ in 0..ROUNDS {
        let before = present.as_ref().unwrap_or(document);
        let edits = safe_edits(before);
        if edits.is_empty() {
            break;
        }
        let mut next = pieces.clone();
        next.apply(&edits);
        let Ok(source) = SourceFile::new(document.source().name(), next.text()) else {
            break;
        };
        let after = Document::new(source);
        if errors(&after) > errors(before) {
            break;
        }
        pieces = next;
        present = Some(after);
    }
    pieces.edits()
}

/// As many safe repairs as have room beside each other.
fn safe_edits(document: &Document) -> Vec<Edit> {
    let fixes = document.diagnostics().iter().filter_map(|finding| finding.fix.as_ref());
    let (edits, _) = fitting(document.text(), fixes.filter(|fix: &&Fix| fix.safe));
    edits.into_iter().cloned().collect()
}

fn errors(document: &Document) -> usize {
    let findings = document.diagnostics().iter();
    findings.filter(|finding| finding.severity() == Severity::Error).count()
}
