//! What the rules found so far.

use scenec_text::Diagnostic;

use crate::context::Context;
use crate::rule::Rule;

/// Findings in the order in which they came.
#[derive(Default)]
pub(crate) struct Findings {
    list: Vec<Diagnostic>,
}

impl Findings {
    /// Adds what each of the rules finds.
    pub(crate) fn apply(&mut self, rules: &[Rule], context: &Context<'_>) {
        for rule in rules {
            (rule.check)(context, self);
        }
    }

    pub(crate) fn push(&mut self, finding: Diagnostic) {
        self.list.push(finding);
    }

    pub(crate) fn extend(&mut self, findings: impl IntoIterator<Item = Diagnostic>) {
        self.list.extend(findings);
    }

    /// All of them, ordered by place and then by code.
    pub(crate) fn sorted(mut self) -> Vec<Diagnostic> {
        sort(&mut self.list);
        self.list
    }
}

/// Orders findings by place and then by code.
pub(crate) fn sort(findings: &mut [Diagnostic]) {
    findings.sort_by_key(|finding| (finding.span().start, finding.code));
}
