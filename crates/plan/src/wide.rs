//! The hierarchy as processors read it: eight children to a node and eight balls to a leaf, each tested together.
//!
//! It is made from the plan's hierarchy of pairs, which GPUs read, by taking those of a node's descendants in that make it cheapest.

mod build;
mod forest;

use crate::packed::packed_structs::{Block, Shape, WideNode};
use crate::{Real, ShapeKind};

/// How many boxes or balls stand together.
pub const LANES: usize = 8;

impl<R: Real> Block<R> {
    /// One of the balls as a surface.
    #[must_use]
    #[inline(always)]
    pub fn shape(&self, lane: usize) -> Shape<R> {
        let diagonal = |x| [x, R::ZERO, R::ZERO, R::ZERO, x, R::ZERO, R::ZERO, R::ZERO, x];
        Shape {
            centre: [self.centre[0][lane], self.centre[1][lane], self.centre[2][lane]],
            inverse: diagonal(self.inverse[lane]),
            linear: diagonal(self.radius[lane]),
            kind: ShapeKind::Ball.number(),
            class: self.class[lane],
        }
    }

    const EMPTY: Self = Self {
        centre: [[R::ZERO; LANES]; 3],
        reach: [R::ZERO; LANES],
        inverse: [R::ZERO; LANES],
        radius: [R::ZERO; LANES],
        leaf: [u32::MAX; LANES],
        class: [u32::MAX; LANES],
        material: [u32::MAX; LANES],
        there: 0,
        unused: [0; 7],
    };
}

/// Where a child is, in one word: what it is in the two upper bits, its number below.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[repr(transparent)]
pub struct Child(pub(crate) u32);

/// What a child is.
pub enum Kind {
    /// A node, by its number.
    Node(usize),
    /// A block, by its number.
    Block(usize),
    /// Some islands, by the number of their run.
    Run(usize),
}

impl Child {
    pub(crate) const SHIFT: u32 = 30;
    pub(crate) const NODE: u32 = 0;
    pub(crate) const BLOCK: u32 = 1;
    pub(crate) const RUN: u32 = 2;
    /// Nothing.
    pub const NONE: Self = Self(u32::MAX);

    const fn new(kind: u32, index: usize) -> Self {
        Self(kind << Self::SHIFT | index as u32)
    }

    /// What it is, and its number.
    #[inline(always)]
    #[must_use]
    pub const fn kind(self) -> Kind {
        let index = (self.0 & ((1 << Self::SHIFT) - 1)) as usize;
        match self.0 >> Self::SHIFT {
            Self::NODE => Kind::Node(index),
            Self::BLOCK => Kind::Block(index),
            _ => Kind::Run(index),
        }
    }
}

/// The islands of a plan, arranged.
#[derive(Clone, Debug)]
pub struct Wide<R> {
    /// Nodes.
    pub nodes: Vec<WideNode>,
    /// Blocks.
    pub blocks: Vec<Block<R>>,
    /// First and one past the last of some islands that are not all balls.
    pub runs: Vec<[u32; 2]>,
    /// What every ray has to try: the islands outside the hierarchy, and last its root.
    pub start: Vec<Child>,
    /// How many of these are outside the hierarchy.
    pub outside: usize,
}

#[cfg(test)]
mod tests {
    use super::{Kind, Wide};
    use crate::packed::packed_structs::{Frame, Island, Leaf, Node, Shape};
    use crate::{Packed, Real};

    /// Islands in a row, balls but for every seventh, under a hierarchy that halves the row.
    fn packed<R: Real>(count: u32) -> Packed<R> {
        let shape = |i: u32| Shape {
            kind: u32::from(i % 7 == 3),
            class: i,
            ..Shape::default()
        };
        let (mut nodes, mut open) = (vec![Node::default()], vec![(0_usize, 0, count)]);
        while let Some((at, start, end)) = open.pop() {
            let half = start + (end - start) / 2;
            let (low, high) = ([start as f32, 0.0, 0.0], [end as f32, 1.0, 1.0]);
            let (first, many) = if end - start <= 4 {
                (start, end - start)
            } else {
                (nodes.len() as u32, 0)
            };
            if many == 0 {
                open.extend([(nodes.len(), start, half), (nodes.len() + 1, half, end)]);
                nodes.extend([Node::default(); 2]);
            }
            nodes[at] = Node {
                low,
                high,
                first,
                count: many,
            };
        }
        Packed {
            frame: Frame::default(),
            shapes: (0..count).map(shape).collect(),
            leaves: (0..count)
                .map(|shape| Leaf {
                    shape,
                    material: 0,
                    solid: shape,
                })
                .collect(),
            islands: (0..count)
                .map(|i| Island {
                    program: i,
                    program_end: i + 1,
                    members: i,
                    members_end: i + 1,
                    product: 1,
                    cells: u32::MAX,
                })
                .collect(),
            cells: vec![],
            program: vec![0; count as usize],
            members: (0..count).collect(),
            nodes,
            materials: vec![],
            lights: vec![],
            touches: vec![],
            samples: vec![],
            reach: vec![],
        }
    }

    fn check(count: u32) {
        let wide = Wide::new(&packed::<f32>(count));
        let mut seen = vec![0; count as usize];
        let mut open: Vec<_> = wide.start.iter().map(|child| (*child, [0.0, count as f32])).collect();
        while let Some((child, [low, high])) = open.pop() {
            let mut see = |leaf: u32| {
                seen[leaf as usize] += 1;
                assert!(low <= leaf as f32 && leaf as f32 <= high, "{leaf} is not in its box");
            };
            match child.kind() {
                Kind::Node(index) => {
                    let [lows, highs] = &wide.nodes[index].bounds;
                    let there = (0..8).filter(|slot| lows[0][*slot] <= highs[0][*slot]);
                    open.extend(there.map(|slot| (wide.nodes[index].children[slot], [lows[0][slot], highs[0][slot]])));
                }
                Kind::Block(index) => {
                    wide.blocks[index]
                        .leaf
                        .into_iter()
                        .filter(|leaf| *leaf != u32::MAX)
                        .for_each(&mut see);
                }
                Kind::Run(index) => (wide.runs[index][0]..wide.runs[index][1]).for_each(&mut see),
            }
        }
        assert!(seen.iter().all(|times| *times == 1), "{count}: {seen:?}");
    }

    #[test]
    fn every_island_is_somewhere_once() {
        for count in [9, 10, 57, 1000] {
            check(count);
        }
    }
}
