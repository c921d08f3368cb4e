//! The transforms of a scene as they were written, and what they come to.

use std::num::NonZeroU32;

use scenec_text::Span;

use crate::{Axis, DVec3, Transform};

/// How many steps in a row are taken again to tell what they come to. Only behind the last one of so many the transform
/// is kept: it is four times as large as what was written.
const STRIDE: u8 = 8;

/// Number of a written transform in its scene.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct StepId(NonZeroU32);

impl StepId {
    fn after(count: usize) -> Self {
        Self(
            u32::try_from(count)
                .ok()
                .and_then(|count| NonZeroU32::MIN.checked_add(count))
                .unwrap_or(NonZeroU32::MAX),
        )
    }

    /// The number as an index.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0.get() as usize - 1
    }
}

/// A transform as it was written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Step {
    /// The one before it, on the same object.
    pub previous: Option<StepId>,
    /// What it does.
    pub kind: StepKind,
    /// The statement.
    pub span: Span,
}

/// What a written transform does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum StepKind {
    /// Scale along the world's axes.
    Scale(DVec3),
    /// Rotate about a world axis, radians, right-handed.
    Rotate(Axis, f64),
    /// Translate, world units.
    Translate(DVec3),
}

impl StepKind {
    /// `transform` followed by this.
    #[must_use]
    #[inline]
    pub fn after(self, mut transform: Transform) -> Transform {
        self.follow(&mut transform);
        transform
    }

    /// Makes `transform` what it is when followed by this.
    #[inline]
    fn follow(self, transform: &mut Transform) {
        match self {
            Self::Scale(by) => transform.scale(by),
            Self::Rotate(axis, angle) => transform.rotate(axis, angle),
            Self::Translate(by) => transform.translate(by),
        }
    }
}

/// Every transform that was written. Each goes on from another one of the same object, so that copies of an object have
/// their common beginning in common.
#[derive(Clone, Debug, Default)]
pub struct Steps {
    list: Vec<Stored>,
    /// What some of them come to, by their numbers.
    kept: Vec<(StepId, Transform)>,
    /// What the last one comes to: mostly the next one goes on from there.
    newest: Option<(StepId, Transform)>,
}

/// A step in 40 bytes.
#[derive(Clone, Debug)]
struct Stored {
    /// The three numbers of a scale or a translation; an angle is the first.
    by: DVec3,
    span: Span,
    previous: Option<StepId>,
    verb: Verb,
    /// How many steps back the nearest transform lies that is kept, or the beginning.
    distance: u8,
}

#[derive(Clone, Copy, Debug)]
enum Verb {
    Scale,
    Rotate(Axis),
    Translate,
}

impl Steps {
    /// None, with room for about so many.
    #[must_use]
    pub fn with_room(room: usize) -> Self {
        Self {
            list: Vec::with_capacity(room),
            kept: Vec::new(),
            newest: None,
        }
    }

    /// Adds a step.
    ///
    /// # Errors
    /// What it would come to, if not every number of that is finite; then nothing is added.
    pub fn push(&mut self, step: Step) -> Result<StepId, Box<Transform>> {
        let mut transform = match self.newest {
            Some((newest, transform)) if step.previous == Some(newest) => transform,
            _ => self.transform(step.previous),
        };
        step.kind.follow(&mut transform);
        if !transform.is_finite() {
            return Err(Box::new(transform));
        }
        let before = step.previous.and_then(|id| self.list.get(id.index()));
        let distance = before.map_or(1, |before| before.distance + 1) % STRIDE;
        Ok(self.add(step, distance, transform))
    }

    /// Adds a transform that nobody wrote, for a scene that is made otherwise than from a file.
    pub fn place(&mut self, transform: Transform) -> StepId {
        let nowhere = Step {
            previous: None,
            kind: StepKind::Translate(DVec3::ZERO),
            span: Span::default(),
        };
        self.add(nowhere, 0, transform)
    }

    fn add(&mut self, step: Step, distance: u8, transform: Transform) -> StepId {
        let id = StepId::after(self.list.len());
        if distance == 0 {
            self.kept.push((id, transform));
        }
        self.newest = Some((id, transform));
        let (verb, by) = match step.kind {
            StepKind::Scale(by) => (Verb::Scale, by),
            StepKind::Rotate(axis, angle) => (Verb::Rotate(axis), DVec3::new(angle, 0.0, 0.0)),
            StepKind::Translate(by) => (Verb::Translate, by),
        };
        self.list.push(Stored {
            by,
            span: step.span,
            previous: step.previous,
            verb,
            distance,
        });
        id
    }

