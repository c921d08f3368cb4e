//! Transforms of an object into itself.

use scenec_interpret::Role;
use scenec_scene::{Axis, Base, DVec3, StepId, StepKind};
use scenec_text::{Code, Diagnostic, Span};

use crate::context::Context;
use crate::findings::Findings;

rule! {
    /// A transform that maps the object onto itself: a ball turned about its own centre, a half-space stretched or
    /// moved along its own plane.
    ///
    /// Transforms act about the origin in the order in which they are written. A ball at the origin looks the same from
    /// every side, so it has to be stretched or moved first and turned afterwards. A half-space has no ends and no
    /// pattern: along its plane there is nothing to stretch, turn or move.
    ///
    /// Only what follows from the transforms before it is reported, never what merely comes close. A transform by a
    /// variable that other statements read too is passed over: there, several objects are treated alike.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !egg := sphere
    /// !egg #z= 0.5
    /// !egg *= 1 2 1
    /// !egg <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !egg := sphere
    /// !egg *= 1 2 1
    /// !egg #z= 0.5
    /// !egg <=
    /// ```
    EffectlessTransform, check
}

/// What is certain about an object after its transforms so far, for either base object.
#[derive(Clone, Copy)]
struct Known {
    /// A sphere is still round, with its centre at the origin.
    ball: bool,
    /// A half-space still ends at a horizontal plane, at this height.
    height: Option<f64>,
}

const UNTOUCHED: Known = Known {
    ball: true,
    height: Some(0.0),
};

impl Known {
    fn after(self, kind: StepKind) -> Self {
        let uniform = |by: DVec3| by.x.abs() == by.y.abs() && by.y.abs() == by.z.abs();
        let level = |height: &f64| height.is_finite();
        match kind {
            StepKind::Scale(by) => Self {
                ball: self.ball && uniform(by),
                height: self.height.map(|height| height * by.y).filter(level),
            },
            StepKind::Rotate(axis, angle) => Self {
                ball: self.ball,
                height: self.height.filter(|_| axis == Axis::Y || angle == 0.0),
            },
            StepKind::Translate(by) => Self {
                ball: self.ball && by == DVec3::ZERO,
                height: self.height.map(|height| height + by.y).filter(level),
            },
        }
    }

    /// Why a transform maps the object onto itself; `None` if that isn't certain.
    fn reason(self, base: Base, kind: StepKind) -> Option<&'static str> {
        match (base, kind) {
            (Base::Sphere, StepKind::Rotate(..)) if self.ball => Some("a ball turned about its centre stays as it is"),
            (Base::Sphere, StepKind::Scale(by)) if self.ball && by.abs() == DVec3::ONE => {
                Some("a ball mirrored at its centre stays as it is")
            }
            (Base::HalfSpace, StepKind::Rotate(Axis::Y, _)) if self.height.is_some() => {
                Some("a level half-space turned about y stays as it is")
            }
            (Base::HalfSpace, StepKind::Scale(by)) if self.height.is_some_and(|at| still(at, by.y)) => {
                Some("a half-space has no ends, so stretched along its plane it stays as it is")
            }
            (Base::HalfSpace, StepKind::Translate(by)) if self.height.is_some() && by.y == 0.0 => {
                Some("a half-space has no ends, so moved along its plane it stays as it is")
            }
            _ => None,
        }
    }
}

/// Whether a half-space with its plane at this height is its own image when it is stretched upwards.
fn still(height: f64, by: f64) -> bool {
    by == 1.0 || (height == 0.0 && by > 0.0)
}

/// Whether a value of the transform is a variable that other statements read too.
fn shared(context: &Context<'_>, statement: Span) -> bool {
    let here = context.places_on(statement).filter(|place| place.role == Role::Use);
    let elsewhere = |id| context.uses(id) as usize > here.clone().filter(|place| place.definition == Some(id)).count();
    here.clone().filter_map(|place| place.definition).any(elsewhere)
}

/// Whether another rule reports the transform.
fn idle(kind: StepKind) -> bool {
    match kind {
        StepKind::Scale(by) => by == DVec3::ONE,
        StepKind::Rotate(_, angle) => angle == 0.0,
        StepKind::Translate(by) => by == DVec3::ZERO,
    }
}

/// What is certain after each transform, by their numbers.
struct After {
    balls: Vec<bool>,
    /// Not a number where nothing is certain: so a height takes eight bytes and not sixteen.
    heights: Vec<f64>,
}

impl After {
    fn with_room(steps: usize) -> Self {
        Self {
            balls: Vec::with_capacity(steps),
            heights: Vec::with_capacity(steps),
        }
    }

    fn get(&self, step: StepId) -> Option<Known> {
        Some(Known {
            ball: *self.balls.get(step.index())?,
            height: self
                .heights
                .get(step.index())
                .copied()
                .filter(|height| !height.is_nan()),
        })
    }

    fn push(&mut self, known: Known) {
        self.balls.push(known.ball);
        self.heights.push(known.height.unwrap_or(f64::NAN));
    }
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let mut after = After::with_room(context.steps().len());
    for (index, step) in context.steps().iter().enumerate() {
        let before = step.previous.and_then(|id| after.get(id)).unwrap_or(UNTOUCHED);
        after.push(before.after(step.kind));
        let reason = context.moved(index).and_then(|base| before.reason(base, step.kind));
        if let Some(reason) = reason.filter(|_| !idle(step.kind) && !shared(context, step.span)) {
            let mut finding = Diagnostic::new(
                Code::EffectlessTransform,
                "this transform maps the object onto itself",
                step.span,
                reason,
            )
            .help("remove it, or move it behind the transform that it should act upon");
            finding.fix = context.removal("remove the transform", &[step.span]);
            if let Some(fix) = &mut finding.fix {
                // The same solid, but its numbers may be rounded otherwise.
                fix.safe = false;
            }
            findings.push(finding);
        }
    }
}
