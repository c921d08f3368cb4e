//! Subtractions that leave nothing.

use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

use super::{Written, made};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::Outcome;

rule! {
    /// A subtraction whose first operand lies inside the second leaves nothing at all.
    ///
    /// Often the operands are in the wrong order: `a - b` is what of `a` is not in `b`.
    ///
    /// The finding shows the figures by which the one lies inside the other. Where it touches the outer surface, or rounding
    /// could tell otherwise, nothing is reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !bowl := sphere
    /// !hollow := sphere
    /// !hollow *= 0.9 0.9 0.9
    /// !shell := hollow - bowl
    /// !shell <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !bowl := sphere
    /// !hollow := sphere
    /// !hollow *= 0.9 0.9 0.9
    /// !shell := bowl - hollow
    /// !shell <=
    /// ```
    EmptySubtraction, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for verdict in &geometry.verdicts {
        let Outcome::RemovesAll(proof) = verdict.outcome else {
            continue;
        };
        let Some(Written { left, right, .. }) = Written::of(context, scene, verdict.node) else {
            continue;
        };
        let finding = Diagnostic::new(
            Code::EmptySubtraction,
            format!("subtracting {} leaves nothing of {}", right.name, left.name),
            right.place,
            proof.to_string(),
        );
        let finding = made(finding, left.made, "this lies inside");
        let finding = made(finding, right.made, "this holds all of it");
        let edit = |at: Span, text: Span| Edit {
            span: at,
            text: text.of(context.text()).to_owned(),
        };
        let swap = Fix {
            title: "swap the operands".to_owned(),
            edits: vec![edit(left.place, right.place), edit(right.place, left.place)],
            safe: false,
        };
        findings.push(
            finding
                .help("swap the operands, or make the second one smaller")
                .fix(swap),
        );
    }
}
