//! Materials of objects that are replaced at once.

use std::collections::HashMap;
use std::num::NonZeroU32;

use scenec_interpret::{DefinitionId, Role};
use scenec_syntax::{Content, Space, quote};
use scenec_text::{Code, Diagnostic};

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

fn check(context: &Context<'_>, findings: &mut Findings) {
    let symbols = &context.interpretation.symbols;
    // For each definition of an object, where its last material is set since it was last used.
    let mut last: Vec<Option<NonZeroU32>> = vec![None; symbols.definitions().len()];
    let mut replaced: HashMap<DefinitionId, Vec<[usize; 2]>> = HashMap::new();
    let mut before: Option<DefinitionId> = None;
    for (number, place) in symbols.occurrences().enumerate() {
        let object = std::mem::replace(&mut before, place.definition);
        let (Role::Use, Some(definition)) = (place.role, place.definition) else {
            continue;
        };
        // Only the statement that sets a material reads one, right behind the object's name.
        if symbols.symbol(place.symbol).map(|symbol| symbol.space) == Some(Space::Material) {
            if let Some(object) = object
                && let Some(last) = last.get_mut(object.index())
                && let Some(first) = std::mem::replace(last, u32::try_from(number).ok().and_then(NonZeroU32::new))
            {
                let both = [first.get() as usize, number];
                replaced.entry(object).or_default().push(both);
            }
        } else if let Some(last) = last.get_mut(definition.index()) {
            // Only once the object is used is it certain that nothing else is the matter with these statements.
            *last = None;
            if !replaced.is_empty() {
                let list = replaced.remove(&definition).unwrap_or_default();
                findings.extend(list.into_iter().filter_map(|both| report(context, both)));
            }
        }
    }
}

/// `both` are the numbers of the materials' occurrences.
fn report(context: &Context<'_>, both: [usize; 2]) -> Option<Diagnostic> {
    let line = |number: usize| context.line_at(context.interpretation.symbols.occurrence(number)?.span);
    let (first, second) = (line(both[0])?, line(both[1])?.span);
    let Content::Statement(statement) = first.content else {
        return None;
    };
    let name = quote(&format!("!{}", statement.name().of(context.text())));
    let mut finding = Diagnostic::new(
        Code::MaterialReplaced,
        format!("{name} takes another material before anything uses it"),
        first.span,
        "does nothing",
    )
    .label(second, "this material replaces it")
    .help("remove one of the two statements");
    finding.fix = context.removal("remove the first statement", &[first.span]);
    Some(finding)
}
