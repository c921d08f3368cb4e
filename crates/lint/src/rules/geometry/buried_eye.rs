//! Eyes inside solids.

use scenec_scene::{MaterialId, Scene, SolidId, SolidKind};
use scenec_text::{Code, Diagnostic};

use super::{made, name_of, setting_line};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::{Member, Place};

rule! {
    /// The eye is inside a solid that isn't transparent: it sees the inner side of what is around it.
    ///
    /// Usually the camera was moved into the ground, or a thing was made so large that it took the camera in. An eye in
    /// water or glass is not reported: there it is meant. Nor is one in a hollow that was carved out of a solid, since that is outside.
    ///
    /// That the eye is inside is worked out from the operators, with allowance for rounding.
    ///
    /// ## Example
    ///
    /// ```scene
    /// eyepos_x := 0
    /// eyepos_y := 0.5
    /// eyepos_z := 4
    /// !hill := sphere
    /// !hill *= 6 6 6
    /// !hill <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// eyepos_x := 0
    /// eyepos_y := 8
    /// eyepos_z := 4
    /// !hill := sphere
    /// !hill *= 6 6 6
    /// !hill <=
    /// ```
    BuriedEye, check
}

/// The most parts of the solid whose materials are looked at; one of more parts may be glass.
const MOST_PARTS: usize = 1 << 12;

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    let mut steps = geometry.steps_for(1);
    let Place::Inside(member) = geometry.place(scene, scene.settings.eyepos, &mut steps) else {
        return;
    };
    if !is_opaque(scene, &member) {
        return;
    }
    let Some(eye) = setting_line(context, "eyepos_x") else {
        return;
    };
    let name = name_of(context, scene, member.solid);
    let mut finding = Diagnostic::new(
        Code::BuriedEye,
        format!("the eye is inside {name}, which is opaque"),
        scene.solid(member.solid).span,
        "the eye is in here and sees its inner side",
    );
    let rest = ["eyepos_y", "eyepos_z"].map(|name| setting_line(context, name));
    for line in [Some(eye)].into_iter().chain(rest).flatten() {
        finding = made(finding, line, "the eye stands here");
    }
    findings.push(finding.help("move the eye out, or make the solid smaller"));
}

/// Whether every part of a solid is certain to be opaque.
fn is_opaque(scene: &Scene, member: &Member) -> bool {
    let opaque = |id: MaterialId| scene.material(id).refract == 0.0;
    if let Some(paint) = member.paint {
        return opaque(paint);
    }
    let mut open: Vec<SolidId> = vec![member.solid];
    for _ in 0..MOST_PARTS {
        let Some(id) = open.pop() else { return true };
        match &scene.solid(id).kind {
            SolidKind::Leaf(leaf) if !opaque(leaf.material) => return false,
            SolidKind::Paint { material, .. } if !opaque(*material) => return false,
            SolidKind::Leaf(_) | SolidKind::Paint { .. } => {}
            SolidKind::Combine { left, right, .. } => open.extend([*left, *right]),
        }
    }
    false
}
