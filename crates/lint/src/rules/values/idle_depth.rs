//! A ray depth that no material uses.

use scenec_scene::setting;
use scenec_syntax::ValueKind;
use scenec_text::{Code, Diagnostic, Edit, Fix};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// `raydepth` is more than 0, but nothing in the picture reflects or refracts.
    ///
    /// It costs nothing and changes nothing: `raydepth := 0` gives the same picture. If there should be a mirror or
    /// glass in it, no object has such a material yet.
    ///
    /// ## Example
    ///
    /// ```scene
    /// raydepth := 4
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// raydepth := 0
    /// !ball := sphere
    /// !ball <=
    /// ```
    IdleDepth, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let depth = context.scene().map_or(0, |scene| scene.settings.raydepth);
    let mut shown = context.shown_materials();
    if depth == 0 || shown.any(|(material, _)| material.reflect != 0.0 || material.refract != 0.0) {
        return;
    }
    let Some((line, value)) = setting("raydepth").and_then(|row| context.setting(row)) else {
        return;
    };
    let mut finding = Diagnostic::new(
        Code::IdleDepth,
        "nothing in the picture reflects or refracts",
        value,
        format!("up to {depth} reflections and refractions that never come"),
    )
    .help("`raydepth := 0` gives the same picture");
    let found = context.statement_at(line);
    let written = found.as_ref().and_then(|found| found.values().first());
    if let Some(ValueKind::Number(_)) = written.map(|value| value.kind) {
        finding = finding.fix(Fix {
            title: "set `raydepth` to 0".to_owned(),
            edits: vec![Edit {
                span: value,
                text: "0".to_owned(),
            }],
            safe: true,
        });
    }
    findings.push(finding);
}
