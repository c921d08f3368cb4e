//! Trees of unions and intersections over leaves and complements of leaves, each any number of operands wide.
//!
//! Joining operands applies what is true of sets whatever the points are: x & x = x, x & !x is nothing, x | (x & y) = x, and
//! what boxes prove. An operand is left out only where no ray could see the difference: of two that are the same the left one
//! stays, since it owns the surface; what is left out for its place keeps a distance from all surfaces that show.

use hashbrown::{HashMap, HashSet};

use crate::shape::{Form, largest};
use crate::shapes::Shapes;
use crate::side::{Side, side};
use crate::summary::Reason;
use crate::{Box3, Shape, ShapeKind};

/// A set of points.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Term {
    /// No point.
    Nothing,
    /// Every point.
    All,
    /// A leaf or its complement.
    Leaf { leaf: u32, negative: bool },
    /// A node of the arena.
    Node(u32),
}

/// How operands are joined.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Join {
    /// In any.
    Union,
    /// In all.
    Intersection,
}

impl Join {
    /// The one that the complements are joined by.
    pub(crate) const fn other(self) -> Self {
        match self {
            Self::Union => Self::Intersection,
            Self::Intersection => Self::Union,
        }
    }

    /// What adds nothing to a join.
    const fn neutral(self) -> Term {
        match self {
            Self::Union => Term::Nothing,
            Self::Intersection => Term::All,
        }
    }
}

/// Operands that are joined, left before right.
#[derive(Clone, Copy, Debug)]
struct Node {
    join: Join,
    first: u32,
    end: u32,
    set: u64,
    bounds: Box3,
}

/// What is known of a leaf: its surface's numbers are world units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LeafFacts {
    pub(crate) shape: u32,
    pub(crate) solid: u32,
    /// What holds the leaf.
    pub(crate) bounds: Box3,
}

/// An operand's points as a number: equal for equal sets that are seen to be equal, and the complement's is one bit away.
const LEAF_SETS: u64 = 1 << 40;

/// Up to this many operands of an operand are looked at, so that a shared wide one does not cost its width at each use.
const MOST_INNER: usize = 64;

/// Up to this many operands are compared each with each.
const MOST_PAIRS: usize = 16;

/// Up to this many half-spaces are looked at for what lies within them.
const MOST_PLANES: usize = 8;

/// What comparisons of places allow for rounding, relative to the sizes that they subtract.
const SLACK: f64 = 1.0 / (1_u64 << 40) as f64;

/// The arena.
#[derive(Default)]
pub(crate) struct Terms {
    nodes: Vec<Node>,
    operands: Vec<Term>,
    sets: HashMap<Box<[u64]>, u64>,
    /// What the leaf terms name.
    pub(crate) leaves: Vec<LeafFacts>,
    /// What holds the complement of a leaf, where anything but all space does.
    pub(crate) complements: HashMap<u32, Box3>,
    /// Why a solid was left out somewhere, by its number.
    pub(crate) why: HashMap<u32, Reason>,
    blamed: HashSet<u32>,
}

impl Terms {
    /// None, with room for so many leaves.
    pub(crate) fn with_room(leaves: usize) -> Self {
        Self {
            leaves: Vec::with_capacity(leaves),
            ..Self::default()
        }
    }

    /// The operands of a node and how they are joined; `None` for anything else.
    pub(crate) fn node(&self, term: Term) -> Option<(Join, &[Term])> {
        let Term::Node(node) = term else { return None };
        let node = &self.nodes[node as usize];
        Some((node.join, &self.operands[node.first as usize..node.end as usize]))
    }

