//! How the wide hierarchy is made from the one of pairs.

use std::collections::VecDeque;
use std::ops::Range;

use rayon::prelude::*;

use super::forest::{Choice, choices, family};
use super::{Child, Kind, LANES, Wide};
use crate::packed::packed_structs::{Block, Island, Leaf, Node, WideNode};
use crate::together::each;
use crate::{Packed, Real, ShapeKind};

impl<R: Real> Wide<R> {
    /// The islands of a plan, in eights.
    #[must_use]
    pub fn new(packed: &Packed<R>) -> Self {
        let balls = balls(packed);
        let choices = choices(&packed.nodes, |island| balls[island] != NONE);
        let mut builder = Builder::new(packed, &balls, &choices);
        builder.outside();
        builder.wide.outside = builder.wide.start.len();
        if !packed.nodes.is_empty() {
            let root = builder.hierarchy();
            builder.wide.start.push(root);
        }
        builder.wide
    }
}

/// More balls than a block holds, or something else than balls.
pub(super) const MANY: u8 = LANES as u8 + 1;

/// From so many nodes of pairs on, starting threads costs less than they save.
const MANY_NODES: usize = 1 << 14;

/// So many parts of a large hierarchy are made at once: enough that no thread waits long for the last.
const PARTS: usize = 64;

/// No ball.
const NONE: u32 = u32::MAX;

/// The leaves of the islands that are one ball.
fn balls<R: Real>(packed: &Packed<R>) -> Vec<u32> {
    let ball = |island: &Island| {
        let leaf = packed.lone(island)?;
        (packed.shapes[packed.leaves[leaf as usize].shape as usize].kind == ShapeKind::Ball.number()).then_some(leaf)
    };
    let ball = |island: &Island| ball(island).unwrap_or(NONE);
    each(&packed.islands, packed.nodes.len() >= MANY_NODES, ball)
}

/// Which islands a leaf of the hierarchy of pairs has.
pub(super) const fn within(node: &Node) -> Range<usize> {
    node.first as usize..(node.first + node.count) as usize
}

struct Builder<'a, R> {
    packed: &'a Packed<R>,
    balls: &'a [u32],
    choices: &'a [Choice],
    wide: Wide<R>,
}

impl<'a, R: Real> Builder<'a, R> {
    const fn new(packed: &'a Packed<R>, balls: &'a [u32], choices: &'a [Choice]) -> Self {
        Self {
            packed,
            balls,
            choices,
            wide: Wide {
                nodes: Vec::new(),
                blocks: Vec::new(),
                runs: Vec::new(),
                start: Vec::new(),
                outside: 0,
            },
        }
    }

    /// The islands outside the hierarchy: the balls among them in blocks, since a block tells soonest that a ray goes past.
    fn outside(&mut self) {
        let outside = &self.balls[..self.packed.frame.linear as usize];
        let mut balls = Vec::new();
        for (index, ball) in (0..).zip(outside) {
            if *ball != NONE {
                balls.push(*ball);
                continue;
            }
            match self.wide.runs.last_mut() {
                Some([_, end]) if *end == index => *end += 1,
                _ => {
                    self.wide.start.push(Child::new(Child::RUN, self.wide.runs.len()));
                    self.wide.runs.push([index, index + 1]);
                }
            }
        }
        for balls in balls.chunks(LANES) {
            let block = self.block(balls.iter().copied());
            self.wide.start.push(block);
        }
    }

    /// The hierarchy, a node before what is in it. Of a large one the top is made first, and what hangs from it in parts.
    fn hierarchy(&mut self) -> Child {
        let root = self.child(0);
        let mut open = VecDeque::from([(root, 0)]);
        let large = self.packed.nodes.len() >= MANY_NODES;
        while let Some((place, from)) = open.pop_front() {
            self.fill(place, from, &mut open);
            if large && open.len() >= PARTS {
                break;
            }
        }
        if open.is_empty() {
            return root;
        }
        let (packed, balls, choices) = (self.packed, self.balls, self.choices);
        let part = |(place, from): (Child, u32)| {
            let mut part = Builder::new(packed, balls, choices);
            let mut open = VecDeque::from([(part.child(from), from)]);
            // The last one first, so that what stands near in space stands near in memory.
            while let Some((place, from)) = open.pop_back() {
                part.fill(place, from, &mut open);
            }
            (place, part.wide)
        };
        let parts: Vec<_> = open.into_par_iter().map(part).collect();
        let sum = |many: fn(&Wide<R>) -> usize| parts.iter().map(|(_, part)| many(part)).sum();
        self.wide.nodes.reserve_exact(sum(|part| part.nodes.len()));
        self.wide.blocks.reserve_exact(sum(|part| part.blocks.len()));
        for (place, part) in parts {
            self.adopt(place, part);
        }
        root
    }

