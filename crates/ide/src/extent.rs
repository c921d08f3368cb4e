//! How far an object reaches: a box around it, of a combination too.
//!
//! The box is that of the base objects as the operators combine boxes, so a combination may fill less of it.

use std::collections::HashMap;

use scenec_interpret::DefinitionId;
use scenec_scene::DVec3;
use scenec_syntax::{Operator, Statement};

use crate::Document;
use crate::solid::{Made, Shape, Standing};
use crate::words::{figure, settled};

/// The most combinations that are looked into: an answer has to come at once.
const MOST: usize = 500;

/// A box whose sides may be infinitely far.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Extent {
    low: DVec3,
    high: DVec3,
}

impl Extent {
    /// Of the object that a definition made, as it stands. `None` if it can't be told, if nothing is left of the object, or
    /// if it takes too long to find out.
    pub(crate) fn of(document: &Document, id: DefinitionId, standing: &Standing<'_>) -> Option<Self> {
        if standing.made != Made::Combination {
            return Self::of_base(standing);
        }
        let mut known = HashMap::new();
        let mut open = vec![id];
        while let Some(top) = open.last().copied() {
            let line = document.definition_of(top)?.line;
            let (Statement::Combination { operator, .. }, _) = document.statement_at(line.start)? else {
                return None;
            };
            let [left, right] = document.facts().operands(top)?;
            let sides = [left?, right?].map(|side| Self::operand(document, side, line.start, &known));
            match sides {
                [Side::Known(left), Side::Known(right)] => {
                    known.insert(top, left.joined(*operator, right)?);
                    open.pop();
                }
                [Side::Unknown, _] | [_, Side::Unknown] => return None,
                [Side::Open(id), _] | [_, Side::Open(id)] => open.push(id),
            }
            if known.len() + open.len() > MOST {
                return None;
            }
        }
        known.get(&id).copied()
    }

    fn operand(document: &Document, id: DefinitionId, before: u32, known: &HashMap<DefinitionId, Self>) -> Side {
        if let Some(extent) = known.get(&id) {
            return Side::Known(*extent);
        }
        match Standing::of(document, id, before) {
            Some(standing) if standing.made == Made::Combination => Side::Open(id),
            Some(standing) => Self::of_base(&standing).map_or(Side::Unknown, Side::Known),
            None => Side::Unknown,
        }
    }

    fn of_base(standing: &Standing<'_>) -> Option<Self> {
        Some(match standing.shape()? {
            Shape::Ball { centre, reach } => Self {
                low: centre - reach,
                high: centre + reach,
            },
            Shape::Half { point, normal } => Self::behind(point, normal),
        })
    }

    /// The box around a half-space is all of space, unless its plane lies along two axes.
    fn behind(point: DVec3, normal: DVec3) -> Self {
        let (mut low, mut high) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        let normal = settled(normal, 1.0);
        for (axis, unit) in DVec3::AXES.into_iter().enumerate() {
            if normal == unit {
                high[axis] = point[axis];
            } else if normal == -unit {
                low[axis] = point[axis];
            }
        }
        Self { low, high }
    }

    fn joined(self, operator: Operator, other: Self) -> Option<Self> {
        let joined = match operator {
            Operator::Union => Self {
                low: self.low.min(other.low),
                high: self.high.max(other.high),
            },
            Operator::Intersection => Self {
                low: self.low.max(other.low),
                high: self.high.min(other.high),
            },
            Operator::Subtraction => self,
        };
        joined.low.cmple(joined.high).all().then_some(joined)
    }

    /// The middle, where there is one.
    pub(crate) fn middle(self) -> Option<DVec3> {
        let middle = self.low + (self.high - self.low) / 2.0;
        middle.is_finite().then_some(middle)
    }

