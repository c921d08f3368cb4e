//! Rotations that look like degrees.

use std::collections::HashSet;
use std::f64::consts::TAU;

use scenec_scene::StepKind;
use scenec_syntax::ValueKind;
use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::figure;

rule! {
    /// A rotation by more than a full turn, which 2 pi is: the value may be meant in degrees.
    ///
    /// Angles are in radians. 90 degrees are `pi/2`, which has to be written as a number, 1.5708, since the language
    /// has no division; 180 degrees are `pi`. A value up to one hundredth over a full turn passes as a rounded one.
    ///
    /// A variable that several rotations read is reported once, at the first.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !egg := sphere
    /// !egg *= 1 2 1
    /// !egg #z= 45
    /// !egg <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !egg := sphere
    /// !egg *= 1 2 1
    /// !egg #z= 0.7854
    /// !egg <=
    /// ```
    LikelyDegrees, check
}

/// The largest angle that passes, radians.
const LARGEST: f64 = TAU * 1.01;

fn check(context: &Context<'_>, findings: &mut Findings) {
    let mut seen: HashSet<Span> = HashSet::new();
    for step in context.steps().iter() {
        let StepKind::Rotate(_, angle) = step.kind else {
            continue;
        };
        if angle.abs() <= LARGEST {
            continue;
        }
        let variable = context
            .variables_on(step.span)
            .next()
            .map(|(_, definition)| definition.line);
        if variable.is_none_or(|line| seen.insert(line)) {
            findings.push(report(context, step.span, angle, variable));
        }
    }
}

fn report(context: &Context<'_>, statement: Span, angle: f64, variable: Option<Span>) -> Diagnostic {
    let value = context.value_at(statement, 0);
    let radians = angle.to_radians();
    let (degrees, turned) = (figure(angle), figure(radians));
    let finding = Diagnostic::new(
        Code::LikelyDegrees,
        format!("a rotation by {degrees} is more than a full turn: are these degrees?"),
        value,
        format!("{degrees} radians"),
    )
    .help(format!("angles are in radians: {degrees} degrees are {turned}"));
    if let Some(line) = variable {
        return finding.label(line, "the value comes from here");
    }
    let rotation = context.statement_at(statement);
    match rotation
        .as_ref()
        .and_then(|rotation| rotation.values().first())
        .map(|value| value.kind)
    {
        Some(ValueKind::Number(_)) => finding.fix(Fix {
            title: "take it as degrees".to_owned(),
            edits: vec![Edit {
                span: value,
                text: radians.to_string(),
            }],
            safe: false,
        }),
        _ => finding,
    }
}
