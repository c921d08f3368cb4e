//! Objects that never reach the submitted one.

use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// An object that no combination takes and that is not submitted does not show in the picture.
    ///
    /// Only what the submitted object is made of is rendered. An object that was forgotten in the last union is the
    /// usual cause. Where a whole group of objects is left out, the one that holds the others is reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !ground := hp
    /// !ground += 0 -1 0
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !ground := hp
    /// !ground += 0 -1 0
    /// !all := ball | ground
    /// !all <=
    /// ```
    ///
    /// Or remove the object with all its edits, which changes nothing in the picture.
    UnusedObject, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (id, definition) in context.last_definitions(Space::Object) {
        let (name, _) = context.named(definition);
        // An error may have spoilt the statement that takes it.
        if context.uses(id) > 0 || context.may_be_used(Space::Object, name) {
            continue;
        }
        let name = quote(&format!("!{name}"));
        let mut finding = Diagnostic::new(
            Code::UnusedObject,
            format!("{name} is not part of the picture"),
            definition.line,
            "neither combined nor submitted",
        )
        .help("combine it with what is submitted, or remove it");
        finding.fix = context.removal(format!("remove {name}"), &context.definition_and_edits(id));
        findings.push(finding);
    }
}
