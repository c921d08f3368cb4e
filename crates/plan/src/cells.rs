//! A large island divided into cells of space, each with what is left of the tree there.
//!
//! A cell's tree has, at every point of the cell, the very truths of the whole tree: leaves that lie beyond the cell's walls
//! by less than a tracer's rounding stay in it. So a ray may be followed from cell to cell as if there were one tree, and
//! gives the very same bits.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::sync::Mutex;

use hashbrown::HashMap;

use scenec_scene::DVec3;

use crate::packed::packed_structs::Cell;
use crate::parts::Parts;
use crate::postfix::{Pruner, Rest, Token};
use crate::shape::{Shape, ShapeKind};
use crate::together::each;
use crate::{Box3, Leaf, Part};

/// A cell that is not divided holds a part, ...
pub const CELL_PART: u32 = 3;
/// ... nothing of the island, ...
pub const CELL_EMPTY: u32 = 4;
/// ... or nothing but it.
pub const CELL_FULL: u32 = 5;

/// The most cells within cells; a tracer waits with at most this many.
pub const CELLS_DEPTH: usize = 40;

/// A ray that starts with a coordinate beyond this, plan units, is not followed through cells: its rounding is larger than
/// what the cells allow for. All that the camera sees at first is nearer.
pub const CELLS_REACH: f64 = 8.0;

/// How far beside its place a point on a ray may be for the rounding of single precision: a crossing and a wall are each
/// found by a handful of roundings of coordinates up to twice [`CELLS_REACH`].
const SLACK: f64 = 16.0 * CELLS_REACH * (1.0 / (1 << 24) as f64) * 2.0;

/// Trees of up to this many leaves are not divided.
const SMALL: usize = 6;
/// Trees of up to this many leaves may stay in a cell that few rays meet. A device's program has room for so many anyway: how
/// large a picture is does not change which program draws it.
const FEW: usize = 8;
/// What it takes to divide a cell, for each of its tokens, in pairs of leaves that some ray meets: measured between 100 and 1000, with
/// little to choose.
const CUT: f64 = 400.0;
/// What going through a wall costs, in pairs of leaves: with its leaves grow both the crossings that a ray sees in a cell and
/// what each of them takes.
const WALL: f64 = 4.0;
/// How often a cell is halved without gain, in the hope of some further down.
const HOPE: u32 = 3;
/// The most tokens of all cells for each of the whole tree, ...
const GROWTH: usize = 24;
/// ... and as many more for trees of middle size.
const ROOM: usize = 8192;
/// The part of a cell that is cut off for being empty.
const GAP: f64 = 0.15;

/// So many cells are divided at once, the dearest ones, whatever the number of threads: every machine finds the same.
const AT_ONCE: usize = 1024;
/// From so many tokens on, starting threads costs less than they save.
const MANY: usize = 1 << 13;

/// Divides islands.
pub(crate) struct Divider<'a> {
    stage: Stage<'a>,
    /// One for each thread that has come by.
    cutters: Mutex<Vec<Cutter<'a>>>,
    known: HashMap<Vec<Token>, u32>,
    pub(crate) cells: Vec<Cell>,
    pub(crate) parts: Vec<Part>,
}

/// What cells are cut out of.
#[derive(Clone, Copy)]
pub(crate) struct Stage<'a> {
    pub(crate) shapes: &'a [Shape],
    pub(crate) leaves: &'a [Leaf],
    /// What holds each leaf.
    pub(crate) boxes: &'a [Box3],
    /// Where things are, and the eye.
    pub(crate) bounds: Box3,
    /// About how many rays come through.
    pub(crate) rays: f64,
}

/// Divides one cell after the other.
struct Cutter<'a> {
    stage: Stage<'a>,
    pruner: Pruner<'a>,
}

/// A cell that may yet be divided.
struct Open {
    cell: usize,
    tokens: Vec<Token>,
    bounds: Box3,
    leaves: usize,
    hull: Box3,
    depth: usize,
    stale: u32,
}

/// A cell in a line of cells, the dearest first.
struct Waiting {
    weight: f64,
    open: Box<Open>,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let cells = other.open.cell.cmp(&self.open.cell);
        self.weight.total_cmp(&other.weight).then(cells)
    }
}

/// A wall and what is on either side of it.
struct Split {
    axis: usize,
    wall: f32,
    sides: [(Rest, Box3); 2],
}

/// A cell that has been divided.
struct Cut {
    axis: usize,
    wall: f32,
    sides: [Half; 2],
}

/// One side of a wall; a cell there has no number yet.
enum Half {
    Done(Draft),
    Open(Waiting),
}

/// A cell on the way to its final form.
enum Draft {
    Split { axis: usize, wall: f32, first: usize },
    Constant(bool),
    Tree(Vec<Token>),
}

