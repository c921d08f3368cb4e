//! Highlights in a scene without lights.

use scenec_scene::DVec3;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::{figure, material_name};

rule! {
    /// A material has a highlight, but the scene has no light that could show in it.
    ///
    /// Highlights are the mirror images of lights. Without a light only ambient light, reflections and refractions are
    /// seen; the diffuse share shows as little as the highlight. A light that is black counts as none.
    ///
    /// One report stands for all materials of the picture.
    ///
    /// ## Example
    ///
    /// ```scene
    /// ?metal := 0.2 0.3 0.8 0 0 1 40 0.9 0.8 0.3
    /// !ball := sphere
    /// !ball ?= metal
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// ?metal := 0.2 0.3 0.8 0 0 1 40 0.9 0.8 0.3
    /// !ball := sphere
    /// !ball ?= metal
    /// !ball <=
    /// *lamp := 3 5 4 1 1 1
    /// ```
    LostHighlight, check
}

/// Place of the share of the highlight among a material's values.
const SPECULAR: usize = 2;

fn check(context: &Context<'_>, findings: &mut Findings) {
    // A black light is reported for itself.
    if !context.lights().is_empty() && context.lights().iter().any(|light| light.colour != DVec3::ZERO) {
        return;
    }
    let mut shown = context.shown_materials();
    let Some((material, statement)) = shown.find(|(material, _)| material.specular > 0.0) else {
        return;
    };
    let finding = Diagnostic::new(
        Code::LostHighlight,
        format!(
            "the highlight of {} can't show: the scene has no light",
            material_name(context, statement)
        ),
        context.value_at(statement, SPECULAR),
        format!("is {}", figure(material.specular)),
    )
    .help("place a light, such as `*lamp := 3 5 4 1 1 1`");
    findings.push(context.lights().iter().fold(finding, |finding, light| {
        finding.label(light.span, "this light is black")
    }));
}
