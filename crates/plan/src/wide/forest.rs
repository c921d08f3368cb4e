//! Which nodes of pairs become one node of eight: those with the least cost of all ways to choose them.

use super::LANES;
use super::build::{MANY, within};
use crate::packed::packed_structs::Node;

/// What it takes to test a ray against the boxes of a node, and against the balls of a block: about the same.
const NODE: f32 = 1.0;
const BLOCK: f32 = 1.0;
/// And against an island that is something else.
const ISLAND: f32 = 1.0;

/// What becomes of a node of pairs.
#[derive(Clone, Copy)]
pub(super) struct Choice {
    /// Entry j is for a forest of up to j + 1 trees: how many of them its left child makes, or 0 if one fewer does as well. The first
    /// is for a single one: 1 for a node, 0 for a block or a run. The last is for the children of a node.
    left: [u8; LANES],
    /// How many balls there are, if they fit a block.
    pub(super) weight: u8,
}

impl Choice {
    const CLOSED: Self = Self {
        left: [0; LANES],
        weight: MANY,
    };

    /// Whether it becomes a block or a run.
    pub(super) const fn is_closed(&self) -> bool {
        self.left[0] == 0
    }
}

/// Chooses for all nodes of pairs, each of which stands before its children, those of their leaves being balls that are `ball`.
///
/// The cost is what a ray that meets the whole has to test on average, a box being met as often as it is large on its outside
/// (Goldsmith and Salmon 1987; of wide nodes Wald et al. 2008). The least for a forest in place of a node comes from those of its
/// two children (Ylitie et al. 2017).
pub(super) fn choices(nodes: &[Node], ball: impl Fn(usize) -> bool) -> Vec<Choice> {
    let mut costs = vec![[0.0; LANES - 1]; nodes.len()];
    let mut choices = vec![Choice::CLOSED; nodes.len()];
    for (index, node) in nodes.iter().enumerate().rev() {
        let first = node.first as usize;
        let area = area(node);
        if node.count > 0 {
            let fits = node.count as usize <= LANES && within(node).all(&ball);
            let cost = if fits { BLOCK } else { ISLAND * node.count as f32 };
            choices[index].weight = if fits { node.count as u8 } else { MANY };
            costs[index] = [area * cost; LANES - 1];
            continue;
        }
        let weight = MANY.min(choices[first].weight + choices[first + 1].weight);
        let closed = if weight < MANY { area * BLOCK } else { f32::INFINITY };
        let [left, right] = [&costs[first], &costs[first + 1]];
        let (children, inner) = divided(left, right, LANES);
        let inner = inner + area * NODE;
        let mut choice = Choice::CLOSED;
        let mut cost = [closed.min(inner); LANES - 1];
        choice.weight = weight;
        choice.left[0] = u8::from(weight == MANY || inner < closed);
        choice.left[LANES - 1] = children;
        for trees in 2..LANES {
            let (part, divided) = divided(left, right, trees);
            cost[trees - 1] = cost[trees - 2];
            if divided < cost[trees - 1] {
                (choice.left[trees - 1], cost[trees - 1]) = (part, divided);
            }
        }
        (choices[index], costs[index]) = (choice, cost);
    }
    choices
}

/// How so many trees are best shared between two children, and what that costs.
fn divided(left: &[f32; LANES - 1], right: &[f32; LANES - 1], trees: usize) -> (u8, f32) {
    let mut best = (1, left[0] + right[trees - 2]);
    for part in 2..trees {
        let cost = left[part - 1] + right[trees - part - 1];
        if cost < best.1 {
            best = (part as u8, cost);
        }
    }
    best
}

/// The nodes of pairs that become the children of a node.
pub(super) fn family(nodes: &[Node], choices: &[Choice], from: u32) -> Vec<u32> {
    let mut family = Vec::with_capacity(LANES);
    let mut open = vec![(from, LANES)];
    while let Some((index, mut trees)) = open.pop() {
        let left = &choices[index as usize].left;
        while trees > 1 && left[trees - 1] == 0 {
            trees -= 1;
        }
        if trees == 1 {
            family.push(index);
            continue;
        }
        let (first, part) = (nodes[index as usize].first, left[trees - 1].into());
        open.extend([(first + 1, trees - part), (first, part)]);
    }
    family
}

/// Half the outside of a box.
fn area(node: &Node) -> f32 {
    let [x, y, z] = [0, 1, 2].map(|axis| node.high[axis] - node.low[axis]);
    x * y + y * z + z * x
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Choice, LANES, MANY, NODE, area, choices, family};
    use crate::packed::packed_structs::Node;

    /// What the chosen tree below a node costs.
    fn chosen(nodes: &[Node], choices: &[Choice], from: u32) -> f32 {
        let own = area(&nodes[from as usize]);
        if choices[from as usize].is_closed() {
            return own * BLOCK;
        }
        let children = family(nodes, choices, from);
        assert!((2..=LANES).contains(&children.len()));
        children.iter().map(|child| chosen(nodes, choices, *child)).sum::<f32>() + own * NODE
    }

    /// All ways to write what is below a node as a forest, and the least cost of each number of trees.
    fn forests(nodes: &[Node], choices: &[Choice], from: u32) -> Vec<f32> {
        let node = &nodes[from as usize];
        let own = area(node);
        let closed = if choices[from as usize].weight < MANY {
            own * BLOCK
        } else {
            f32::INFINITY
        };
        let mut least = vec![f32::INFINITY, closed];
        if node.count == 0 {
            let [left, right] = [node.first, node.first + 1].map(|child| forests(nodes, choices, child));
            least.resize(left.len() + right.len() - 1, f32::INFINITY);
            for (i, a) in left.iter().enumerate() {
                for (j, b) in right.iter().enumerate() {
                    least[i + j] = least[i + j].min(a + b);
                }
            }
            let inner = least[2..].iter().take(LANES - 1).copied().fold(f32::INFINITY, f32::min);
            least[1] = closed.min(inner + own * NODE);
        }
        least
    }

    /// A tree over balls on a line, divided where the generator says.
    fn tree(balls: u32, mut seed: u32) -> Vec<Node> {
        let (mut nodes, mut open) = (vec![Node::default()], vec![(0_usize, 0, balls)]);
        while let Some((at, start, end)) = open.pop() {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let middle = start + 1 + (seed >> 8) % (end - start).max(2).saturating_sub(1);
            let high = [end as f32, 1.0 + (seed >> 28) as f32, 1.0];
            let leaf = end - start == 1;
            nodes[at] = Node {
                low: [start as f32, 0.0, 0.0],
                high,
                first: if leaf { start } else { nodes.len() as u32 },
                count: u32::from(leaf),
            };
            if !leaf {
                open.extend([(nodes.len(), start, middle), (nodes.len() + 1, middle, end)]);
                nodes.extend([Node::default(); 2]);
            }
        }
        nodes
    }

    #[test]
    fn no_forest_is_cheaper() {
        for seed in 0..200 {
            let nodes = tree(2 + seed % 60, seed);
            let choices = choices(&nodes, |_| true);
            let (found, least) = (chosen(&nodes, &choices, 0), forests(&nodes, &choices, 0)[1]);
            assert!((found - least).abs() <= 1e-4 * least, "{seed}: {found} {least}");
        }
    }
}
