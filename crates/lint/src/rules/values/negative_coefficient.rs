//! Negative shares of light.

use scenec_scene::MATERIAL_FIELDS;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::{figure, material_name};

rule! {
    /// A material whose share of ambient, diffuse, highlight, reflected or refracted light is negative.
    ///
    /// The surface then takes light away, so that a lamp darkens what it shines on. Nothing forbids it, but a sign is
    /// easily written by mistake: `0.1 -0.7` are two values, and there is no subtraction.
    ///
    /// ## Example
    ///
    /// ```scene
    /// ?odd := 0.2 -0.7 0 0 0 1 1 0.9 0.1 0.1
    /// !ball := sphere
    /// !ball ?= odd
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// ?odd := 0.2 0.7 0 0 0 1 1 0.9 0.1 0.1
    /// !ball := sphere
    /// !ball ?= odd
    /// !ball <=
    /// ```
    NegativeCoefficient, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (material, statement) in context.materials() {
        let shares = [
            material.ambient,
            material.diffuse,
            material.specular,
            material.reflect,
            material.refract,
        ];
        // One report for a statement, at its first negative value.
        let mut negative = shares.iter().enumerate().filter(|(_, share)| **share < 0.0);
        let Some((number, share)) = negative.next() else {
            continue;
        };
        let field = MATERIAL_FIELDS.get(number).map_or("value", |field| field.name);
        let mut finding = Diagnostic::new(
            Code::NegativeCoefficient,
            format!(
                "`{field}` of {} is negative, so it takes light away",
                material_name(context, statement)
            ),
            context.value_at(statement, number),
            format!("is {}", figure(*share)),
        )
        .help("shares of light are 0 or more");
        for (number, share) in negative {
            finding = finding.label(context.value_at(statement, number), format!("is {}", figure(*share)));
        }
        findings.push(finding);
    }
}
