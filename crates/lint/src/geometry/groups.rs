//! Unions of many: which members of one are in it for nothing.

use std::panic::resume_unwind;
use std::thread::{self, ScopedJoinHandle};

use scenec_scene::{MaterialId, Op, Scene, SolidId, SolidKind};

use super::bounds::Bounds;
use super::proof::Proof;
use super::relation::Prover;
use super::tree::Tree;

/// The most pairs that are looked at of members and members without bounds.
const MOST_PAIRS: usize = 4_000_000;

/// How many nodes of the tree may be looked at for each member, on average.
const STEPS_PER_MEMBER: u64 = 64;

/// From so many bounded members on, starting threads costs less than they save; in how many parts the members then take their
/// turns, whatever the number of threads, so that every machine finds the same.
const MANY: usize = 1 << 14;
const PARTS: usize = 8;

/// A solid that is united with others, itself no union.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    pub(crate) solid: SolidId,
    /// The union that takes it.
    pub(crate) taker: SolidId,
    /// The material that all of it is made of, where a paint says so.
    pub(crate) paint: Option<MaterialId>,
}

/// A member that adds nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Covered {
    pub(crate) inner: Member,
    pub(crate) outer: Member,
    /// Why it lies inside; `None` where the two are the same solid.
    pub(crate) proof: Option<Proof>,
}

/// All that is united, however deep the unions are nested.
pub(super) struct Group {
    pub(super) members: Vec<Member>,
    /// Members without bounds, by their place in the list.
    pub(super) unbounded: Vec<u32>,
    /// The others.
    pub(super) tree: Tree,
}

/// Finds the groups of a scene. Each union belongs to one group alone, so that a union that many others share is taken
/// apart once and not time and again.
pub(super) struct Groups<'a> {
    scene: &'a Scene,
    /// For each solid the last group that met it, from 1.
    met: Vec<u32>,
    count: u32,
}

impl<'a> Groups<'a> {
    pub(super) fn new(scene: &'a Scene) -> Self {
        Self {
            scene,
            met: vec![0; scene.solids.len()],
            count: 0,
        }
    }

    /// Goes through the groups of all that is reached, the submitted solid's first; each comes with the solids that it takes
    /// more than once.
    pub(super) fn each(mut self, reached: &[bool], mut visit: impl FnMut(Vec<Member>, Vec<Covered>)) {
        let scene = self.scene;
        let (members, repeated) = self.gather(scene.root);
        visit(members, repeated);
        for index in (0..scene.solids.len()).rev() {
            let id = SolidId(index as u32);
            let fresh = self.is_union(id) && self.met.get(index) == Some(&0);
            if fresh && reached.get(index) == Some(&true) {
                let (members, repeated) = self.gather(id);
                visit(members, repeated);
            }
        }
    }

    fn is_union(&self, id: SolidId) -> bool {
        matches!(self.scene.solid(id).kind, SolidKind::Combine { op: Op::Union, .. })
    }

    /// The members of the group at the top of which a solid stands, from left to right.
    fn gather(&mut self, top: SolidId) -> (Vec<Member>, Vec<Covered>) {
        self.count += 1;
        let (mut members, mut repeated) = (Vec::new(), Vec::new());
        let mut open = vec![Member {
            solid: top,
            taker: top,
            paint: None,
        }];
        while let Some(mut next) = open.pop() {
            while let SolidKind::Paint { inside, material } = self.scene.solid(next.solid).kind {
                next.paint = next.paint.or(Some(material));
                next.solid = inside;
            }
            let Some(met) = self.met.get_mut(next.solid.index()) else {
                continue;
            };
            let before = std::mem::replace(met, self.count);
            if before == self.count {
                repeated.push(Covered {
                    inner: next,
                    outer: next,
                    proof: None,
                });
                continue;
            }
            match self.scene.solid(next.solid).kind {
                SolidKind::Combine {
                    op: Op::Union,
                    left,
                    right,
                } if before == 0 => {
                    let taken = |solid| Member {
                        solid,
                        taker: next.solid,
                        ..next
                    };
                    open.extend([taken(right), taken(left)]);
                }
                _ => members.push(next),
            }
        }
        (members, repeated)
    }
}

