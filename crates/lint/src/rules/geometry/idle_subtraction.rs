//! Subtractions of what isn't there.

use scenec_text::{Code, Diagnostic};

use super::{Written, made};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::Outcome;

rule! {
    /// A subtraction whose operands have no point in common leaves the first one as it is.
    ///
    /// Most often the second one was placed beside the first, or was not made large enough to reach it.
    ///
    /// The finding shows why they can't meet: the distance of two balls, a plane between them, or the boxes around them.
    /// Two solids that touch, or come so near that rounding could tell otherwise, are not reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !apple := sphere
    /// !bite := sphere
    /// !bite *= 0.5 0.5 0.5
    /// !bite += 1.6 0 0
    /// !bitten := apple - bite
    /// !bitten <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !apple := sphere
    /// !bite := sphere
    /// !bite *= 0.5 0.5 0.5
    /// !bite += 1.2 0 0
    /// !bitten := apple - bite
    /// !bitten <=
    /// ```
    IdleSubtraction, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for verdict in &geometry.verdicts {
        let Outcome::RemovesNothing(proof) = verdict.outcome else {
            continue;
        };
        let Some(Written { left, right, .. }) = Written::of(context, scene, verdict.node) else {
            continue;
        };
        let finding = Diagnostic::new(
            Code::IdleSubtraction,
            format!("subtracting {} removes nothing from {}", right.name, left.name),
            right.place,
            proof.to_string(),
        );
        let finding = made(finding, right.made, "this is subtracted");
        let finding = made(finding, left.made, "from this");
        findings.push(finding.help("move or scale one of them so that they meet, or remove the subtraction"));
    }
}