impl<'a> Divider<'a> {
    pub(crate) fn new(stage: Stage<'a>) -> Self {
        Self {
            stage,
            cutters: Mutex::default(),
            known: HashMap::new(),
            cells: Vec::new(),
            parts: Vec::new(),
        }
    }

    /// Divides a tree; nothing if it is small or can't be divided. The number is the first cell's.
    pub(crate) fn divide(&mut self, tokens: &[Token], parts: &mut Parts) -> Option<u32> {
        if tokens.len() <= SMALL {
            return None;
        }
        let drafts = self.drafts(tokens)?;
        let base = self.cells.len() as u32;
        for draft in drafts {
            let cell = match draft {
                Draft::Split { axis, wall, first } => Cell {
                    wall,
                    kind: axis as u32,
                    first: base + first as u32,
                },
                Draft::Constant(value) => Cell {
                    wall: 0.0,
                    kind: if value { CELL_FULL } else { CELL_EMPTY },
                    first: 0,
                },
                Draft::Tree(tokens) => Cell {
                    wall: 0.0,
                    kind: CELL_PART,
                    first: self.part(tokens, parts),
                },
            };
            self.cells.push(cell);
        }
        Some(base)
    }

    /// The number of the part of a tree; equal trees share one.
    fn part(&mut self, tokens: Vec<Token>, parts: &mut Parts) -> u32 {
        let next = self.parts.len() as u32;
        match self.known.entry(tokens) {
            hashbrown::hash_map::Entry::Occupied(known) => *known.get(),
            hashbrown::hash_map::Entry::Vacant(place) => {
                self.parts.push(parts.tree(place.key()));
                *place.insert(next)
            }
        }
    }

    /// The dearest cells are divided first, as long as that pays and there is room.
    fn drafts(&self, tokens: &[Token]) -> Option<Vec<Draft>> {
        let root = self.with_cutter(|cutter| cutter.open(tokens.to_vec(), Box3::ALL, 0, 0));
        let Half::Open(root) = root else { return None };
        let most = tokens.len().saturating_mul(GROWTH).saturating_add(ROOM);
        let mut total = tokens.len();
        let mut drafts = vec![Draft::Constant(false)];
        let mut waiting = BinaryHeap::from([root]);
        while total < most && !waiting.is_empty() {
            let dearest: Vec<_> = (0..AT_ONCE)
                .map_while(|_| waiting.pop())
                .map(|next| next.open)
                .collect();
            for (cut, open) in self.cut(&dearest).into_iter().zip(dearest) {
                let Some(Cut { axis, wall, sides }) = cut else {
                    drafts[open.cell] = Draft::Tree(open.tokens);
                    continue;
                };
                let first = drafts.len();
                drafts[open.cell] = Draft::Split { axis, wall, first };
                total -= open.tokens.len();
                for side in sides {
                    let draft = match side {
                        Half::Done(draft) => draft,
                        Half::Open(mut next) => {
                            total += next.open.tokens.len();
                            next.open.cell = drafts.len();
                            waiting.push(next);
                            // Until it is known what becomes of it.
                            Draft::Constant(false)
                        }
                    };
                    if let Draft::Tree(tokens) = &draft {
                        total += tokens.len();
                    }
                    drafts.push(draft);
                }
            }
        }
        for Waiting { open, .. } in waiting {
            drafts[open.cell] = Draft::Tree(open.tokens);
        }
        matches!(drafts[0], Draft::Split { .. }).then_some(drafts)
    }

    /// Divides cells, each if that pays.
    fn cut(&self, cells: &[Box<Open>]) -> Vec<Option<Cut>> {
        let tokens: usize = cells.iter().map(|open| open.tokens.len()).sum();
        each(cells, tokens >= MANY, |open| {
            self.with_cutter(|cutter| cutter.cut(open))
        })
    }