impl Group {
    pub(super) fn new(members: Vec<Member>, bounds: &[Bounds]) -> Self {
        let (mut unbounded, mut boxes) = (Vec::new(), Vec::new());
        for (number, member) in (0..).zip(&members) {
            match bounds.get(member.solid.index()) {
                Some(bounds) if bounds.is_finite() => boxes.push((number, *bounds)),
                _ => unbounded.push(number),
            }
        }
        Self {
            members,
            unbounded,
            tree: Tree::new(boxes),
        }
    }

    /// The member at a place in the list.
    pub(super) fn member(&self, number: u32) -> Option<Member> {
        self.members.get(number as usize).copied()
    }

    /// The members that lie inside another one, or are the same as an earlier one; `skip` tells which to leave alone.
    pub(super) fn covered(&self, prover: Prover<'_>, skip: impl Fn(SolidId) -> bool) -> Vec<Covered> {
        let mut cover = Cover {
            prover,
            group: self,
            done: self.members.iter().map(|member| skip(member.solid)).collect(),
            found: Vec::new(),
        };
        if self.members.len() > 1 {
            cover.by_unbounded();
            cover.by_bounded();
        }
        let covered = |found: Found| {
            Some(Covered {
                inner: self.member(found.inner)?,
                outer: self.member(found.outer)?,
                proof: found.proof,
            })
        };
        cover.found.into_iter().filter_map(covered).collect()
    }
}

/// A search for covered members.
struct Cover<'a> {
    prover: Prover<'a>,
    group: &'a Group,
    /// Which members need no more looking at.
    done: Vec<bool>,
    found: Vec<Found>,
}

/// A [`Covered`] by the members' places in the list.
struct Found {
    inner: u32,
    outer: u32,
    proof: Option<Proof>,
}

