//! Transforms by nothing.

use scenec_scene::{DVec3, StepKind};
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A scale by 1, a rotation by 0 or a translation by 0 leaves the object as it is.
    ///
    /// Most often it is the remains of an experiment, or one of its values was meant to be another.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball *= 1 1 1
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball *= 1 2 1
    /// !ball <=
    /// ```
    ///
    /// Or remove the statement: the picture stays the same to the last bit.
    IdleTransform, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (index, step) in context.steps().iter().enumerate() {
        // What is wrong with an object that never shows is not this.
        if context.moved(index).is_none() {
            continue;
        }
        let what = match step.kind {
            StepKind::Scale(by) if by == DVec3::ONE => "a scale by 1",
            StepKind::Rotate(_, 0.0) => "a rotation by 0",
            StepKind::Translate(by) if by == DVec3::ZERO => "a translation by 0",
            _ => continue,
        };
        let mut finding = Diagnostic::new(
            Code::IdleTransform,
            format!("{what} leaves the object as it is"),
            step.span,
            "does nothing",
        )
        .help("remove the statement, or give it other values");
        finding.fix = context.removal("remove the transform", &[step.span]);
        findings.push(finding);
    }
}
