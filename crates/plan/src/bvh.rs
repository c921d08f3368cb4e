//! The hierarchy over bounded islands.

use std::hash::BuildHasher;

use hashbrown::DefaultHashBuilder;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use crate::packed::packed_structs::Node;
use crate::{Box3, Island};

/// With up to this many members in all bounded islands, a list is walked faster than a tree.
const SHORT_LIST: u32 = 8;
/// The deepest hierarchy that the tracers' stacks hold.
pub(crate) const MAX_DEPTH: usize = 64;
/// The most islands in a leaf of the hierarchy.
const LEAF_ISLANDS: usize = 4;

/// Islands in the order in which they are looked for.
pub(crate) struct Arranged {
    /// The unbounded islands first, the rest in the order of the hierarchy, if there are enough of them for one.
    pub(crate) list: Vec<Island>,
    /// How many stand before those that the hierarchy holds.
    pub(crate) linear: usize,
    /// The hierarchy.
    pub(crate) nodes: Vec<Node>,
}

/// Arranges islands.
pub(crate) fn arrange(islands: Vec<Island>) -> Arranged {
    let (mut order, bounded): (Vec<_>, Vec<_>) =
        (0..islands.len() as u32).partition(|index| !islands[*index as usize].bounds.is_finite());
    let island = |index: u32| &islands[index as usize];
    let members: u32 = bounded
        .iter()
        .map(|index| island(*index).members.1 - island(*index).members.0)
        .sum();
    let (places, mut nodes) = if members <= SHORT_LIST {
        order.extend(&bounded);
        Default::default()
    } else {
        let boxes: Vec<_> = bounded.iter().map(|index| outward(&island(*index).bounds)).collect();
        build(&boxes)
    };
    let linear = order.len();
    order.extend(places.iter().map(|place| bounded[*place as usize]));
    for node in nodes.iter_mut().filter(|node| node.count > 0) {
        node.first += linear as u32;
    }
    Arranged {
        list: order.into_iter().map(|index| islands[index as usize]).collect(),
        linear,
        nodes,
    }
}

type Corners = [[f32; 3]; 2];

/// The box in singles, never smaller, and widened by a few roundings of a tracer's own box test: the coordinate itself
/// (u), the subtraction of the origin (u), the product (u), each doubled since the origin's coordinate is rounded too.
fn outward(bounds: &Box3) -> Corners {
    const SLACK: f64 = 6.0 * f32::EPSILON as f64;
    let slack = bounds.min.abs().max(bounds.max.abs()) * SLACK;
    let low = (bounds.min - slack).to_array().map(|x| (x as f32).next_down());
    let high = (bounds.max + slack).to_array().map(|x| (x as f32).next_up());
    [low, high]
}

/// The order of the islands, and nodes whose leaves count from 0 in that order; each node stands before its children.
fn build(boxes: &[Corners]) -> (Vec<u32>, Vec<Node>) {
    let fine = Some(boxes).filter(|boxes| spread(boxes)).and_then(clustered);
    fine.and_then(|tree| laid_out(&tree))
        .filter(|(order, _)| order.len() == boxes.len())
        .unwrap_or_else(|| halved(boxes))
}

/// Whether more than half of the boxes stand in places of their own. The library's builder joins neighbours along a
/// space-filling curve; of many boxes in one place it joins one pair a pass, which is quadratic.
fn spread(boxes: &[Corners]) -> bool {
    let middle =
        |[low, high]: &Corners| -> [u32; 3] { std::array::from_fn(|i| (low[i] / 2.0 + high[i] / 2.0).to_bits()) };
    // Each place marks one bit of four and more that there are for each box. As many places as marks there are at least, and of
    // places that are all different few share one.
    let bits = (4 * boxes.len()).next_power_of_two().max(64);
    let mut marks = vec![0_u64; bits / 64];
    let hashing = DefaultHashBuilder::default();
    let mut marked = 0;
    boxes.iter().any(|corners| {
        let bit = hashing.hash_one(middle(corners)) as usize % bits;
        let (marks, mark) = (&mut marks[bit / 64], 1 << (bit % 64));
        marked += usize::from(*marks & mark == 0);
        *marks |= mark;
        marked > boxes.len() / 2
    })
}

/// The library's tree; nothing where it is so deep (many islands in one place) that the library's own later steps, which
/// recurse, would overflow the stack.
fn clustered(boxes: &[Corners]) -> Option<Bvh2> {
    let aabbs: Vec<_> = boxes
        .iter()
        .map(|[low, high]| Aabb::new((*low).into(), (*high).into()))
        .collect();
    let params = BvhBuildParams::medium_build();
    let indices = (0..boxes.len() as u32).collect();
    let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
        params.ploc_search_distance,
        &aabbs,
        indices,
        params.sort_precision,
        params.search_depth_threshold,
    );
    let inner = |index: usize| (tree.nodes[index].prim_count == 0).then_some(tree.nodes[index].first_index);
    if !tree.children_are_ordered_after_parents || depth(tree.nodes.len(), inner) > MAX_DEPTH {
        return None;
    }
    ReinsertionOptimizer::default().run(&mut tree, params.reinsertion_batch_ratio, None);
    collapse(&mut tree, LEAF_ISLANDS as u32, params.collapse_traversal_cost);
    Some(tree)
}

