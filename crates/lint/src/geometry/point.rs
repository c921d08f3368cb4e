//! Which side of a solid a point is on.

use scenec_scene::{DVec3, Op, Scene, SolidId, SolidKind};

use super::relation::bare;
use super::shape::{SLACK, Shape, frobenius};

/// The most parts of a solid that are looked at, which also bounds how deep the search can go.
const MOST_STEPS: u32 = 512;

/// Where a point is, as far as that is certain.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Side {
    In,
    Out,
    /// On the surface, too near to it to tell, or in a solid of too many parts.
    Unknown,
}

/// The side of a solid that a point is on.
pub(crate) fn side(scene: &Scene, id: SolidId, point: DVec3) -> Side {
    search(scene, id, point, &mut MOST_STEPS.clone())
}

fn search(scene: &Scene, id: SolidId, point: DVec3, steps: &mut u32) -> Side {
    let Some(left) = steps.checked_sub(1) else {
        return Side::Unknown;
    };
    *steps = left;
    let solid = scene.solid(bare(scene, id));
    let SolidKind::Combine { op, left, right } = solid.kind else {
        return Shape::of(scene, solid).map_or(Side::Unknown, |shape| of_shape(&shape, point));
    };
    let first = search(scene, left, point, steps);
    let decided = match op {
        Op::Union => Side::In,
        Op::Intersection | Op::Subtraction => Side::Out,
    };
    if first == decided {
        return decided;
    }
    let second = match (op, search(scene, right, point, steps)) {
        (Op::Subtraction, Side::In) => Side::Out,
        (Op::Subtraction, Side::Out) => Side::In,
        (_, side) => side,
    };
    match (first, second) {
        (_, second) if second == decided => decided,
        (Side::Unknown, _) | (_, Side::Unknown) => Side::Unknown,
        (first, _) => first,
    }
}

fn of_shape(shape: &Shape, point: DVec3) -> Side {
    let (outside, doubt) = match shape {
        Shape::Ball(ball) => {
            let offset = point - ball.centre;
            let sizes = 1.0 + frobenius(&ball.inverse) * offset.length();
            // Where it is far outside, so is the doubt's part that grows with the distance.
            let length = (ball.inverse * offset).length();
            (length - 1.0, ball.slop * (1.0 + length) + SLACK * sizes)
        }
        Shape::Half(half) => (half.height(point), SLACK * (point - half.point).length()),
    };
    if outside > doubt {
        Side::Out
    } else if outside < -doubt {
        Side::In
    } else {
        Side::Unknown
    }
}
