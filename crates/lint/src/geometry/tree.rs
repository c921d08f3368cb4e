//! A tree over boxes: which of them lie in a given one, and which hold a given point.

use super::bounds::Bounds;

/// Boxes under one lowest node. Nodes are as large as two boxes: with fewer boxes under each, the tree would weigh as much as what
/// it holds.
const BUNCH: usize = 16;

/// A binary tree over boxes in the order of Morton's curve (1966), level by level, the lowest one first.
pub(super) struct Tree {
    items: Vec<(u32, Bounds)>,
    levels: Vec<Vec<Node>>,
}

/// What the boxes under a node have in common.
#[derive(Clone, Copy)]
struct Node {
    /// The box around them all.
    around: Bounds,
    /// The highest of the low sides and the lowest of the high ones: a box that holds any of them reaches these.
    inner: Bounds,
}

impl Node {
    fn of(bounds: &Bounds) -> Self {
        Self {
            around: *bounds,
            inner: *bounds,
        }
    }

    fn and(self, other: Self) -> Self {
        let [a, b] = [self, other];
        Self {
            around: Bounds {
                low: std::array::from_fn(|i| a.around.low[i].min(b.around.low[i])),
                high: std::array::from_fn(|i| a.around.high[i].max(b.around.high[i])),
            },
            inner: Bounds {
                low: std::array::from_fn(|i| a.inner.low[i].max(b.inner.low[i])),
                high: std::array::from_fn(|i| a.inner.high[i].min(b.inner.high[i])),
            },
        }
    }

    /// Whether a box under this node may lie in the given one.
    fn may_lie_in(&self, outer: &Bounds) -> bool {
        outer.holds(&self.inner)
    }
}

impl Tree {
    /// A tree over finite boxes, each with a number.
    pub(super) fn new(boxes: Vec<(u32, Bounds)>) -> Self {
        let items = sorted(boxes);
        let join = |nodes: &[Node]| nodes.iter().copied().reduce(Node::and);
        let bunch = |items: &[(u32, Bounds)]| items.iter().map(|(_, one)| Node::of(one)).reduce(Node::and);
        let mut levels = vec![items.chunks(BUNCH).filter_map(bunch).collect::<Vec<_>>()];
        while let Some(last) = levels.last()
            && last.len() > 1
        {
            let next = last.chunks(2).filter_map(join).collect();
            levels.push(next);
        }
        Self { items, levels }
    }

    /// Calls `visit` with the number of every box that lies in `outer`. Every node entered takes one of `steps`;
    /// without any left the search ends.
    pub(super) fn lying_in(&self, outer: &Bounds, steps: &mut u64, mut visit: impl FnMut(u32)) {
        self.walk(
            |node| node.may_lie_in(outer),
            steps,
            |number, bounds| {
                if outer.holds(bounds) {
                    visit(number);
                }
            },
        );
    }

    /// Calls `visit` with the number of every box that holds a point, which is given as a box around it.
    pub(super) fn holding(&self, point: &Bounds, steps: &mut u64, mut visit: impl FnMut(u32)) {
        self.walk(
            |node| node.around.apart(point).is_none(),
            steps,
            |number, bounds| {
                if bounds.apart(point).is_none() {
                    visit(number);
                }
            },
        );
    }

    fn walk(&self, enter: impl Fn(&Node) -> bool, steps: &mut u64, mut visit: impl FnMut(u32, &Bounds)) {
        let Some(top) = self.levels.len().checked_sub(1) else {
            return;
        };
        let node = |level: usize, index: usize| self.levels.get(level).and_then(|nodes| nodes.get(index));
        let mut open = Vec::with_capacity(2 * self.levels.len());
        open.extend(node(top, 0).filter(|node| enter(node)).map(|_| (top, 0)));
        while let Some((level, index)) = open.pop() {
            let Some(left) = steps.checked_sub(1) else { return };
            *steps = left;
            if let Some(level) = level.checked_sub(1) {
                for index in [2 * index, 2 * index + 1] {
                    if node(level, index).is_some_and(&enter) {
                        open.push((level, index));
                    }
                }
                continue;
            }
            let bunch = self.items.iter().skip(index * BUNCH).take(BUNCH);
            bunch.for_each(|(number, bounds)| visit(*number, bounds));
        }
    }

