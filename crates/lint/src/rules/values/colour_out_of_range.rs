//! Colours of surfaces that no surface has.

use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::{figure, material_name};

rule! {
    /// A material whose red, green or blue is less than 0 or more than 1.
    ///
    /// The colour of a surface is the share of each component that it throws back. Over 1 it shines brighter than what
    /// lights it, and most of the picture is clipped to white; below 0 it takes light away. Colours from 0 to 255 are
    /// the usual cause.
    ///
    /// The colour of a light may be as large as you like: that is its strength.
    ///
    /// ## Example
    ///
    /// ```scene
    /// ?red := 0.2 0.7 0 0 0 1 1 230 26 26
    /// !ball := sphere
    /// !ball ?= red
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
    ColourOutOfRange, check
}

/// Place of the red among a material's values.
const RED: usize = 7;

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (material, statement) in context.materials() {
        let colour = material.colour.to_array();
        let mut outside = (RED..).zip(colour).filter(|(_, part)| !(0.0..=1.0).contains(part));
        let Some((number, part)) = outside.next() else {
            continue;
        };
        let bytes = colour
            .iter()
            .all(|part| part.fract() == 0.0 && (0.0..=255.0).contains(part));
        let help = if bytes && colour.iter().any(|part| *part > 2.0) {
            let shares = colour.map(|part| ((part / 255.0 * 1e3).round() / 1e3).to_string());
            format!("colours go from 0 to 1, not to 255: `{}`", shares.join(" "))
        } else {
            "the components of a surface's colour go from 0 to 1".to_owned()
        };
        let mut finding = Diagnostic::new(
            Code::ColourOutOfRange,
            format!(
                "the colour of {} lies outside 0 to 1",
                material_name(context, statement)
            ),
            context.value_at(statement, number),
            format!("is {}", figure(part)),
        )
        .help(help);
        for (number, part) in outside {
            finding = finding.label(context.value_at(statement, number), format!("is {}", figure(part)));
        }
        findings.push(finding);
    }
}
