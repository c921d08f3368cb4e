//! Lights that take light away.

use scenec_scene::{Settings, setting};
use scenec_text::{Code, Diagnostic, Span};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::figure;

rule! {
    /// A light of negative colour, or an ambient light whose colour times its intensity is negative.
    ///
    /// Such a light darkens what it reaches.
    ///
    /// ## Example
    ///
    /// ```scene
    /// *lamp := 0 5 0 1 -1 1
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// *lamp := 0 5 0 1 1 1
    /// !ball := sphere
    /// !ball <=
    /// ```
    NegativeLight, check
}

/// Place of the red among a light's values.
const RED: usize = 3;

fn check(context: &Context<'_>, findings: &mut Findings) {
    for light in context.lights() {
        let mut negative = (RED..).zip(light.colour.to_array()).filter(|(_, part)| *part < 0.0);
        let Some((number, part)) = negative.next() else {
            continue;
        };
        let mut finding = report(
            "this light takes light away",
            context.value_at(light.span, number),
            part,
        );
        for (number, part) in negative {
            finding = finding.label(context.value_at(light.span, number), format!("is {}", figure(part)));
        }
        findings.push(finding);
    }
    if let Some(settings) = context.settings() {
        ambient(context, settings, findings);
    }
}

fn ambient(context: &Context<'_>, settings: &Settings, findings: &mut Findings) {
    let parts = settings
        .ambient
        .to_array()
        .into_iter()
        .zip(settings.ambient_int.to_array());
    for ((colour, intensity), letter) in parts.zip(["r", "g", "b"]) {
        if colour * intensity >= 0.0 {
            continue;
        }
        let (name, part) = if colour < 0.0 {
            (format!("ambient_{letter}"), colour)
        } else {
            (format!("ambient_int_{letter}"), intensity)
        };
        if let Some((_, value)) = setting(&name).and_then(|row| context.setting(row)) {
            findings.push(report("the ambient light takes light away", value, part));
        }
    }
}

fn report(message: &str, value: Span, part: f64) -> Diagnostic {
    Diagnostic::new(Code::NegativeLight, message, value, format!("is {}", figure(part)))
        .help("the components of a light's colour are 0 or more")
}
