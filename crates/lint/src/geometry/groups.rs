//! Unions of many: which members of one are in it for nothing.

use scenec_scene::{MaterialId, Op, Scene, SolidId, SolidKind};

use super::bounds::Bounds;
use super::proof::Proof;
use super::relation::Prover;
use super::tree::Tree;

/// The most pairs that are looked at of members and members without bounds.
const MOST_PAIRS: usize = 4_000_000;

/// How many nodes of the tree may be looked at for each member, on average.
const STEPS_PER_MEMBER: u64 = 64;

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
        cover.found
    }
}

/// A search for covered members.
struct Cover<'a> {
    prover: Prover<'a>,
    group: &'a Group,
    /// Which members need no more looking at.
    done: Vec<bool>,
    found: Vec<Covered>,
}

impl Cover<'_> {
    fn is_done(&self, number: u32) -> bool {
        self.done.get(number as usize).copied().unwrap_or(true)
    }

    fn member(&self, number: u32) -> Option<Member> {
        self.group.members.get(number as usize).copied()
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
        let mut steps = STEPS_PER_MEMBER * (order.len() as u64 + 1024);
        let mut near = Vec::new();
        for (_, at) in order {
            let Some((outer, bounds)) = group.tree.items().get(at as usize) else {
                continue;
            };
            if self.is_done(*outer) {
                continue;
            }
            near.clear();
            group
                .tree
                .lying_in(&bounds.grown(), &mut steps, |number| near.push(number));
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
        let (Some(one), Some(other)) = (self.member(inner), self.member(outer)) else {
            return;
        };
        let mut note = |number: u32, inner: Member, outer: Member, proof: Option<Proof>| {
            if let Some(done) = self.done.get_mut(number as usize) {
                *done = true;
            }
            self.found.push(Covered { inner, outer, proof });
        };
        match self.prover.within(one.solid, other.solid) {
            Some(None) if inner < outer => note(outer, other, one, None),
            Some(proof) => note(inner, one, other, proof),
            None => {}
        }
    }
}