    /// Has a cutter work that nobody else uses meanwhile.
    fn with_cutter<T>(&self, work: impl FnOnce(&mut Cutter<'a>) -> T) -> T {
        let free = self.cutters.lock().ok().and_then(|mut cutters| cutters.pop());
        let mut cutter = free.unwrap_or_else(|| Cutter {
            stage: self.stage,
            pruner: Pruner::new(self.stage.shapes, self.stage.leaves),
        });
        let done = work(&mut cutter);
        if let Ok(mut cutters) = self.cutters.lock() {
            cutters.push(cutter);
        }
        done
    }
}

impl Cutter<'_> {
    /// A cell, unless there is too little in it to divide it, or too few rays meet it.
    fn open(&mut self, tokens: Vec<Token>, bounds: Box3, depth: usize, stale: u32) -> Half {
        let (Stage { boxes, .. }, mut hull) = (self.stage, Box3::EMPTY);
        let leaves = self.pruner.distinct(&tokens, |leaf| {
            if boxes[leaf as usize].is_finite() {
                hull = hull.hull(boxes[leaf as usize]);
            }
        });
        let weight = area(&bounds.intersection(self.stage.bounds)) * (leaves * leaves) as f64;
        // Of the rays through the stage a box meets the share that its outside has (Crofton 1868).
        let rays = self.stage.rays / area(&self.stage.bounds);
        let in_vain = leaves <= FEW && rays * weight < CUT * tokens.len() as f64;
        if leaves <= SMALL || depth == CELLS_DEPTH || in_vain {
            return Half::Done(Draft::Tree(tokens));
        }
        let hull = if hull.is_empty() { self.stage.bounds } else { hull };
        let hull = hull.intersection(bounds);
        Half::Open(Waiting {
            weight,
            open: Box::new(Open {
                cell: 0,
                tokens,
                bounds,
                leaves,
                hull,
                depth,
                stale,
            }),
        })
    }

    fn cut(&mut self, open: &Open) -> Option<Cut> {
        let (Split { axis, wall, sides }, stale) = self.split(open)?;
        let sides = sides.map(|(rest, bounds)| match rest {
            Rest::Constant(value) => Half::Done(Draft::Constant(value)),
            Rest::Tree(tokens) => self.open(tokens, bounds, open.depth + 1, stale),
        });
        Some(Cut { axis, wall, sides })
    }

    /// The best wall through a cell, and how long nothing has been gained then.
    fn split(&mut self, open: &Open) -> Option<(Split, u32)> {
        if let Some((axis, wall)) = gap(&open.bounds, &open.hull) {
            let split = self.at(open, axis, wall)?;
            return Some((split, 0));
        }
        let size = open.hull.max - open.hull.min;
        let mut axes = [0, 1, 2];
        axes.sort_by(|a, b| size[*b].total_cmp(&size[*a]));
        let mut hope = None;
        for axis in axes {
            let middle = open.hull.min[axis] + size[axis] / 2.0;
            let Some(split) = self.at(open, axis, middle) else {
                continue;
            };
            let cost: f64 = split
                .sides
                .iter()
                .map(|(rest, bounds)| area(bounds) * self.leaves(rest).powi(2))
                .sum();
            if WALL + cost / area(&open.bounds) < (open.leaves * open.leaves) as f64 {
                return Some((split, 0));
            }
            hope = hope.or(Some(split));
        }
        hope.filter(|_| open.stale < HOPE).map(|split| (split, open.stale + 1))
    }

    fn leaves(&mut self, rest: &Rest) -> f64 {
        match rest {
            Rest::Constant(_) => 0.0,
            Rest::Tree(tokens) => self.pruner.distinct(tokens, |_| {}) as f64,
        }
    }

    fn at(&mut self, open: &Open, axis: usize, wall: f64) -> Option<Split> {
        let wall = wall as f32;
        let exact = f64::from(wall);
        if !(open.bounds.min[axis] < exact && exact < open.bounds.max[axis]) {
            return None;
        }
        let (mut lower, mut upper) = (open.bounds, open.bounds);
        lower.max[axis] = exact;
        upper.min[axis] = exact;
        let sides = [lower, upper].map(|bounds| (self.pruner.prune(&open.tokens, &bounds, SLACK), bounds));
        Some(Split { axis, wall, sides })
    }
}

/// Where a cell goes on far beyond all that is in it.
fn gap(bounds: &Box3, hull: &Box3) -> Option<(usize, f64)> {
    let size = bounds.max - bounds.min;
    let mut widest = (0.0, None);
    for axis in 0..3 {
        let off = 4.0 * SLACK;
        for (wall, gap) in [
            (hull.max[axis] + off, bounds.max[axis] - hull.max[axis] - off),
            (hull.min[axis] - off, hull.min[axis] - off - bounds.min[axis]),
        ] {
            let wide = gap == f64::INFINITY || gap > GAP * size[axis];
            if wide && gap > widest.0 {
                widest = (gap, Some((axis, wall)));
            }
        }
    }
    widest.1
}

fn area(bounds: &Box3) -> f64 {
    let size = (bounds.max - bounds.min).max(DVec3::ZERO);
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// What holds a shape, plan units.
pub(crate) fn holder(shape: &Shape) -> Box3 {
    if shape.kind() == ShapeKind::HalfSpace {
        return Box3::ALL;
    }
    let rows = shape.linear().transpose();
    let reach = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
    Box3 {
        min: shape.centre - reach,
        max: shape.centre + reach,
    }
}
