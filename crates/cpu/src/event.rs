//! Where a ray crosses the surface of one island: the next distance at which the island's truth changes.

use scenec_plan::packed_structs::Island;
use scenec_plan::{Instruction, Packed, Real, evaluate, owner};

use crate::ray::Ray;
use crate::shape::{Interval, interval};

/// A crossing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit<R> {
    /// Along the ray.
    pub(crate) distance: R,
    /// The leaf that owns the surface there.
    pub(crate) leaf: u32,
    /// Whether the ray leaves that leaf (not: the solid).
    pub(crate) leaving: bool,
}

/// The first entry into an island after the start of a ray from outside, and not after `until`.
#[inline(always)]
pub(crate) fn entered<R: Real>(
    scene: &Packed<R>,
    island: &Island,
    ray: &Ray<R>,
    until: R,
    intervals: &mut Vec<Interval<R>>,
) -> Option<Hit<R>> {
    let Some(leaf) = lone(scene, island) else {
        return Crossings::new(scene, island, ray, intervals).change(R::ZERO, until, false);
    };
    let (enter, leave) = leaf_interval(scene, leaf, ray);
    if enter <= R::ZERO {
        // A ray from outside that starts within, by rounding: see `crease`.
        let blocked = R::ZERO < leave && -enter < leave && ray.class != class_of(scene, leaf);
        return blocked.then_some(Hit {
            distance: R::ZERO,
            leaf,
            leaving: false,
        });
    }
    (enter < leave && enter <= until).then_some(Hit {
        distance: enter,
        leaf,
        leaving: false,
    })
}

/// Where a ray leaves an island that holds it at `from`, perhaps infinitely far; nothing if the island does not.
#[inline(always)]
pub(crate) fn left<R: Real>(
    scene: &Packed<R>,
    island: &Island,
    ray: &Ray<R>,
    from: R,
    intervals: &mut Vec<Interval<R>>,
) -> Option<Hit<R>> {
    let endless = |leaf: u32| Hit {
        distance: R::INFINITY,
        leaf,
        leaving: true,
    };
    if let Some(leaf) = lone(scene, island) {
        let (enter, leave) = leaf_interval(scene, leaf, ray);
        return (enter <= from && from < leave).then_some(Hit {
            distance: leave,
            ..endless(leaf)
        });
    }
    let crossings = Crossings::new(scene, island, ray, intervals);
    let first = scene.members[island.members as usize];
    crossings
        .holds(from)
        .then(|| crossings.change(from, R::INFINITY, true).unwrap_or(endless(first)))
}

/// The leaf of an island that is nothing else, as most islands are.
#[inline(always)]
fn lone<R>(scene: &Packed<R>, island: &Island) -> Option<u32> {
    (island.program_end - island.program == 1).then(|| scene.members[island.members as usize])
}

#[inline(always)]
fn class_of<R>(scene: &Packed<R>, leaf: u32) -> u32 {
    scene.shapes[scene.leaves[leaf as usize].shape as usize].class
}

#[inline(always)]
fn leaf_interval<R: Real>(scene: &Packed<R>, leaf: u32, ray: &Ray<R>) -> Interval<R> {
    let touches = &scene.touches[ray.end.touches as usize..ray.end.touches_end as usize];
    interval(&scene.shapes[scene.leaves[leaf as usize].shape as usize], ray, touches)
}

/// The intervals of one island's members along one ray.
struct Crossings<'a, R> {
    scene: &'a Packed<R>,
    island: &'a Island,
    intervals: &'a [Interval<R>],
    /// The class of the surface that the ray starts on.
    class: u32,
}

impl<'a, R: Real> Crossings<'a, R> {
    #[inline(always)]
    fn new(scene: &'a Packed<R>, island: &'a Island, ray: &Ray<R>, intervals: &'a mut Vec<Interval<R>>) -> Self {
        let members = &scene.members[island.members as usize..island.members_end as usize];
        intervals.clear();
        intervals.extend(members.iter().map(|leaf| leaf_interval(scene, *leaf, ray)));
        Self {
            scene,
            island,
            intervals,
            class: ray.class,
        }
    }

