//! Where a ray crosses the surface of one island: the next distance at which the island's truth changes.

use scenec_plan::packed_structs::Island;
use scenec_plan::{Instruction, Packed, Real, evaluate};

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

    /// Whether the island holds the ray at `distance`: each member counts from its first distance up to, not including,
    /// its last.
    #[inline(always)]
    fn holds(&self, distance: R) -> bool {
        self.truth(distance, u32::MAX)
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
                return Some(self.owner(at, now));
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
        for (local, &(enter, leave)) in self.intervals.iter().enumerate() {
            let leaf = self.scene.members[self.island.members as usize + local];
            if enter < leave && class_of(self.scene, leaf) != self.class {
                for distance in [enter, leave] {
                    if distance <= from && distance > before {
                        before = distance;
                    }
                }
            }
        }
        (from - before < end - from).then(|| Hit {
            distance: from,
            ..self.owner(before, self.holds(before))
        })
    }

    /// Of the members that change at a distance where the island does, the leftmost whose change matters by itself;
    /// where none does (they change together), the leftmost.
    #[inline(always)]
    fn owner(&self, distance: R, now: bool) -> Hit<R> {
        let mut found = None;
        for (local, &(enter, leave)) in self.intervals.iter().enumerate() {
            if enter < leave && (enter == distance || leave == distance) {
                let leaf = self.scene.members[self.island.members as usize + local];
                let hit = Hit {
                    distance,
                    leaf,
                    leaving: leave == distance,
                };
                if found.is_none() {
                    found = Some(hit);
                }
                if self.truth(distance, local as u32) != now {
                    found = Some(hit);
                    break;
                }
            }
        }
        // A change happens at some member's end, so one was found.
        found.unwrap_or(Hit {
            distance,
            leaf: self.scene.members[self.island.members as usize],
            leaving: false,
        })
    }

    /// The island's truth at a distance with one member's truth turned over; no member has the number `u32::MAX`.
    #[inline(always)]
    fn truth(&self, distance: R, turned: u32) -> bool {
        let holds = |local: u32| {
            let (enter, leave) = self.intervals[local as usize];
            (enter <= distance && distance < leave) != (local == turned)
        };
        let program = &self.scene.program[self.island.program as usize..self.island.program_end as usize];
        evaluate(program.iter().map(|word| Instruction(*word)), holds)
    }
}
