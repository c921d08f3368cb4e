//! Intersections that cut nothing away.

use scenec_text::{Code, Diagnostic};

use super::{Written, made};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::{Operand, Outcome};

rule! {
    /// An intersection with a solid that holds the other operand cuts nothing away.
    ///
    /// Most often the cut was placed too far out, or faces the wrong way: a half-space is what lies below its plane, and a
    /// scale by -1 along y makes it what lies above.
    ///
    /// The finding shows the figures by which the one lies inside the other. Where it touches the outer surface, or rounding
    /// could tell otherwise, nothing is reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !cut := hp
    /// !cut += 0 1.5 0
    /// !dome := ball & cut
    /// !dome <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !cut := hp
    /// !cut += 0 0.5 0
    /// !dome := ball & cut
    /// !dome <=
    /// ```
    IdleIntersection, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for verdict in &geometry.verdicts {
        let Outcome::Idle(idle, proof) = verdict.outcome else {
            continue;
        };
        let Some(written) = Written::of(context, scene, verdict.node) else {
            continue;
        };
        let outer = written.operand(idle);
        let inner = written.operand(match idle {
            Operand::Left => Operand::Right,
            Operand::Right => Operand::Left,
        });
        let finding = Diagnostic::new(
            Code::IdleIntersection,
            format!("{} cuts nothing away from {}", outer.name, inner.name),
            outer.place,
            proof.to_string(),
        );
        let finding = made(finding, outer.made, "this holds all of the other");
        let finding = made(finding, inner.made, "this lies inside");
        findings
            .push(finding.help("move or scale one of them so that their surfaces cross, or remove the intersection"));
    }
}
