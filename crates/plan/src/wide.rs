//! The hierarchy as processors read it: eight children to a node and eight balls to a leaf, each tested together.
//!
//! It is made from the plan's hierarchy of pairs, which GPUs read, by taking the largest of a node's grandchildren in.

use crate::packed::packed_structs::{Block, Island, Leaf, Node, Shape, WideNode};
use crate::{Packed, Real};

/// How many boxes or balls stand together.
pub const LANES: usize = 8;

/// The number of balls among the kinds of shapes.
const BALL: u32 = 0;

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
            kind: BALL,
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
    const SHIFT: u32 = 30;
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
            0 => Kind::Node(index),
            1 => Kind::Block(index),
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

impl<R: Real> Wide<R> {
    /// The islands of a plan, in eights.
    #[must_use]
    pub fn new(packed: &Packed<R>) -> Self {
        let mut builder = Builder {
            packed,
            weights: weights(packed),
            wide: Self {
                nodes: Vec::new(),
                blocks: Vec::new(),
                runs: Vec::new(),
                start: Vec::new(),
                outside: 0,
            },
        };
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
const MANY: u8 = LANES as u8 + 1;

/// How many balls are below each node, if they fit a block.
fn weights<R: Real>(packed: &Packed<R>) -> Vec<u8> {
    let mut order = Vec::with_capacity(packed.nodes.len());
    let mut open: Vec<u32> = if packed.nodes.is_empty() { vec![] } else { vec![0] };
    while let Some(index) = open.pop() {
        order.push(index);
        let node = &packed.nodes[index as usize];
        if node.count == 0 {
            open.extend([node.first, node.first + 1]);
        }
    }
    let mut weights = vec![MANY; packed.nodes.len()];
    for index in order.into_iter().rev() {
        let node = &packed.nodes[index as usize];
        let first = node.first as usize;
        weights[index as usize] = if node.count == 0 {
            MANY.min(weights[first] + weights[first + 1])
        } else if node.count as usize <= LANES
            && islands(packed, node)
                .iter()
                .all(|island| ball(packed, island).is_some())
        {
            node.count as u8
        } else {
            MANY
        };
    }
    weights
}

fn islands<'a, R>(packed: &'a Packed<R>, node: &Node) -> &'a [Island] {
    &packed.islands[node.first as usize..(node.first + node.count) as usize]
}

/// The leaf of an island that is one ball.
fn ball<R: Real>(packed: &Packed<R>, island: &Island) -> Option<u32> {
    let leaf = packed.lone(island)?;
    (packed.shapes[packed.leaves[leaf as usize].shape as usize].kind == BALL).then_some(leaf)
}

struct Builder<'a, R> {
    packed: &'a Packed<R>,
    weights: Vec<u8>,
    wide: Wide<R>,
}

impl<R: Real> Builder<'_, R> {
    /// The islands outside the hierarchy: the balls among them in blocks, since a block tells soonest that a ray goes past.
    fn outside(&mut self) {
        let outside = &self.packed.islands[..self.packed.frame.linear as usize];
        let mut balls = Vec::new();
        for (index, island) in (0..).zip(outside) {
            if let Some(ball) = ball(self.packed, island) {
                balls.push(ball);
                continue;
            }
            match self.wide.runs.last_mut() {
                Some([_, end]) if *end == index => *end += 1,
                _ => {
                    self.wide.start.push(Child::new(2, self.wide.runs.len()));
                    self.wide.runs.push([index, index + 1]);
                }
            }
        }
        for balls in balls.chunks(LANES) {
            let block = self.block(balls.iter().copied());
            self.wide.start.push(block);
        }
    }

    /// The hierarchy from its root down, a node before what is in it.
    fn hierarchy(&mut self) -> Child {
        let root = self.child(0);
        let mut open = vec![(root, 0)];
        while let Some((place, from)) = open.pop() {
            let Kind::Node(place) = place.kind() else {
                continue;
            };
            for (slot, from) in (0..).zip(self.family(from)) {
                let child = self.child(from);
                self.wide.nodes[place].put(slot, &self.packed.nodes[from as usize], child);
                open.push((child, from));
            }
        }
        root
    }

    /// What a node of pairs becomes: a block, a run, or a node whose children are still to be filled in.
    fn child(&mut self, from: u32) -> Child {
        let node = &self.packed.nodes[from as usize];
        if self.weights[from as usize] < MANY {
            let balls = self.below(from);
            return self.block(balls.into_iter());
        }
        if node.count > 0 {
            self.wide.runs.push([node.first, node.first + node.count]);
            return Child::new(2, self.wide.runs.len() - 1);
        }
        self.wide.nodes.push(WideNode::EMPTY);
        Child::new(0, self.wide.nodes.len() - 1)
    }

    /// The up to eight nodes of pairs that become a node's children: the largest is opened until there are enough.
    fn family(&self, from: u32) -> Vec<u32> {
        let area = |index: u32| {
            let node = &self.packed.nodes[index as usize];
            let closed = node.count > 0 || self.weights[index as usize] < MANY;
            let [x, y, z] = [0, 1, 2].map(|axis| node.high[axis] - node.low[axis]);
            if closed { -1.0 } else { x * y + y * z + z * x }
        };
        let first = self.packed.nodes[from as usize].first;
        let mut family = vec![first, first + 1];
        while family.len() < LANES {
            let largest = (0..family.len()).max_by(|a, b| area(family[*a]).total_cmp(&area(family[*b])));
            let Some(largest) = largest.filter(|at| area(family[*at]) >= 0.0) else {
                break;
            };
            let first = self.packed.nodes[family[largest] as usize].first;
            family[largest] = first;
            family.push(first + 1);
        }
        family
    }

    /// The balls below a node.
    fn below(&self, from: u32) -> Vec<u32> {
        let (mut open, mut balls) = (vec![from], Vec::with_capacity(LANES));
        while let Some(index) = open.pop() {
            let node = &self.packed.nodes[index as usize];
            if node.count == 0 {
                open.extend([node.first, node.first + 1]);
            } else {
                balls.extend(
                    islands(self.packed, node)
                        .iter()
                        .filter_map(|island| ball(self.packed, island)),
                );
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
        Child::new(1, self.wide.blocks.len() - 1)
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
