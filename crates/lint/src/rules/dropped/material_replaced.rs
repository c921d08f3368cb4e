//! Materials of objects that are replaced at once.

use std::collections::HashMap;

use scenec_interpret::{DefinitionId, Role};
use scenec_syntax::{Space, Statement, quote};
use scenec_text::{Code, Diagnostic, Span};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// An object takes a material, and then another one, with nothing between the two that uses the object.
    ///
    /// An object has one material. The second statement replaces the first, which therefore does nothing.
    ///
    /// ## Example
    ///
    /// ```scene
    /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
    /// ?blue := 0.2 0.7 0 0 0 1 1 0.1 0.1 0.9
    /// !ball := sphere
    /// !ball ?= red
    /// !ball ?= blue
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// ?red := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
    /// ?blue := 0.2 0.7 0 0 0 1 1 0.1 0.1 0.9
    /// !ball := sphere
    /// !ball ?= red
    /// !other := sphere
    /// !other ?= blue
    /// !other += 0 2 0
    /// !both := ball | other
    /// !both <=
    /// ```
    MaterialReplaced, check
}

/// The material statements of an object since it was last used.
#[derive(Default)]
struct Since {
    last: Option<Span>,
    /// Each with the one that replaced it.
    replaced: Vec<(Span, Span)>,
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let mut open: HashMap<DefinitionId, Since> = HashMap::new();
    for sentence in context.sentences() {
        if let Statement::MaterialSet { .. } = sentence.statement {
            if let [object, material] = sentence.places
                && let (Some(object), Some(_)) = (object.definition, material.definition)
            {
                let since = open.entry(object).or_default();
                if let Some(before) = since.last.replace(sentence.span) {
                    since.replaced.push((before, sentence.span));
                }
            }
            continue;
        }
        if open.is_empty() || sentence.statement.form().info().space != Space::Object {
            continue;
        }
        // Only once the object is used is it certain that nothing else is the matter with these statements.
        for place in sentence.places.iter().filter(|place| place.role == Role::Use) {
            let since = place.definition.and_then(|id| open.remove(&id));
            for (first, second) in since.map(|since| since.replaced).unwrap_or_default() {
                findings.push(report(context, first, second));
            }
        }
    }
}

fn report(context: &Context<'_>, first: Span, second: Span) -> Diagnostic {
    let object = context.statement_at(first).map_or(first, Statement::name);
    let name = quote(&format!("!{}", object.of(context.text())));
    let mut finding = Diagnostic::new(
        Code::MaterialReplaced,
        format!("{name} takes another material before anything uses it"),
        first,
        "does nothing",
    )
    .label(second, "this material replaces it")
    .help("remove one of the two statements");
    finding.fix = context.removal("remove the first statement", &[first]);
    finding
}
