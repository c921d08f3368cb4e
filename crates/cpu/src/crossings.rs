//! A part of a tree along one ray: its members' intervals, and where its truth changes.

use std::ops::Range;

use scenec_plan::packed_structs::Island;
use scenec_plan::{Instruction, Packed, evaluate, evaluate_product, owner};

use crate::hits::Hit;
use crate::intervals::Intervals;
use crate::lanes::{LANES, Lanes};
use crate::shape::Interval;

/// What is known of a ray on its way through an island.
pub(crate) struct March<R> {
    from: R,
    /// How far it has been followed.
    pub(crate) at: R,
    /// Whether it is inside to begin with, ...
    inside: bool,
    /// ... and whether the island says so.
    pub(crate) held: bool,
    /// Whether it has been on the side where it is to be.
    settled: bool,
    /// The last crossing that is not ahead of the start, if it was on the other side there.
    behind: Option<Hit<R>>,
    /// Where the first crossing is that the ray has not come to.
    ahead: R,
}

impl<R: Lanes> March<R> {
    #[inline(always)]
    pub(crate) fn new(from: R, inside: bool, held: bool, behind: Option<Hit<R>>) -> Self {
        Self {
            from,
            at: from,
            inside,
            held,
            settled: held == inside,
            behind,
            ahead: R::INFINITY,
        }
    }

    /// Whether it has been on the side where it is to be.
    #[inline(always)]
    pub(crate) const fn is_settled(&self) -> bool {
        self.settled
    }

    /// What the ray meets if it comes to no change.
    #[inline(always)]
    pub(crate) fn finish(&self) -> Option<Hit<R>> {
        if self.settled { None } else { self.crease(self.ahead) }
    }

    /// A ray that is on the wrong side of the surface at its start, until `end`, starts within rounding of another
    /// surface than its own. It crosses that surface at the start if the crossing behind it is the nearer one: then it
    /// runs into a crease and is stopped there. If the crossing ahead is nearer, it leaves the crease and goes on.
    #[inline(always)]
    fn crease(&self, end: R) -> Option<Hit<R>> {
        let behind = self.behind.filter(|hit| self.from - hit.distance < end - self.from)?;
        Some(Hit {
            distance: self.from,
            ..behind
        })
    }
}

#[inline(always)]
fn class_of<R>(scene: &Packed<R>, leaf: u32) -> u32 {
    scene.shapes[scene.leaves[leaf as usize].shape as usize].class
}

/// The intervals of one part's members along one ray.
pub(crate) struct Crossings<'a, R> {
    scene: &'a Packed<R>,
    part: &'a Island,
    intervals: &'a [Intervals<R>],
    /// Which of the rays it is.
    lane: usize,
    /// The class of the surface that the ray starts on.
    class: u32,
}

impl<'a, R: Lanes> Crossings<'a, R> {
    /// Of one of the rays whose intervals are known, and the class of the surface that it starts on.
    #[inline(always)]
    pub(crate) const fn new(
        (scene, part): (&'a Packed<R>, &'a Island),
        intervals: &'a [Intervals<R>],
        (lane, class): (usize, u32),
    ) -> Self {
        Self {
            scene,
            part,
            intervals,
            lane,
            class,
        }
    }

    /// The interval of a member.
    #[inline(always)]
    fn interval(&self, local: u32) -> Interval<R> {
        let [enter, leave] = &self.intervals[local as usize];
        (enter[self.lane % LANES], leave[self.lane % LANES])
    }

    /// The numbers of the members.
    #[inline(always)]
    const fn locals(&self) -> Range<u32> {
        0..self.intervals.len() as u32
    }

    /// Sets out from a distance.
    #[inline(always)]
    pub(crate) fn start(&self, from: R, inside: bool) -> March<R> {
        let held = self.holds(from);
        let behind = if held == inside { None } else { self.behind(from) };
        March::new(from, inside, held, behind)
    }

    /// The first change that is not after `until`.
    #[inline(always)]
    pub(crate) fn follow(&self, march: &mut March<R>, until: R) -> Option<Hit<R>> {
        if self.is_product() && march.settled {
            let next = self.product_change(march.at, march.inside);
            return (next <= until && next < R::INFINITY).then(|| self.owner(next));
        }
        loop {
            let next = self.next(march.at);
            if next > until || next == R::INFINITY {
                march.ahead = next;
                return None;
            }
            march.at = next;
            let now = self.holds(next);
            if march.settled && now != march.inside {
                return Some(self.owner(next));
            }
            if !march.settled && now == march.inside {
                if let Some(hit) = march.crease(next) {
                    return Some(hit);
                }
                march.settled = true;
            }
        }
    }