/// The library's tree from left to right: what is near in space is near in memory. Nothing where it is too deep.
fn laid_out(tree: &Bvh2) -> Option<(Vec<u32>, Vec<Node>)> {
    let mut order = Vec::with_capacity(tree.primitive_indices.len());
    let mut nodes = Vec::with_capacity(tree.nodes.len());
    nodes.push(Node::default());
    let mut open = vec![(0_u32, 0_usize, 1)];
    while let Some((from, place, level)) = open.pop() {
        let node = tree.nodes.get(from as usize)?;
        let (first, count) = (node.first_index as usize, node.prim_count as usize);
        let start = if count > 0 {
            order.extend(tree.primitive_indices.get(first..first + count)?);
            order.len() - count
        } else if level < MAX_DEPTH {
            let start = nodes.len();
            open.extend([1, 0].map(|side| (node.first_index + side as u32, start + side, level + 1)));
            nodes.extend([Node::default(); 2]);
            start
        } else {
            return None;
        };
        nodes[place] = Node {
            low: node.aabb.min.to_array(),
            high: node.aabb.max.to_array(),
            first: start as u32,
            count: node.prim_count,
        };
    }
    Some((order, nodes))
}

/// How deep a tree is whose nodes stand before their children, given the first of a node's two children, or nothing for a leaf.
fn depth(nodes: usize, first_child: impl Fn(usize) -> Option<u32>) -> usize {
    let mut levels = vec![1_u8; nodes];
    let mut deepest = 0;
    for index in 0..nodes {
        let level = levels[index];
        deepest = deepest.max(level);
        if let Some(first) = first_child(index) {
            levels[first as usize..][..2].fill(level.saturating_add(1));
        }
    }
    deepest.into()
}

/// A plain halving of the islands by their centres along the longest axis: as deep as the logarithm of their number
/// whatever the input, for the inputs on which the better builder's tree is too deep.
fn halved(boxes: &[Corners]) -> (Vec<u32>, Vec<Node>) {
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let mut nodes = vec![Node::default()];
    let mut open = vec![(0_usize, 0_usize, order.len())];
    while let Some((index, start, end)) = open.pop() {
        let part = &mut order[start..end];
        let hull = part.iter().map(|i| boxes[*i as usize]).reduce(hull).unwrap_or_default();
        let mut made = Node {
            low: hull[0],
            high: hull[1],
            first: start as u32,
            count: part.len() as u32,
        };
        if part.len() > LEAF_ISLANDS {
            let axis = (0..3).max_by(|a, b| (hull[1][*a] - hull[0][*a]).total_cmp(&(hull[1][*b] - hull[0][*b])));
            let axis = axis.unwrap_or_default();
            let middle = part.len() / 2;
            let centre = |i: &u32| boxes[*i as usize][0][axis] / 2.0 + boxes[*i as usize][1][axis] / 2.0;
            part.select_nth_unstable_by(middle, |a, b| centre(a).total_cmp(&centre(b)));
            made = Node {
                first: nodes.len() as u32,
                count: 0,
                ..made
            };
            open.push((nodes.len(), start, start + middle));
            open.push((nodes.len() + 1, start + middle, end));
            nodes.extend([Node::default(); 2]);
        }
        nodes[index] = made;
    }
    (order, nodes)
}

fn hull(a: Corners, b: Corners) -> Corners {
    let pick = |which: usize, best: fn(f32, f32) -> f32| std::array::from_fn(|i| best(a[which][i], b[which][i]));
    [pick(0, f32::min), pick(1, f32::max)]
}

#[cfg(test)]
mod tests {
    use super::{Corners, LEAF_ISLANDS, MAX_DEPTH, Node, build, depth, halved};

    fn grid(count: u32) -> Vec<Corners> {
        let corner = |i: u32| [(i % 7) as f32, (i % 31) as f32, (i / 31) as f32];
        (0..count).map(corner).map(|low| [low, low.map(|x| x + 0.5)]).collect()
    }

    fn check(boxes: &[Corners], (order, nodes): (Vec<u32>, Vec<Node>)) {
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..boxes.len() as u32).collect::<Vec<_>>());
        let first = |index: usize| (nodes[index].count == 0).then_some(nodes[index].first);
        assert!((0..nodes.len()).all(|index| first(index).is_none_or(|first| first as usize > index)));
        assert!(depth(nodes.len(), first) <= MAX_DEPTH);
        let mut covered = 0;
        for node in nodes.iter().filter(|node| node.count > 0) {
            assert!(node.count as usize <= LEAF_ISLANDS || node.count < 256);
            for index in &order[node.first as usize..(node.first + node.count) as usize] {
                let [low, high] = boxes[*index as usize];
                assert!((0..3).all(|i| node.low[i] <= low[i] && high[i] <= node.high[i]));
                covered += 1;
            }
        }
        assert_eq!(covered, boxes.len());
    }

    #[test]
    fn both_builders_hold_every_island_once() {
        for count in [9, 100, 5000] {
            let boxes = grid(count);
            check(&boxes, build(&boxes));
            check(&boxes, halved(&boxes));
        }
    }

    #[test]
    fn islands_in_one_place_make_no_deep_tree() {
        let boxes = vec![[[0.0; 3], [1.0; 3]]; 20_000];
        check(&boxes, build(&boxes));
        check(&boxes, halved(&boxes));
    }
}
