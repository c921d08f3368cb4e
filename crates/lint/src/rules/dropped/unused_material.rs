//! Materials that no object takes.

use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A material that no statement gives to an object.
    ///
    /// ## Example
    ///
    /// ```scene
    /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
    /// !ball := sphere
    /// !ball ?= red
    /// !ball <=
    /// ```
    UnusedMaterial, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (_, definition) in context.last_definitions(Space::Material) {
        let (name, _) = context.named(definition);
        // One that was redefined after an object took it is known to the interpreter, and of one whose use an error may
        // have spoilt nothing is known.
        if context.ever_used(definition.symbol) || context.may_be_used(Space::Material, name) {
            continue;
        }
        let name = quote(&format!("?{name}"));
        let mut finding = Diagnostic::new(
            Code::UnusedMaterial,
            format!("no object takes the material {name}"),
            definition.line,
            "never used",
        )
        .help("remove it, or give it to an object");
        finding.fix = context.removal("remove the material", &[definition.line]);
        findings.push(finding);
    }
}