    /// Fills in the children of a node; those that are nodes themselves are still open.
    fn fill(&mut self, place: Child, from: u32, open: &mut VecDeque<(Child, u32)>) {
        let Kind::Node(place) = place.kind() else { return };
        for (slot, from) in (0..).zip(family(&self.packed.nodes, self.choices, from)) {
            let child = self.child(from);
            self.wide.nodes[place].put(slot, &self.packed.nodes[from as usize], child);
            if let Kind::Node(_) = child.kind() {
                open.push_back((child, from));
            }
        }
    }

    /// Takes a part over. Its first node comes to the place that was kept for it, all else behind what is there.
    fn adopt(&mut self, place: Child, part: Wide<R>) {
        let Kind::Node(place) = place.kind() else { return };
        let (nodes, blocks, runs) = (self.wide.nodes.len(), self.wide.blocks.len(), self.wide.runs.len());
        let moved = |child: Child| match child.kind() {
            _ if child == Child::NONE => child,
            Kind::Node(0) => Child::new(Child::NODE, place),
            Kind::Node(index) => Child::new(Child::NODE, nodes + index - 1),
            Kind::Block(index) => Child::new(Child::BLOCK, blocks + index),
            Kind::Run(index) => Child::new(Child::RUN, runs + index),
        };
        let mut taken = part.nodes.into_iter().map(|node| WideNode {
            children: node.children.map(moved),
            ..node
        });
        if let Some(first) = taken.next() {
            self.wide.nodes[place] = first;
        }
        self.wide.nodes.extend(taken);
        self.wide.blocks.extend(part.blocks);
        self.wide.runs.extend(part.runs);
    }

    /// What a node of pairs becomes: a block, a run, or a node whose children are still to be filled in.
    fn child(&mut self, from: u32) -> Child {
        let (node, choice) = (&self.packed.nodes[from as usize], self.choices[from as usize]);
        if choice.is_closed() {
            if choice.weight < MANY {
                let balls = self.below(from);
                return self.block(balls.into_iter());
            }
            self.wide.runs.push([node.first, node.first + node.count]);
            return Child::new(Child::RUN, self.wide.runs.len() - 1);
        }
        self.wide.nodes.push(WideNode::EMPTY);
        Child::new(Child::NODE, self.wide.nodes.len() - 1)
    }

    /// The balls below a node.
    fn below(&self, from: u32) -> Vec<u32> {
        let (mut open, mut balls) = (vec![from], Vec::with_capacity(LANES));
        while let Some(index) = open.pop() {
            let node = &self.packed.nodes[index as usize];
            if node.count == 0 {
                open.extend([node.first, node.first + 1]);
            } else {
                balls.extend(&self.balls[within(node)]);
            }
        }
        balls
    }

    fn block(&mut self, balls: impl Iterator<Item = u32>) -> Child {
        let mut block = Block::EMPTY;
        for (lane, leaf) in balls.enumerate() {
            let Leaf { shape, material, .. } = self.packed.leaves[leaf as usize];
            let shape = &self.packed.shapes[shape as usize];
            for axis in 0..3 {
                block.centre[axis][lane] = shape.centre[axis];
            }
            block.inverse[lane] = shape.inverse[0];
            block.reach[lane] = reach(shape.linear[0]);
            block.radius[lane] = shape.linear[0];
            block.leaf[lane] = leaf;
            block.material[lane] = material;
            block.class[lane] = shape.class;
            block.there |= 1 << lane;
        }
        self.wide.blocks.push(block);
        Child::new(Child::BLOCK, self.wide.blocks.len() - 1)
    }
}

/// The square of a radius and a thousandth more. A square that leaves the range of normal numbers counts as endless: the
/// ball is then always tried.
fn reach<R: Real>(radius: R) -> R {
    let radius = radius.to_f64();
    let square = radius * radius * (1.0 + 1.0 / 1024.0);
    if (1e-30..1e30).contains(&square) {
        R::of(square)
    } else {
        R::INFINITY
    }
}

impl WideNode {
    const EMPTY: Self = Self {
        bounds: [[[f32::INFINITY; LANES]; 3], [[f32::NEG_INFINITY; LANES]; 3]],
        children: [Child::NONE; LANES],
        unused: [0; 8],
    };

    fn put(&mut self, slot: usize, node: &Node, child: Child) {
        for axis in 0..3 {
            self.bounds[0][axis][slot] = node.low[axis];
            self.bounds[1][axis][slot] = node.high[axis];
        }
        self.children[slot] = child;
    }
}
