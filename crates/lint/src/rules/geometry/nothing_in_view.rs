//! Cameras that look past everything.

use scenec_text::{Code, Diagnostic};

use super::{made, name_of, setting_line};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::Frustum;

rule! {
    /// No ray of the camera meets anything, so the picture shows the sky alone.
    ///
    /// Usually the camera looks the other way, or everything is beside the picture.
    ///
    /// The finding rests on the planes through the eye along the four edges of the picture, and the one behind the eye:
    /// every part lies beyond one of them. A half-space is not in view if the eye is outside of it and all four
    /// corners of the picture look away from its plane. Where any part might show, nothing is reported.
    ///
    /// ## Example
    ///
    /// ```scene
    /// eyepos_x := 0
    /// eyepos_y := 0
    /// eyepos_z := 5
    /// lookat_x := 0
    /// lookat_y := 0
    /// lookat_z := 9
    /// !ball := sphere
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// eyepos_x := 0
    /// eyepos_y := 0
    /// eyepos_z := 5
    /// lookat_x := 0
    /// lookat_y := 0
    /// lookat_z := 0
    /// !ball := sphere
    /// !ball <=
    /// ```
    NothingInView, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some(scene) = context.scene() else { return };
    let missed = Frustum::of(&scene.settings).is_some_and(|frustum| frustum.misses(scene));
    // Why an empty solid does not show is another finding. The rest of the geometry is looked at only if nothing shows.
    if !missed || context.geometry().is_none_or(|(_, geometry)| geometry.empty) {
        return;
    }
    let Some(aim) = setting_line(context, "lookat_x") else {
        return;
    };
    let mut finding = Diagnostic::new(
        Code::NothingInView,
        format!(
            "no part of {} is in view: each lies beyond an edge of the picture or behind the eye",
            name_of(context, scene, scene.root)
        ),
        aim,
        "the camera looks here",
    );
    for name in ["lookat_y", "lookat_z"] {
        if let Some(line) = setting_line(context, name) {
            finding = made(finding, line, "the camera looks here");
        }
    }
    for name in ["eyepos_x", "eyepos_y", "eyepos_z"] {
        if let Some(line) = setting_line(context, name) {
            finding = made(finding, line, "from here");
        }
    }
    findings.push(finding.help("point the camera at what it should show"));
}
