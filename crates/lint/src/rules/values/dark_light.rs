//! Lights that are black.

use scenec_scene::DVec3;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A light of the colour `0 0 0` lights nothing, though every point asks whether it is in its shadow.
    ///
    /// ## Example
    ///
    /// ```scene
    /// *lamp := 0 5 0 0 0 0
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
    ///
    /// To switch a light off for a while, put a `/` before its statement.
    DarkLight, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    for light in context.lights().iter().filter(|light| light.colour == DVec3::ZERO) {
        let mut finding = Diagnostic::new(
            Code::DarkLight,
            "this light is black and lights nothing",
            light.span,
            "its colour is 0 0 0",
        )
        .help("give it a colour, or remove it");
        finding.fix = context.removal("remove the light", &[light.span]);
        findings.push(finding);
    }
}