    /// The numbers of the boxes with their boxes, near ones close together and of those in one place the largest first.
    pub(super) fn items(&self) -> &[(u32, Bounds)] {
        &self.items
    }
}

/// The boxes in the order of their middles along Morton's curve.
fn sorted(mut boxes: Vec<(u32, Bounds)>) -> Vec<(u32, Bounds)> {
    let middle = |bounds: &Bounds, i: usize| f64::from(bounds.low[i]) + f64::from(bounds.high[i]);
    let ends: [(f64, f64); 3] = std::array::from_fn(|i| {
        let middles = boxes.iter().map(|(_, bounds)| middle(bounds, i));
        middles.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
            (low.min(at), high.max(at))
        })
    });
    let cells = f64::from((1_u32 << 21) - 1);
    let code = |bounds: &Bounds| {
        (0..3).fold(0, |code, i| {
            let (low, high) = ends[i];
            let share = (middle(bounds, i) - low) / (high - low).max(f64::MIN_POSITIVE);
            code | spread((share * cells) as u64) << i
        })
    };
    // The bits of singles that are not negative are in the order of their values.
    let small = |bounds: &Bounds| u32::MAX - bounds.size().to_bits();
    boxes.sort_by_cached_key(|(_, one)| (code(one), small(one)));
    boxes
}

/// The 21 lowest bits, two apart.
fn spread(value: u64) -> u64 {
    let mut v = value & 0x1F_FFFF;
    v = (v | v << 32) & 0x001F_0000_0000_FFFF;
    v = (v | v << 16) & 0x001F_0000_FF00_00FF;
    v = (v | v << 8) & 0x100F_00F0_0F00_F00F;
    v = (v | v << 4) & 0x10C3_0C30_C30C_30C3;
    (v | v << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Tree};

    fn boxes(count: u32) -> Vec<(u32, Bounds)> {
        let at = |number: u32, axis: u32| ((number.wrapping_mul(2_654_435_761 + axis * 40_503)) >> 16) as f32 / 6553.6;
        let one = |number: u32| {
            let low = [0, 1, 2].map(|axis| at(number, axis));
            let size = at(number, 7) / 4.0;
            (
                number,
                Bounds {
                    low,
                    high: low.map(|low| low + size),
                },
            )
        };
        (0..count).map(one).collect()
    }

    /// The tree's answers are those of looking at every box.
    fn check(count: u32) {
        let all = boxes(count);
        let tree = Tree::new(all.clone());
        for (_, query) in &all {
            let mut found = Vec::new();
            tree.lying_in(query, &mut u64::MAX.clone(), |number| found.push(number));
            found.sort_unstable();
            let expect = all
                .iter()
                .filter(|(_, other)| query.holds(other))
                .map(|(number, _)| *number);
            assert_eq!(found, expect.collect::<Vec<_>>());
            let point = Bounds {
                low: query.high,
                high: query.high,
            };
            let mut found = Vec::new();
            tree.holding(&point, &mut u64::MAX.clone(), |number| found.push(number));
            found.sort_unstable();
            let expect = all
                .iter()
                .filter(|(_, other)| other.holds(&point))
                .map(|(number, _)| *number);
            assert_eq!(found, expect.collect::<Vec<_>>());
        }
    }

    #[test]
    fn the_tree_finds_what_looking_at_each_finds() {
        [0, 1, 8, 9, 300].into_iter().for_each(check);
    }

    #[test]
    fn a_search_ends_with_its_steps() {
        let tree = Tree::new(boxes(300));
        let mut steps = 3;
        tree.lying_in(&Bounds::EVERYWHERE, &mut steps, |_| {});
        assert_eq!(steps, 0);
    }
}