    /// What an object's steps come to, up to this one; the identity without any.
    #[must_use]
    pub fn transform(&self, last: Option<StepId>) -> Transform {
        let mut open = [None; STRIDE as usize];
        let mut count = 0;
        let mut transform = Transform::IDENTITY;
        let mut next = last;
        while let Some((id, stored)) = next.and_then(|id| Some((id, self.list.get(id.index())?))) {
            if stored.distance == 0 {
                transform = self.kept_at(id);
                break;
            }
            let Some(place) = open.get_mut(count) else { break };
            *place = Some(stored);
            count += 1;
            next = stored.previous;
        }
        for stored in open.iter().rev().copied().flatten() {
            stored.kind().follow(&mut transform);
        }
        transform
    }

    fn kept_at(&self, id: StepId) -> Transform {
        let found = self.kept.binary_search_by_key(&id, |(id, _)| *id).ok();
        let kept = found.and_then(|index| self.kept.get(index));
        kept.map_or(Transform::IDENTITY, |(_, transform)| *transform)
    }

    /// The step with this number.
    #[must_use]
    pub fn get(&self, id: StepId) -> Option<Step> {
        self.list.get(id.index()).map(Stored::step)
    }

    /// Every step, in the order of the file; a [`StepId`] is an index into them.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Step> + '_ {
        self.list.iter().map(Stored::step)
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}

impl Stored {
    const fn kind(&self) -> StepKind {
        match self.verb {
            Verb::Scale => StepKind::Scale(self.by),
            Verb::Rotate(axis) => StepKind::Rotate(axis, self.by.x),
            Verb::Translate => StepKind::Translate(self.by),
        }
    }

    const fn step(&self) -> Step {
        Step {
            previous: self.previous,
            kind: self.kind(),
            span: self.span,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Span, Step, StepKind, Steps, Stored};
    use crate::{Axis, DVec3, Transform};

    /// A chain comes, at every length, to what its steps come to one after the other.
    fn check(length: u32) {
        let kind = |number: u32| match number % 3 {
            0 => StepKind::Scale(DVec3::new(1.5, -0.75, 0.9)),
            1 => StepKind::Rotate(Axis::Y, f64::from(number)),
            _ => StepKind::Translate(DVec3::new(1.0, f64::from(number), 0.1)),
        };
        let (mut steps, mut last, mut expect) = (Steps::default(), None, Transform::IDENTITY);
        for number in 0..length {
            assert_eq!(steps.transform(last), expect, "{number}");
            let step = Step {
                previous: last,
                kind: kind(number),
                span: Span::at(number),
            };
            let id = steps.push(step).unwrap();
            assert_eq!(steps.get(id), Some(step));
            (last, expect) = (Some(id), kind(number).after(expect));
        }
        assert_eq!(steps.transform(last), expect);
        assert_eq!(steps.len(), length as usize);
    }

    #[test]
    fn chains_come_to_what_their_steps_come_to() {
        [0, 1, 7, 8, 9, 40].into_iter().for_each(check);
    }

    #[test]
    fn what_is_not_finite_is_not_added() {
        let mut steps = Steps::default();
        let huge = |previous| Step {
            previous,
            kind: StepKind::Scale(DVec3::splat(1e300)),
            span: Span::default(),
        };
        let first = steps.push(huge(None)).unwrap();
        assert!(steps.push(huge(Some(first))).is_err());
        assert_eq!(steps.len(), 1);
    }

    #[test]
    fn a_given_place_is_one_to_go_on_from() {
        let mut steps = Steps::default();
        let place = Transform::IDENTITY.rotated(Axis::X, 0.5).translated(DVec3::ONE);
        let given = steps.place(place);
        let moved = steps.push(Step {
            previous: Some(given),
            kind: StepKind::Translate(DVec3::X),
            span: Span::default(),
        });
        assert_eq!(steps.transform(moved.ok()), place.translated(DVec3::X));
    }

    #[test]
    fn a_step_is_small() {
        assert_eq!(size_of::<Stored>(), 40);
    }
}
