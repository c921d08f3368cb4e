//! Transforms that stretch far more one way than another.

use std::collections::HashSet;

use scenec_scene::{Base, DVec3, Scene, SolidKind, Step, StepId, StepKind};
use scenec_text::{Code, Diagnostic};

use super::{made, name_of};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::{Ball, SLACK, figure, frobenius, largest_singular};

rule! {
    /// A sphere that is stretched more than a million times as far one way as another.
    ///
    /// The ratio is the condition number of its transforms. Pictures are traced in numbers of 32 bits, of which such a ratio
    /// uses up 20 of 24 bits: where a ray meets the needle or the disc, and how its surface is turned there, is known to
    /// one digit or so. Make thin things a thousandth of their width, which looks the same.
    ///
    /// The figure is the product of the largest singular values of the transform and of its inverse. Half-spaces are not
    /// reported: stretched along their plane they stay what they are.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !disc := sphere
    /// !disc *= 2 0.000001 2
    /// !disc <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !disc := sphere
    /// !disc *= 2 0.001 2
    /// !disc <=
    /// ```
    IllConditioned, check
}

/// The largest ratio that passes.
const MOST: f64 = 1e6;

/// How many transforms of one object are gone through to find the one to blame.
const MOST_STEPS: usize = 64;

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, reach)) = context.scene().zip(context.reach()) else {
        return;
    };
    let mut seen: HashSet<StepId> = HashSet::new();
    for (index, solid) in scene.solids.iter().enumerate() {
        let SolidKind::Leaf(leaf) = &solid.kind else { continue };
        if leaf.base != Base::Sphere || !reach.solid(index) {
            continue;
        }
        let Some(steps) = leaf.steps else { continue };
        let ratio = Ball::of(&scene.transform(leaf)).and_then(|ball| ratio(&ball));
        // Copies of an object have its transforms in common.
        let Some(ratio) = ratio.filter(|_| seen.insert(steps)) else {
            continue;
        };
        let name = name_of(context, scene, scenec_scene::SolidId(index as u32));
        let Some(step) = most_uneven(scene, steps) else {
            continue;
        };
        let finding = Diagnostic::new(
            Code::IllConditioned,
            format!("{name} is stretched {} times as far one way as another", figure(ratio)),
            step.span,
            "mostly by this scale",
        );
        let finding = made(finding, solid.span, "the object is made here");
        findings.push(finding.help("up to a million passes; make its longest and shortest sides more alike"));
    }
}

/// How much longer the longest half-axis is than the shortest, if that is certain to be too much.
fn ratio(ball: &Ball) -> Option<f64> {
    // The mean of squares along the axes bounds both values from above at a fraction of the cost.
    let bound = frobenius(&ball.linear) * frobenius(&ball.inverse);
    if bound <= MOST {
        return None;
    }
    let ratio = largest_singular(&ball.linear) * largest_singular(&ball.inverse);
    (ratio > MOST * (1.0 + 4.0 * SLACK + 4.0 * ball.slop)).then_some(ratio)
}

/// The scale that differs most from one axis to another, of the last ones.
fn most_uneven(scene: &Scene, last: StepId) -> Option<Step> {
    let step = |id: StepId| scene.steps.get(id);
    let chain = std::iter::successors(step(last), |now| now.previous.and_then(step));
    let uneven = |by: DVec3| by.abs().max_element() / by.abs().min_element();
    let scales = chain.take(MOST_STEPS).filter_map(|step| match step.kind {
        StepKind::Scale(by) => Some((uneven(by), step)),
        StepKind::Rotate(..) | StepKind::Translate(_) => None,
    });
    let most = scales.max_by(|a, b| a.0.total_cmp(&b.0));
    most.map(|(_, step)| step).or_else(|| step(last))
}