    /// Such as `x from -1 to 1, y up to 0`; `None` if it is all of space.
    pub(crate) fn words(self) -> Option<String> {
        let sizes = [self.low, self.high].map(|end| end.abs().to_array());
        let finite = sizes.into_iter().flatten().filter(|size| size.is_finite());
        let size = finite.fold(0.0, f64::max);
        let (low, high) = (settled(self.low, size), settled(self.high, size));
        let sides = ["x", "y", "z"].into_iter().enumerate().filter_map(|(axis, name)| {
            let (low, high) = (low[axis], high[axis]);
            match (low.is_finite(), high.is_finite()) {
                (true, true) => Some(format!("{name} from {} to {}", figure(low), figure(high))),
                (true, false) => Some(format!("{name} from {} on", figure(low))),
                (false, true) => Some(format!("{name} up to {}", figure(high))),
                (false, false) => None,
            }
        });
        let sides: Vec<String> = sides.collect();
        (!sides.is_empty()).then(|| sides.join(", "))
    }
}

/// What is known of an operand.
enum Side {
    Known(Extent),
    /// It is a combination that has to be looked into first.
    Open(DefinitionId),
    Unknown,
}

#[cfg(test)]
mod tests {
    use super::Extent;
    use crate::solid::Standing;
    use crate::tests::document;

    /// The extent of what is submitted.
    fn check(text: &str, words: Option<&str>, middle: Option<[f64; 3]>) {
        let document = document(text);
        let line = document.lines().iter().rfind(|line| line.span.of(text).contains("<="));
        let place = document.places_on(line.unwrap().span).first().unwrap();
        let id = place.definition.unwrap();
        let standing = Standing::of(&document, id, place.span.start).unwrap();
        let extent = Extent::of(&document, id, &standing);
        assert_eq!(extent.and_then(Extent::words).as_deref(), words, "{text}");
        let found = extent.and_then(Extent::middle).map(|middle| middle.to_array());
        assert_eq!(found, middle, "{text}");
    }

    const TWO: &str = "!a := sphere\n!b := sphere\n!b *= 2 1 1\n!b += 1 0 0\n";

    #[test]
    fn boxes_are_combined_as_the_solids_are() {
        check(
            "!a := sphere\n!a += 1 2 3\n!a <=",
            Some("x from 0 to 2, y from 1 to 3, z from 2 to 4"),
            Some([1.0, 2.0, 3.0]),
        );
        let of = |operator: &str| format!("{TWO}!u := a {operator} b\n!u <=");
        check(
            &of("|"),
            Some("x from -1 to 3, y from -1 to 1, z from -1 to 1"),
            Some([1.0, 0.0, 0.0]),
        );
        check(
            &of("&"),
            Some("x from -1 to 1, y from -1 to 1, z from -1 to 1"),
            Some([0.0, 0.0, 0.0]),
        );
        check(
            &of("-"),
            Some("x from -1 to 1, y from -1 to 1, z from -1 to 1"),
            Some([0.0, 0.0, 0.0]),
        );
        let later = "!u := a | b\n!a += 100 0 0\n!u := u | a\n!u <=";
        check(
            &format!("{TWO}{later}"),
            Some("x from -1 to 101, y from -1 to 1, z from -1 to 1"),
            Some([50.0, 0.0, 0.0]),
        );
    }

    #[test]
    fn what_has_no_end_on_a_side_says_so() {
        check("!a := hp\n!a <=", Some("y up to 0"), None);
        check("!a := hp\n!a #x= pi\n!a += 0 2 0\n!a <=", Some("y from 2 on"), None);
        check("!a := hp\n!a #x= 1\n!a <=", None, None);
        check(
            "!a := hp\n!b := sphere\n!u := b & a\n!u <=",
            Some("x from -1 to 1, y from -1 to 0, z from -1 to 1"),
            Some([0.0, -0.5, 0.0]),
        );
    }

    #[test]
    fn what_can_not_be_told_is_not() {
        check(&format!("{TWO}!a += 0 9 0\n!u := a & b\n!u <="), None, None);
        let chain = "!u := u | b\n".repeat(1000);
        check(&format!("{TWO}!u := a | b\n{chain}!u <="), None, None);
        let short = "!u := u | u\n".repeat(400);
        check(
            &format!("{TWO}!u := a | b\n{short}!u <="),
            Some("x from -1 to 3, y from -1 to 1, z from -1 to 1"),
            Some([1.0, 0.0, 0.0]),
        );
    }
}
