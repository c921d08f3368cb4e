//! Applying the repairs that findings offer.
//!
//! It must not know files: a text comes in, a text goes out.

use scenec_text::{Severity, SourceFile, apply, fitting};

use crate::finding::{Finding, find};
use crate::levels::Levels;

/// How often a file is gone over: a repair may bring up the next one.
const ROUNDS: usize = 32;

/// A file after its repairs.
#[derive(Debug)]
pub(crate) struct Mended {
    pub(crate) source: SourceFile,
    /// What is left to say about it.
    pub(crate) findings: Vec<Finding>,
    /// How many repairs were applied.
    pub(crate) count: usize,
}

/// Whether a finding would be repaired.
pub(crate) fn applies(finding: &Finding, unsafe_too: bool) -> bool {
    finding
        .diagnostic
        .fix
        .as_ref()
        .is_some_and(|fix| fix.safe || unsafe_too)
}

/// Applies repairs until none is left, or until they go round in circles. Of two that touch the same place one waits
/// for the next round; repairs that bring up an error are taken back.
///
/// The text must be what is in the file: every byte UTF-8.
pub(crate) fn mend(source: SourceFile, findings: Vec<Finding>, levels: &Levels, unsafe_too: bool) -> Mended {
    let mut mended = Mended {
        source,
        findings,
        count: 0,
    };
    for _ in 0..ROUNDS {
        let fixes = mended.findings.iter().filter(|finding| applies(finding, unsafe_too));
        let fixes = fixes.filter_map(|finding| finding.diagnostic.fix.as_ref());
        let (edits, count) = fitting(mended.source.text(), fixes);
        if count == 0 {
            break;
        }
        let text = apply(mended.source.text(), edits);
        // Repairs that make a file too large for this program are no repairs.
        let Ok(source) = SourceFile::new(mended.source.name(), text) else {
            break;
        };
        let findings = find(&source, &[], levels);
        if errors(&findings) > errors(&mended.findings) {
            break;
        }
        mended = Mended {
            source,
            findings,
            count: mended.count + count,
        };
    }
    mended
}

/// Findings that leave a file without a meaning, whatever the levels say of others.
fn errors(findings: &[Finding]) -> usize {
    let fatal = |finding: &&Finding| finding.diagnostic.severity() == Severity::Error;
    findings.iter().filter(fatal).count()
}