    /// The first end of a member after a distance.
    #[inline(always)]
    fn next(&self, at: R) -> R {
        let mut next = R::INFINITY;
        for local in self.locals() {
            let (enter, leave) = self.interval(local);
            if enter < leave {
                if enter > at && enter < next {
                    next = enter;
                }
                if leave > at && leave < next {
                    next = leave;
                }
            }
        }
        next
    }

    /// Where a product that holds `at` (or does not) stops to (or begins to) after that: all members reach from the last
    /// of their beginnings to the first of their ends, and the complements take away what they cover.
    #[inline(always)]
    fn product_change(&self, at: R, inside: bool) -> R {
        let (mut first, mut last) = (at, R::INFINITY);
        for (positive, (enter, leave)) in self.literals() {
            if !positive {
                if inside && enter < leave && enter > at {
                    last = last.min(enter);
                }
            } else if enter < leave {
                first = first.max(enter);
                last = last.min(leave);
            } else {
                return R::INFINITY;
            }
        }
        if inside {
            return last;
        }
        loop {
            let before = first;
            for (positive, (enter, leave)) in self.literals() {
                if !positive && enter <= first && first < leave {
                    first = leave;
                }
            }
            if first == before {
                break;
            }
        }
        if first < last { first } else { R::INFINITY }
    }

    /// Of a product: each member's interval, and whether it is the member itself.
    #[inline(always)]
    fn literals(&self) -> impl Iterator<Item = (bool, Interval<R>)> + '_ {
        self.program().map(|literal| {
            let (operation, member) = literal.parts();
            (operation == 0, self.interval(member))
        })
    }

    /// The last end that is not after a distance, of a member of another class than the ray's start; of several the
    /// leftmost.
    #[inline(always)]
    fn behind(&self, from: R) -> Option<Hit<R>> {
        let mut last: Option<(u32, R)> = None;
        for local in self.locals() {
            let (enter, leave) = self.interval(local);
            if enter < leave && class_of(self.scene, self.leaf(local)) != self.class {
                for distance in [enter, leave] {
                    let later = last.is_none_or(|(_, known)| distance > known);
                    if distance <= from && distance > -R::INFINITY && later {
                        last = Some((local, distance));
                    }
                }
            }
        }
        last.map(|(local, distance)| self.hit(local, distance))
    }

    /// The crossing of a distance where the part changes: of operands that change together, the left one owns it.
    #[inline(always)]
    fn owner(&self, distance: R) -> Hit<R> {
        let changes = |local: u32| {
            let (enter, leave) = self.interval(local);
            (
                enter < distance && distance <= leave,
                enter <= distance && distance < leave,
            )
        };
        let local = if self.is_product() {
            // All that change do so in the same direction.
            let mut members = self.program().map(|literal| literal.parts().1);
            let changing = |local: &u32| {
                let (before, after) = changes(*local);
                before != after
            };
            members.find(changing).unwrap_or_default()
        } else {
            owner(self.program(), changes)
        };
        self.hit(local, distance)
    }

    /// An end of a member.
    #[inline(always)]
    fn hit(&self, local: u32, distance: R) -> Hit<R> {
        Hit {
            distance,
            leaf: self.leaf(local),
            leaving: self.interval(local).1 == distance,
            ball: None,
        }
    }

    #[inline(always)]
    fn leaf(&self, local: u32) -> u32 {
        self.scene.members[(self.part.members + local) as usize]
    }

    #[inline(always)]
    fn is_product(&self) -> bool {
        self.part.product != 0
    }

    #[inline(always)]
    fn program(&self) -> impl Iterator<Item = Instruction> + '_ {
        let words = &self.scene.program[self.part.program as usize..self.part.program_end as usize];
        words.iter().map(|word| Instruction(*word))
    }

    /// Whether the part holds the ray at `distance`: each member counts from its first distance up to, not including,
    /// its last.
    #[inline(always)]
    fn holds(&self, distance: R) -> bool {
        let member = |local: u32| {
            let (enter, leave) = self.interval(local);
            enter <= distance && distance < leave
        };
        if self.is_product() {
            evaluate_product(self.program(), member)
        } else {
            evaluate(self.program(), member)
        }
    }
}