    /// The first change after `from` and not after `until`, of a ray that is inside (or not) to begin with.
    #[inline(always)]
    fn change(&self, from: R, until: R, inside: bool) -> Option<Hit<R>> {
        let mut at = from;
        let mut settled = self.holds(at) == inside;
        loop {
            let mut next = R::INFINITY;
            for &(enter, leave) in self.intervals {
                if enter < leave {
                    if enter > at && enter < next {
                        next = enter;
                    }
                    if leave > at && leave < next {
                        next = leave;
                    }
                }
            }
            if next > until || next == R::INFINITY {
                return if settled { None } else { self.crease(from, next) };
            }
            at = next;
            let now = self.holds(at);
            if settled && now != inside {
                return Some(self.owner(at));
            }
            if !settled && now == inside {
                if let Some(hit) = self.crease(from, at) {
                    return Some(hit);
                }
                settled = true;
            }
        }
    }

    /// A ray that is on the wrong side of the surface at its start, until `end`, starts within rounding of another
    /// surface than its own. It crosses that surface at the start if the crossing behind it is the nearer one: then it
    /// runs into a crease and is stopped there. If the crossing ahead is nearer, it leaves the crease and goes on.
    #[inline(always)]
    fn crease(&self, from: R, end: R) -> Option<Hit<R>> {
        let mut before = -R::INFINITY;
        for (local, &(enter, leave)) in (0..).zip(self.intervals) {
            if enter < leave && class_of(self.scene, self.leaf(local)) != self.class {
                for distance in [enter, leave] {
                    if distance <= from && distance > before {
                        before = distance;
                    }
                }
            }
        }
        let stopped = from - before < end - from;
        stopped
            .then(|| self.leftmost(before))
            .flatten()
            .map(|hit| Hit { distance: from, ..hit })
    }

    /// The crossing of a distance where the island changes: of operands that change together, the left one owns it.
    #[inline(always)]
    fn owner(&self, distance: R) -> Hit<R> {
        let local = owner(self.program(), |local| {
            let (enter, leave) = self.intervals[local as usize];
            (
                enter < distance && distance <= leave,
                enter <= distance && distance < leave,
            )
        });
        self.hit(local, distance)
    }

    /// The leftmost member of another class than the ray's start that has an end at a distance.
    #[inline(always)]
    fn leftmost(&self, distance: R) -> Option<Hit<R>> {
        let ends =
            |(_, (enter, leave)): &(u32, &Interval<R>)| enter < leave && (*enter == distance || *leave == distance);
        let mut ending = (0..).zip(self.intervals).filter(ends);
        let other = ending.find(|(local, _)| class_of(self.scene, self.leaf(*local)) != self.class);
        other.map(|(local, _)| self.hit(local, distance))
    }

    /// An end of a member.
    #[inline(always)]
    fn hit(&self, local: u32, distance: R) -> Hit<R> {
        Hit {
            distance,
            leaf: self.leaf(local),
            leaving: self.intervals[local as usize].1 == distance,
        }
    }

    #[inline(always)]
    fn leaf(&self, local: u32) -> u32 {
        self.scene.members[(self.island.members + local) as usize]
    }

    #[inline(always)]
    fn program(&self) -> impl Iterator<Item = Instruction> + '_ {
        let words = &self.scene.program[self.island.program as usize..self.island.program_end as usize];
        words.iter().map(|word| Instruction(*word))
    }

    /// Whether the island holds the ray at `distance`: each member counts from its first distance up to, not including,
    /// its last.
    #[inline(always)]
    fn holds(&self, distance: R) -> bool {
        evaluate(self.program(), |local| {
            let (enter, leave) = self.intervals[local as usize];
            enter <= distance && distance < leave
        })
    }
}
