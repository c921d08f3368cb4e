//! Mirrors and glass in a scene that follows no ray on.

use scenec_scene::setting;
use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::{REFLECT, REFRACT, material_name};

rule! {
    /// A material reflects or refracts, but `raydepth` is 0, so that no ray is followed beyond the first surface.
    ///
    /// The mirror shows nothing and the glass is black. A mirror needs a depth of 1, a glass ball 2 (one refraction on
    /// the way in, one on the way out), and things seen in or through each other more.
    ///
    /// One report stands for all materials of the picture.
    ///
    /// ## Example
    ///
    /// ```scene
    /// raydepth := 0
    /// ?mirror := 0 0 0 0.9 0 1 1 1 1 1
    /// !ball := sphere
    /// !ball ?= mirror
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// raydepth := 4
    /// ?mirror := 0 0 0 0.9 0 1 1 1 1 1
    /// !ball := sphere
    /// !ball ?= mirror
    /// !ball <=
    /// ```
    LostReflection, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    if context.scene().is_none_or(|scene| scene.settings.raydepth > 0) {
        return;
    }
    let mut shown = context.shown_materials();
    let found = shown.find(|(material, _)| material.reflect > 0.0 || material.refract > 0.0);
    let depth = setting("raydepth").and_then(|row| context.setting(row));
    let (Some((material, statement)), Some((_, depth))) = (found, depth) else {
        return;
    };
    let (verb, number) = if material.reflect > 0.0 {
        ("reflects", REFLECT)
    } else {
        ("refracts", REFRACT)
    };
    findings.push(
        Diagnostic::new(
            Code::LostReflection,
            format!(
                "{} {verb}, but no ray is followed beyond the first surface",
                material_name(context, statement)
            ),
            depth,
            "no reflections and no refractions",
        )
        .label(context.value_at(statement, number), "shows nothing")
        .help("set `raydepth` to 1 or more; glass needs at least 2"),
    );
}
