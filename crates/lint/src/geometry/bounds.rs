//! Boxes around solids.

use scenec_scene::{DVec3, Op, Scene, Solid, SolidId, SolidKind};

use super::proof::Fact;
use super::shape::{SLACK, Shape};

/// A box whose sides are rounded outwards to singles, so that a million of them stay small; without bounds where the
/// solid has none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Bounds {
    pub(crate) low: [f32; 3],
    pub(crate) high: [f32; 3],
}

impl Bounds {
    pub(crate) const EVERYWHERE: Self = Self {
        low: [f32::NEG_INFINITY; 3],
        high: [f32::INFINITY; 3],
    };

    fn new(low: DVec3, high: DVec3) -> Self {
        Self {
            low: low.to_array().map(below),
            high: high.to_array().map(above),
        }
    }

    /// Whether every side is finite.
    pub(crate) fn is_finite(&self) -> bool {
        self.low.iter().chain(&self.high).all(|side| side.is_finite())
    }

    /// Whether this one holds the other. All sides are compared at once: which one decides can't be foreseen.
    pub(crate) fn holds(&self, other: &Self) -> bool {
        (0..3).fold(true, |held, axis| {
            held & (self.low[axis] <= other.low[axis]) & (other.high[axis] <= self.high[axis])
        })
    }

    /// Why the two have no point in common.
    pub(super) fn apart(&self, other: &Self) -> Option<Fact> {
        (0..3).find_map(|axis| {
            let ends = [(self.high[axis], other.low[axis]), (other.high[axis], self.low[axis])];
            let (end, begin) = ends.into_iter().find(|(end, begin)| end < begin)?;
            Some(Fact::Boxes {
                axis,
                end: f64::from(end),
                begin: f64::from(begin),
            })
        })
    }

    /// The same with every side one single farther out: it holds the boxes of solids that are the same but for rounding.
    pub(super) fn grown(&self) -> Self {
        Self {
            low: self.low.map(f32::next_down),
            high: self.high.map(f32::next_up),
        }
    }

    /// How wide it is, all in all.
    pub(super) fn size(&self) -> f32 {
        (0..3).map(|axis| self.high[axis] - self.low[axis]).sum()
    }

    fn around(self, other: Self) -> Self {
        Self {
            low: std::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    /// What both have in common; the first one where that is nothing.
    fn common(self, other: Self) -> Self {
        if self.apart(&other).is_some() {
            return self;
        }
        Self {
            low: std::array::from_fn(|axis| self.low[axis].max(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].min(other.high[axis])),
        }
    }
}

/// The boxes of all solids of a scene, operands first.
pub(super) fn all(scene: &Scene) -> Vec<Bounds> {
    let mut bounds = Vec::with_capacity(scene.solids.len());
    for solid in &scene.solids {
        bounds.push(of(scene, solid, &bounds));
    }
    bounds
}

/// The box of a solid whose operands have theirs.
fn of(scene: &Scene, solid: &Solid, before: &[Bounds]) -> Bounds {
    let at = |id: &SolidId| before.get(id.index()).copied().unwrap_or(Bounds::EVERYWHERE);
    match &solid.kind {
        SolidKind::Paint { inside, .. } => at(inside),
        SolidKind::Combine { op, left, right } => match op {
            Op::Union => at(left).around(at(right)),
            Op::Intersection => at(left).common(at(right)),
            Op::Subtraction => at(left),
        },
        SolidKind::Leaf(_) => Shape::of(scene, solid).map_or(Bounds::EVERYWHERE, |shape| of_shape(&shape)),
    }
}

fn of_shape(shape: &Shape) -> Bounds {
    match shape {
        Shape::Ball(ball) => {
            let rows = ball.linear.transpose();
            let reach = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
            let reach = reach * (1.0 + ball.slop + SLACK) + ball.centre.abs() * SLACK;
            Bounds::new(ball.centre - reach, ball.centre + reach)
        }
        // A plane across an axis bounds it on one side.
        Shape::Half(half) => {
            let mut bounds = Bounds::EVERYWHERE;
            for axis in 0..3 {
                let slack = half.point[axis].abs() * SLACK;
                match half.normal[axis] {
                    1.0 if half.normal.abs().element_sum() == 1.0 => {
                        bounds.high[axis] = above(half.point[axis] + slack);
                    }
                    -1.0 if half.normal.abs().element_sum() == 1.0 => {
                        bounds.low[axis] = below(half.point[axis] - slack);
                    }
                    _ => {}
                }
            }
            bounds
        }
    }
}

/// The largest single that is at most this.
pub(crate) fn below(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value {
        near.next_down()
    } else {
        near
    }
}

/// The smallest single that is at least this.
pub(crate) fn above(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) < value { near.next_up() } else { near }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, DVec3, above, below};

    #[test]
    fn sides_are_rounded_outwards() {
        for value in [0.1, -0.1, 1e-300, -1e-300, 1e300, -1e300, 0.0, 3.0] {
            assert!(
                f64::from(below(value)) <= value && value <= f64::from(above(value)),
                "{value}"
            );
        }
    }

    #[test]
    fn boxes_hold_meet_and_part() {
        let cube = |at: f64, size: f64| Bounds::new(DVec3::splat(at - size), DVec3::splat(at + size));
        assert!(cube(0.0, 2.0).holds(&cube(0.5, 1.5)));
        assert!(!cube(0.0, 2.0).holds(&cube(0.5, 1.6)));
        assert!(cube(0.0, 1.0).apart(&cube(2.5, 1.0)).is_some());
        assert!(cube(0.0, 1.0).apart(&cube(2.0, 1.0)).is_none());
        assert_eq!(cube(0.0, 1.0).common(cube(1.0, 1.0)), cube(0.5, 0.5));
        assert!(cube(0.0, 1.0).grown().holds(&cube(0.0, 1.0)));
        assert!(!Bounds::EVERYWHERE.is_finite());
    }
}
