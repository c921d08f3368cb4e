//! What is traced and with what: the plan in one precision, its balls and boxes in eights, and the processor's vectors.

use std::ops::{Deref, DerefMut};

use scenec_plan::{Packed, Plan, Real, Wide};

/// A plan as this tracer reads it. It stands for the packed plan wherever that is meant.
pub(crate) struct Prepared<R> {
    packed: Packed<R>,
    pub(crate) wide: Wide<R>,
}

impl<R: Real> Prepared<R> {
    pub(crate) fn new(plan: &Plan) -> Self {
        let packed = plan.packed();
        Self {
            wide: Wide::new(&packed),
            packed,
        }
    }
}

impl<R> Deref for Prepared<R> {
    type Target = Packed<R>;

    #[inline(always)]
    fn deref(&self) -> &Packed<R> {
        &self.packed
    }
}

impl<R> DerefMut for Prepared<R> {
    fn deref_mut(&mut self) -> &mut Packed<R> {
        &mut self.packed
    }
}

/// Handed to everything that traces.
#[derive(Clone, Copy)]
pub(crate) struct Stage<'a, R, S> {
    pub(crate) scene: &'a Prepared<R>,
    /// What this processor can do, as the compiler knows it.
    pub(crate) simd: S,
}

impl<R, S> Deref for Stage<'_, R, S> {
    type Target = Prepared<R>;

    #[inline(always)]
    fn deref(&self) -> &Prepared<R> {
        self.scene
    }
}
