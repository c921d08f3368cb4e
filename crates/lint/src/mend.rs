//! Repairs for what the interpreter reported: it knows what a statement means, not how to take one away.

use scenec_text::{Code, Diagnostic};

use crate::context::Context;

/// Attaches a repair to every finding that has a mechanical one.
pub(crate) fn mend(context: &Context<'_>, findings: &mut [Diagnostic]) {
    for finding in findings.iter_mut().filter(|finding| finding.fix.is_none()) {
        let title = match finding.code {
            Code::AfterSubmission => "remove the ignored statement",
            Code::OperandEdited => "remove the edit",
            Code::MaterialRedefined => "remove the definition",
            _ => continue,
        };
        finding.fix = context.removal(title, &[finding.span()]);
    }
}
