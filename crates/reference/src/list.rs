//! What a straight line sees of a solid: where it goes in and out, from one end of the line to the other.

use scenec_scene::{DVec3, MaterialId, Op, SolidId};

/// A point on a leaf's surface, from which a further line may start.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Spot {
    /// Which surface it is on: leaves of one family have the same.
    pub(crate) family: u32,
    /// Where on it, in the surface's own coordinates.
    pub(crate) place: DVec3,
    /// The same in world units.
    pub(crate) point: DVec3,
}

/// A place where a line crosses the surface of a solid.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Edge {
    /// How far along the line, in lengths of its direction.
    pub(crate) t: f64,
    /// The leaf whose surface it is.
    pub(crate) leaf: SolidId,
    /// What the surface is made of.
    pub(crate) material: MaterialId,
    /// Unit, out of the solid that the list is of: a subtracted leaf has its own reversed.
    pub(crate) normal: DVec3,
    /// Where it is.
    pub(crate) spot: Spot,
}

/// The crossings of one line with one solid. Each is at another `t` than the one before, so the line is in the solid
/// after every second of them and no interval has length 0.
#[derive(Clone, PartialEq, Debug, Default)]
pub(crate) struct List {
    /// Whether the line comes out of the solid from its far end at t = -infinity.
    pub(crate) before: bool,
    /// In the order of `t`.
    pub(crate) edges: Vec<Edge>,
    /// The last crossing not ahead of t = 0 with any leaf inside, other than those that have the surface that the line
    /// starts on; also where it does not show.
    pub(crate) behind: Option<Edge>,
}

/// What a ray meets.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Hit {
    /// Where.
    pub(crate) edge: Edge,
    /// Whether the ray goes from the outside of the solid to its inside there.
    pub(crate) entering: bool,
}

impl List {
    /// What a ray from t = 0 that is on this side of the surface (inside or not) meets; `None` takes the side that
    /// the line is on.
    ///
    /// Where the line is on the other side just after its start, a second surface passes the start within rounding. Of
    /// its crossings the one that is nearer to the start is really there: the one behind means that the ray runs into the
    /// second surface and is stopped at once, ahead that it comes away from it and goes on.
    pub(crate) fn first(&self, side: Option<bool>) -> Option<Hit> {
        let ahead = self.edges.partition_point(|edge| edge.t <= 0.0);
        let mut inside = self.before != (ahead % 2 == 1);
        let mut rest = &self.edges[ahead..];
        if side.is_some_and(|side| side != inside) {
            let end = rest.first().map_or(f64::INFINITY, |edge| edge.t);
            if let Some(edge) = self.behind.filter(|edge| -edge.t < end) {
                let edge = Edge { t: 0.0, ..edge };
                return Some(Hit { edge, entering: inside });
            }
            inside = !inside;
            rest = rest.get(1..).unwrap_or_default();
        }
        let entering = !inside;
        rest.first().map(|&edge| Hit { edge, entering })
    }

    /// The same crossings of a solid made of one material.
    pub(crate) fn painted(mut self, material: MaterialId) -> Self {
        for edge in self.edges.iter_mut().chain(&mut self.behind) {
            edge.material = material;
        }
        self
    }

    /// The list of the combination of two solids.
    ///
    /// A solid holds the points from the one crossing up to, not including, the next. All crossings at the same `t` are
    /// applied before membership is asked for, so what has no length does not show. A crossing of both is the left
    /// one's.
    pub(crate) fn combine(op: Op, left: &Self, right: &Self) -> Self {
        let (mut in_left, mut in_right) = (left.before, right.before);
        let mut inside = member(op, in_left, in_right);
        // A subtracted solid's surface shows from its other side.
        let turned = |edge: &Edge| Edge {
            normal: if op == Op::Subtraction {
                -edge.normal
            } else {
                edge.normal
            },
            ..*edge
        };
        let behind = right.behind.as_ref().map(turned);
        let mut combined = Self {
            before: inside,
            edges: Vec::new(),
            behind: match (left.behind, behind) {
                (Some(a), Some(b)) => Some(if b.t > a.t { b } else { a }),
                (a, b) => a.or(b),
            },
        };
        let (mut from_left, mut from_right) = (left.edges.iter().peekable(), right.edges.iter().peekable());
        loop {
            let t = match (from_left.peek(), from_right.peek()) {
                (None, None) => return combined,
                (Some(edge), None) | (None, Some(edge)) => edge.t,
                (Some(a), Some(b)) => a.t.min(b.t),
            };
            let a = from_left.next_if(|edge| edge.t == t);
            let b = from_right.next_if(|edge| edge.t == t);
            in_left ^= a.is_some();
            in_right ^= b.is_some();
            let now = member(op, in_left, in_right);
            if now != inside {
                inside = now;
                combined.edges.extend(a.copied().or_else(|| b.map(turned)));
            }
        }
    }
}

