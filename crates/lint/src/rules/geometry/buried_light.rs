//! Lights inside solids.

use scenec_scene::{DVec3, Scene};
use scenec_text::{Code, Diagnostic};

use super::{made, name_of};
use crate::context::{Context, Reach};
use crate::findings::Findings;
use crate::geometry::Place;

rule! {
    /// A light inside an opaque solid lights nothing: its own solid is between it and every surface that can be seen.
    ///
    /// Every object casts a full shadow, and a lamp's own bulb is no exception. Put the light beside its bulb, or carve
    /// a hollow for it.
    ///
    /// That the light is inside, and the eye is not, is worked out from the operators, with allowance for rounding. Nothing
    /// is reported while any part of the picture is made of something that refracts, since a ray may then get inside.
    ///
    /// ## Example
    ///
    /// ```scene
    /// *lamp := 0.2 0.1 0 1 1 1
    /// !bulb := sphere
    /// !bulb <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// *lamp := 0.2 1.5 0 1 1 1
    /// !bulb := sphere
    /// !bulb <=
    /// ```
    BuriedLight, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    let opaque = context.reach().is_some_and(|reach| is_opaque(scene, reach));
    let mut steps = geometry.steps_for(scene.lights.len() + 1);
    let mut place = |point: DVec3| geometry.place(scene, point, &mut steps);
    if !opaque || scene.lights.is_empty() || !matches!(place(scene.settings.eyepos), Place::Outside) {
        return;
    }
    for light in scene.lights.iter().filter(|light| light.colour != DVec3::ZERO) {
        let Place::Inside(member) = place(light.position) else {
            continue;
        };
        let name = name_of(context, scene, member.solid);
        let finding = Diagnostic::new(
            Code::BuriedLight,
            format!("this light is inside {name}, which is opaque, and lights nothing"),
            light.span,
            "no surface that can be seen is lit by it",
        );
        let finding = made(finding, scene.solid(member.solid).span, "the light is in here");
        findings.push(finding.help("move the light out of the solid, or carve a hollow for it"));
    }
}

/// Whether no ray is ever refracted.
fn is_opaque(scene: &Scene, reach: &Reach) -> bool {
    let mut materials = scene.materials.iter().enumerate();
    scene.settings.raydepth == 0 || !materials.any(|(index, one)| reach.material(index) && one.refract != 0.0)
}
