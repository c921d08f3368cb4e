//! Objects so far away that single numbers can't tell them from their neighbours.

use std::collections::HashSet;

use scenec_scene::{Base, SolidId, SolidKind, StepId};
use scenec_text::{Code, Diagnostic};

use super::{made, name_of, setting_line};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::{Ball, figure};

rule! {
    /// An object so far from the eye, for its size, that numbers of 32 bits can't place it.
    ///
    /// Pictures are traced in coordinates relative to the eye, in numbers of 32 bits with 24 significant ones. At a distance
    /// of 10,000,000 the numbers that exist are 1 apart; an object of radius 0.5 there is moved by half of its
    /// size, or lost between them. It would be a dot in a picture two million pixels wide.
    ///
    /// Reported is a sphere whose radius, along one of the axes, is less than the step between the numbers at its centre. The finding
    /// gives both.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !star := sphere
    /// !star += 0 0 -30000000
    /// !ball := sphere
    /// !all := ball | star
    /// !all <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !star := sphere
    /// !star += 0 0 -3000
    /// !ball := sphere
    /// !all := ball | star
    /// !all <=
    /// ```
    TooFarToResolve, check
}

/// Each axis with the setting that is the eye's place along it.
const AXES: [[&str; 2]; 3] = [["x", "eyepos_x"], ["y", "eyepos_y"], ["z", "eyepos_z"]];

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, reach)) = context.scene().zip(context.reach()) else {
        return;
    };
    let eye = scene.settings.eyepos;
    let mut seen: HashSet<StepId> = HashSet::new();
    for (index, solid) in scene.solids.iter().enumerate() {
        let SolidKind::Leaf(leaf) = &solid.kind else { continue };
        if leaf.base != Base::Sphere || !reach.solid(index) {
            continue;
        }
        let far = Ball::of(&scene.transform(leaf)).and_then(|ball| unresolved(&ball, (ball.centre - eye).to_array()));
        let Some((axis, distance, step, radius)) = far else {
            continue;
        };
        // Copies of an object have its transforms in common.
        if leaf.steps.is_some_and(|steps| !seen.insert(steps)) {
            continue;
        }
        let name = name_of(context, scene, SolidId(index as u32));
        let [axis, setting] = AXES[axis];
        let mut finding = Diagnostic::new(
            Code::TooFarToResolve,
            format!("{name} is too far from the eye for numbers of 32 bits"),
            solid.span,
            format!(
                "{} away along {axis} they are {} apart; its radius there is {}",
                figure(distance),
                figure(step),
                figure(radius)
            ),
        );
        if let Some(eye) = setting_line(context, setting) {
            finding = made(finding, eye, "seen from here");
        }
        findings.push(finding.help("bring it nearer, or make it larger"));
    }
}

/// The axis along which a ball at this offset from the eye is smaller than the step between singles, with the
/// offset, the step and the ball's radius.
fn unresolved(ball: &Ball, offset: [f64; 3]) -> Option<(usize, f64, f64, f64)> {
    let rows = ball.linear.transpose();
    let radii = [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.length() * (1.0 + 2.0 * ball.slop));
    (0..3).find_map(|axis| {
        let near = (offset[axis].abs() as f32).next_down();
        let step = f64::from(near) - f64::from(near.next_down());
        let (offset, radius) = (offset[axis].abs(), radii[axis]);
        (near.is_normal() && near > 0.0 && step > radius).then_some((axis, offset, step, radius))
    })
}