    /// How many leaves each node has, every use counted; saturates. Operands stand before what joins them.
    pub(crate) fn sizes(&self) -> Vec<u64> {
        let mut sizes: Vec<u64> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let operands = &self.operands[node.first as usize..node.end as usize];
            let size = |term: &Term| match *term {
                Term::Node(node) => sizes[node as usize],
                _ => 1,
            };
            sizes.push(operands.iter().map(size).fold(0, u64::saturating_add));
        }
        sizes
    }

    /// What holds a term, world units.
    pub(crate) fn bounds(&self, term: Term) -> Box3 {
        match term {
            Term::Nothing => Box3::EMPTY,
            Term::All => Box3::ALL,
            Term::Leaf { leaf, negative: false } => self.leaves[leaf as usize].bounds,
            Term::Leaf { leaf, .. } => self.complements.get(&leaf).copied().unwrap_or(Box3::ALL),
            Term::Node(node) => self.nodes[node as usize].bounds,
        }
    }

    fn set(&self, shapes: &Shapes, term: Term) -> u64 {
        match term {
            Term::Nothing => 0,
            Term::All => 1,
            Term::Leaf { leaf, negative } => {
                let shape = self.leaves[leaf as usize].shape;
                let turned = shapes.turned[shape as usize];
                LEAF_SETS | u64::from(shapes.list[shape as usize].class) << 1 | u64::from(negative != turned)
            }
            Term::Node(node) => self.nodes[node as usize].set,
        }
    }

    /// Notes why the leaves of a term are left out: the first reason, or that all is nothing.
    pub(crate) fn blame(&mut self, term: Term, reason: Reason) {
        let mut open = vec![term];
        while let Some(term) = open.pop() {
            match term {
                Term::Leaf { leaf, .. } => {
                    let solid = self.leaves[leaf as usize].solid;
                    let known = self.why.entry(solid).or_insert(reason);
                    if reason == Reason::Nothing {
                        *known = reason;
                    }
                }
                Term::Node(node) if self.blamed.insert(node) => {
                    open.extend(self.node(term).into_iter().flat_map(|(_, operands)| operands));
                }
                _ => {}
            }
        }
    }

    /// The operands of the root's unions that can be seen. Of everything, there is no surface to see.
    pub(crate) fn union(&mut self, shapes: &Shapes, operands: Vec<Term>) -> Vec<Term> {
        let trees = operands.iter().any(|term| !matches!(term, Term::Leaf { .. }));
        // Leaves alone are distinct by their shapes.
        let operands = match trees {
            true => self.distinct(shapes, Join::Union, operands).unwrap_or_default(),
            false => operands,
        };
        self.in_the_open(shapes, operands)
    }

    /// The operands of a union that lie within none of its half-spaces, as far as a few of those tell.
    fn in_the_open(&mut self, shapes: &Shapes, mut operands: Vec<Term>) -> Vec<Term> {
        let half_space = |term: &Term| match *term {
            Term::Leaf { leaf, negative: false } => {
                let shape = &shapes.list[self.leaves[leaf as usize].shape as usize];
                (shape.kind() == ShapeKind::HalfSpace).then(|| shape.clone())
            }
            _ => None,
        };
        let planes: Vec<_> = operands.iter().filter_map(half_space).take(MOST_PLANES).collect();
        let mut covered = Vec::new();
        operands.retain(|term| {
            let bounds = self.bounds(*term);
            let hidden = planes
                .iter()
                .any(|plane| side(plane, &bounds, slack(plane, &bounds)) == Side::Inside);
            if hidden {
                covered.push(*term);
            }
            !hidden
        });
        covered.into_iter().for_each(|term| self.blame(term, Reason::Covered));
        operands
    }

    /// Joins operands, left before right.
    pub(crate) fn join(&mut self, shapes: &Shapes, join: Join, operands: Vec<Term>) -> Term {
        let operands = self.spliced(join, operands);
        let Some(operands) = self.distinct(shapes, join, operands) else {
            return join.other().neutral();
        };
        let operands = match join {
            Join::Intersection => match self.placed(shapes, operands) {
                Some(operands) => operands,
                None => return Term::Nothing,
            },
            Join::Union => operands,
        };
        let operands = self.uncovered(shapes, join, operands);
        match operands[..] {
            [] => join.neutral(),
            [only] => only,
            _ => self.add(shapes, join, operands),
        }
    }

    /// The operands, with those of operands that are joined the same way in their place.
    fn spliced(&self, join: Join, operands: Vec<Term>) -> Vec<Term> {
        let same = |term: &Term| {
            self.node(*term)
                .filter(|(inner, terms)| *inner == join && terms.len() <= MOST_INNER)
        };
        if operands.iter().all(|term| same(term).is_none()) {
            return operands;
        }
        let inner = |term: &Term| same(term).map_or_else(|| vec![*term], |(_, terms)| terms.to_vec());
        operands.iter().flat_map(inner).collect()
    }

    fn add(&mut self, shapes: &Shapes, join: Join, operands: Vec<Term>) -> Term {
        // A union is filed as the complement of the intersection of the complements.
        let flip = u64::from(join == Join::Union);
        let mut key: Vec<u64> = operands.iter().map(|term| self.set(shapes, *term) ^ flip).collect();
        key.sort_unstable();
        let next = 1 + self.sets.len() as u64;
        let set = *self.sets.entry(key.into()).or_insert(next) << 1 | flip;
        let boxes = operands.iter().map(|term| self.bounds(*term));
        let bounds = match join {
            Join::Union => boxes.fold(Box3::EMPTY, Box3::hull),
            Join::Intersection => boxes.fold(Box3::ALL, Box3::intersection),
        };
        let first = self.operands.len() as u32;
        self.operands.extend(operands);
        self.nodes.push(Node {
            join,
            first,
            end: self.operands.len() as u32,
            set,
            bounds,
        });
        Term::Node(self.nodes.len() as u32 - 1)
    }

    /// The operands without constants and repetitions, and without what those to their left decide; nothing if the join
    /// comes to the other constant.
    fn distinct(&mut self, shapes: &Shapes, join: Join, operands: Vec<Term>) -> Option<Vec<Term>> {
        let mut seen = HashSet::with_capacity(operands.len());
        let mut kept = Vec::with_capacity(operands.len());
        let mut constant = false;
        for term in &operands {
            let term = self.decided(shapes, join, *term, &seen);
            let set = self.set(shapes, term);
            constant = term == join.other().neutral() || seen.contains(&(set ^ 1));
            if constant {
                break;
            }
            if term == join.neutral() {
                continue;
            }
            if seen.insert(set) {
                kept.push(term);
            } else {
                self.blame(term, Reason::Twin);
            }
        }
        if constant || kept.iter().any(|term| self.undone(shapes, join, *term, &seen)) {
            let reason = match join {
                Join::Union => Reason::Covered,
                Join::Intersection => Reason::Nothing,
            };
            operands.iter().for_each(|term| self.blame(*term, reason));
            return None;
        }
        Some(kept)
    }

    /// Whether the complements of all that an operand joins the other way stand beside it: (x | y) & !x & !y is nothing.
    fn undone(&self, shapes: &Shapes, join: Join, term: Term, beside: &HashSet<u64>) -> bool {
        let complement = |term: &Term| beside.contains(&(self.set(shapes, *term) ^ 1));
        self.node(term)
            .is_some_and(|(inner, terms)| inner != join && terms.len() <= MOST_INNER && terms.iter().all(complement))
    }

    /// An operand, given those to its left: x | (x & y) = x, and x | (!x & y) = x | y. A surface that both have is the left
    /// one's either way.
    fn decided(&mut self, shapes: &Shapes, join: Join, term: Term, left: &HashSet<u64>) -> Term {
        let Some((inner, operands)) = self.node(term) else {
            return term;
        };
        if inner == join || operands.len() > MOST_INNER {
            return term;
        }
        let operands = operands.to_vec();
        let decides = |term: &Term, flip: u64| left.contains(&(self.set(shapes, *term) ^ flip));
        let absorbed = operands.iter().any(|term| decides(term, 0));
        let rest: Vec<_> = operands.iter().copied().filter(|term| !decides(term, 1)).collect();
        if absorbed {
            self.blame(term, Reason::Covered);
            return join.neutral();
        }
        if rest.len() == operands.len() {
            return term;
        }
        for operand in operands {
            if !rest.contains(&operand) {
                self.blame(operand, Reason::Covered);
            }
        }
        match rest[..] {
            [] => inner.neutral(),
            [only] => only,
            _ => self.add(shapes, inner, rest),
        }
    }

    /// The operands of an intersection that matter within the boxes of the others; nothing if it holds no point.
    fn placed(&mut self, shapes: &Shapes, operands: Vec<Term>) -> Option<Vec<Term>> {
        // Boxes of all operands behind each.
        let mut behind = vec![Box3::ALL; operands.len() + 1];
        for (i, term) in operands.iter().enumerate().rev() {
            behind[i] = behind[i + 1].intersection(self.bounds(*term));
        }
        let empty = behind[0].is_empty();
        let mut before = Box3::ALL;
        let mut kept = Vec::with_capacity(operands.len());
        for (i, term) in operands.iter().enumerate() {
            let scope = before.intersection(behind[i + 1]);
            let place = match *term {
                Term::Leaf { leaf, negative } if !empty => {
                    let shape = &shapes.list[self.leaves[leaf as usize].shape as usize];
                    match (side(shape, &scope, slack(shape, &scope)), negative) {
                        (Side::Inside, false) | (Side::Outside, true) => Side::Inside,
                        (Side::Outside, false) | (Side::Inside, true) => Side::Outside,
                        (Side::Across, _) => Side::Across,
                    }
                }
                _ => Side::Across,
            };
            match place {
                _ if empty => {}
                Side::Inside => {
                    self.blame(*term, Reason::Idle);
                    continue;
                }
                Side::Outside => {
                    operands.iter().for_each(|term| self.blame(*term, Reason::Nothing));
                    return None;
                }
                Side::Across => {}
            }
            before = before.intersection(self.bounds(*term));
            kept.push(*term);
        }
        if empty {
            operands.iter().for_each(|term| self.blame(*term, Reason::Nothing));
            return None;
        }
        Some(kept)
    }

    /// A few operands without those that lie within another: of a union, what a leaf swallows; of an intersection, the
    /// complements of what is cut away already.
    fn uncovered(&mut self, shapes: &Shapes, join: Join, operands: Vec<Term>) -> Vec<Term> {
        if operands.len() > MOST_PAIRS {
            return operands;
        }
        let negative = join == Join::Intersection;
        let mut kept = operands;
        let mut at = 0;
        while at < kept.len() {
            let inner = match (join, kept[at]) {
                (Join::Union, term) => self.bounds(term),
                (Join::Intersection, Term::Leaf { leaf, negative: true }) => self.leaves[leaf as usize].bounds,
                _ => Box3::ALL,
            };
            let swallows = |outer: &Term| match *outer {
                Term::Leaf { leaf, negative: sign } if *outer != kept[at] && sign == negative => {
                    let shape = &shapes.list[self.leaves[leaf as usize].shape as usize];
                    side(shape, &inner, slack(shape, &inner)) == Side::Inside
                }
                _ => false,
            };
            if kept.iter().any(swallows) {
                let term = kept.remove(at);
                self.blame(term, Reason::Covered);
            } else {
                at += 1;
            }
        }
        kept
    }
}

/// How far apart a surface and the walls of a box must be to count as apart.
pub(crate) fn slack(shape: &Shape, bounds: &Box3) -> f64 {
    let corners = [bounds.min.to_array(), bounds.max.to_array(), shape.centre.to_array()];
    let sizes = corners.into_iter().flatten().map(f64::abs).filter(|x| x.is_finite());
    let reach = match &shape.form {
        Form::HalfSpace { .. } => 0.0,
        Form::Ball { radius } => *radius,
        Form::Ellipsoid(axes) => largest(&axes.linear),
    };
    8.0 * SLACK * (sizes.fold(0.0, f64::max) + reach)
}