fn member(op: Op, in_left: bool, in_right: bool) -> bool {
    match op {
        Op::Union => in_left || in_right,
        Op::Intersection => in_left && in_right,
        Op::Subtraction => in_left && !in_right,
    }
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DVec3, MaterialId, Op, SolidId};

    use super::{Edge, List, Spot};

    const LEFT: u32 = 1;
    const RIGHT: u32 = 2;

    fn list(leaf: u32, before: bool, ts: &[f64]) -> List {
        let spot = Spot {
            family: leaf,
            place: DVec3::ZERO,
            point: DVec3::ZERO,
        };
        let edge = |&t| Edge {
            t,
            leaf: SolidId(leaf),
            material: MaterialId(leaf),
            normal: DVec3::X,
            spot,
        };
        List {
            before,
            edges: ts.iter().map(edge).collect(),
            behind: None,
        }
    }

    type Ends<'a> = (bool, &'a [f64]);

    /// The combination begins as said and has these crossings: where, and of whom (negative where reversed).
    fn check(op: Op, left: Ends<'_>, right: Ends<'_>, before: bool, expect: &[(f64, i32)]) {
        let combined = List::combine(op, &list(LEFT, left.0, left.1), &list(RIGHT, right.0, right.1));
        let of_whom = |edge: &Edge| (edge.t, edge.leaf.0 as i32 * edge.normal.x as i32);
        let edges: Vec<_> = combined.edges.iter().map(of_whom).collect();
        assert_eq!(
            (combined.before, &edges[..]),
            (before, expect),
            "{op:?} {left:?} {right:?}"
        );
    }

    #[test]
    fn lists_combine_by_membership() {
        use Op::{Intersection, Subtraction, Union};
        let (a, b): (Ends<'_>, Ends<'_>) = ((false, &[0.0, 2.0]), (false, &[1.0, 3.0]));
        check(Union, a, b, false, &[(0.0, 1), (3.0, 2)]);
        check(Intersection, a, b, false, &[(1.0, 2), (2.0, 1)]);
        check(Subtraction, a, b, false, &[(0.0, 1), (1.0, -2)]);
        check(Subtraction, b, a, false, &[(2.0, -2), (3.0, 1)]);
        // The far exit of a union whose left part has two pieces.
        check(
            Union,
            (false, &[-1.0, 1.0, 3.0, 5.0]),
            (false, &[-1.0, 4.0]),
            false,
            &[(-1.0, 1), (5.0, 1)],
        );
        // Half-spaces reach to the ends of the line.
        check(
            Intersection,
            (true, &[1.0]),
            (false, &[0.0]),
            false,
            &[(0.0, 2), (1.0, 1)],
        );
        check(Subtraction, (true, &[]), a, true, &[(0.0, -2), (2.0, -2)]);
        check(Union, (true, &[0.0]), (false, &[0.0]), true, &[]);
    }

    #[test]
    fn coincident_crossings_are_one() {
        use Op::{Intersection, Subtraction, Union};
        let (a, low, high): (Ends<'_>, Ends<'_>, Ends<'_>) =
            ((false, &[0.0, 2.0]), (false, &[0.0, 1.0]), (false, &[1.0, 2.0]));
        check(Subtraction, a, a, false, &[]);
        check(Union, a, a, false, &[(0.0, 1), (2.0, 1)]);
        check(Intersection, a, a, false, &[(0.0, 1), (2.0, 1)]);
        check(Union, low, high, false, &[(0.0, 1), (2.0, 2)]);
        check(Intersection, low, high, false, &[]);
        check(Subtraction, low, high, false, &[(0.0, 1), (1.0, 1)]);
        check(Subtraction, a, high, false, &[(0.0, 1), (1.0, -2)]);
        check(Union, high, a, false, &[(0.0, 2), (2.0, 1)]);
    }

    #[test]
    fn a_ray_meets_the_first_crossing_from_its_own_side() {
        let solid = list(LEFT, false, &[-1.0, 0.0, 2.0, 3.0]);
        let first = |side| solid.first(side).map(|hit| (hit.edge.t, hit.entering));
        assert_eq!(first(None), Some((2.0, true)));
        assert_eq!(first(Some(false)), Some((2.0, true)));
        assert_eq!(first(Some(true)), Some((3.0, false)));
        assert_eq!(list(LEFT, true, &[0.0]).first(None), None);
    }

    #[test]
    fn a_ray_is_stopped_in_a_crease_and_comes_out_of_one() {
        let first = |ends: &[f64], behind: usize| {
            let mut solid = list(LEFT, false, ends);
            solid.behind = solid.edges.get(behind).copied();
            let hit = solid.first(Some(false));
            hit.map(|hit| (hit.edge.t, hit.entering))
        };
        assert_eq!(first(&[-1e-16, 5.0], 0), Some((0.0, true)));
        assert_eq!(first(&[-5.0, 1e-16], 0), None);
        assert_eq!(first(&[-5.0, 1e-16, 7.0, 8.0], 0), Some((7.0, true)));
    }
}