impl Cover<'_> {
    fn is_done(&self, number: u32) -> bool {
        self.done.get(number as usize).copied().unwrap_or(true)
    }

    /// Every member against those without bounds, of which there are mostly few; of very many, only the first ones.
    fn by_unbounded(&mut self) {
        let count = self.group.members.len();
        let most = (MOST_PAIRS / count.max(1)).max(1);
        // Those without bounds come first, so that one that lies inside another is not what the rest is said to lie in.
        for number in self.group.unbounded.iter().copied().chain(0..count as u32) {
            for other in self.group.unbounded.iter().take(most) {
                self.compare(number, *other);
            }
        }
    }

    /// Every bounded member, the larger ones first, against those whose boxes lie in its own. What lies inside another one
    /// needs no turn of its own: what it covers the other one covers too. Members of about one size take their turns in
    /// the order of the tree, so that one search finds in the cache what the last one has read.
    fn by_bounded(&mut self) {
        let group = self.group;
        // An eighth of an octave: the exponent and the three highest bits after it.
        let class = |bounds: &Bounds| bounds.size().to_bits() >> 20;
        let mut order: Vec<(u32, u32)> = (0..)
            .zip(group.tree.items())
            .map(|(at, (_, bounds))| (u32::MAX - class(bounds), at))
            .collect();
        order.sort_unstable();
        if order.len() < MANY {
            return self.take_turns(&order);
        }
        // Each part knows what it found itself; what an earlier one found besides makes a later one look for nothing, no more.
        let parts: Vec<_> = thread::scope(|scope| {
            let part = |turns| {
                let mut part = Cover {
                    done: self.done.clone(),
                    found: Vec::new(),
                    ..*self
                };
                scope.spawn(move || {
                    part.take_turns(turns);
                    part.found
                })
            };
            let parts: Vec<_> = order.chunks(order.len().div_ceil(PARTS)).map(part).collect();
            let joined = parts.into_iter().map(ScopedJoinHandle::join);
            joined
                .map(|part| part.unwrap_or_else(|panic| resume_unwind(panic)))
                .collect()
        });
        parts.into_iter().flatten().for_each(|found| self.note(found));
    }

    /// Takes members, by their place in the tree, against those whose boxes lie in their own.
    fn take_turns(&mut self, turns: &[(u32, u32)]) {
        let tree = &self.group.tree;
        let mut steps = STEPS_PER_MEMBER * (turns.len() as u64 + 1024);
        let mut near = Vec::new();
        for (_, at) in turns {
            let Some((outer, bounds)) = tree.items().get(*at as usize) else {
                continue;
            };
            if self.is_done(*outer) {
                continue;
            }
            near.clear();
            tree.lying_in(&bounds.grown(), &mut steps, |number| near.push(number));
            for inner in &near {
                self.compare(*inner, *outer);
            }
        }
    }

    /// Notes whether a member lies inside another one, or is the same and stands behind it.
    fn compare(&mut self, inner: u32, outer: u32) {
        if inner == outer || self.is_done(inner) || self.is_done(outer) {
            return;
        }
        let (Some(one), Some(other)) = (self.group.member(inner), self.group.member(outer)) else {
            return;
        };
        let Some(proof) = self.prover.within(one.solid, other.solid) else {
            return;
        };
        let (inner, outer) = match proof {
            None => (inner.max(outer), inner.min(outer)),
            Some(_) => (inner, outer),
        };
        self.note(Found { inner, outer, proof });
    }

    fn note(&mut self, found: Found) {
        if self.is_done(found.inner) || self.is_done(found.outer) {
            return;
        }
        if let Some(done) = self.done.get_mut(found.inner as usize) {
            *done = true;
        }
        self.found.push(found);
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use scenec_interpret::scene_of;

    use super::{MANY, PARTS};
    use crate::geometry::Geometry;

    const SETTINGS: &str = include_str!("../../../../scenes/seed.scene");

    /// Balls in a row, each seventh of which holds a small one, and a large ball around the first hundred: what lies in another one
    /// is found, and the largest is named.
    fn check(row: u32) {
        let row_of = |number: u32| (0.4, f64::from(number));
        let held = (0..row).step_by(7).map(|number| (0.1, f64::from(number)));
        let balls: Vec<_> = (0..row).map(row_of).chain(held).chain([(99.0, 0.0)]).collect();
        let mut text = SETTINGS.split_once("/ Object tree").unwrap().0.to_owned();
        text.push_str("!all := sphere\n!all += 0 500 0\n");
        for (radius, x) in &balls {
            writeln!(
                text,
                "!b := sphere\n!b *= {radius} {radius} {radius}\n!b += {x} 0 0\n!all := all | b"
            )
            .unwrap();
        }
        text.push_str("!all <=\n");
        let geometry = Geometry::of(&scene_of(&text).unwrap());
        let members = &geometry.root.members;
        let ball = |solid| members.iter().position(|member| member.solid == solid).unwrap() - 1;
        let mut found: Vec<_> = geometry
            .covered
            .iter()
            .map(|covered| (ball(covered.inner.solid), ball(covered.outer.solid)))
            .collect();
        found.sort_unstable();
        let largest = balls.len() - 1;
        let mut expect = Vec::new();
        for (number, (radius, x)) in balls.iter().enumerate() {
            if number != largest && x + radius < 99.0 {
                expect.push((number, largest));
            } else if *radius == 0.1 {
                expect.push((number, *x as usize));
            }
        }
        assert!(found == expect, "{row}: {} {}", found.len(), expect.len());
    }

    #[test]
    fn what_lies_in_another_one_is_found_in_one_part_and_in_many() {
        check(300);
        check((MANY + PARTS) as u32);
    }
}
