//! From the tree of solids to terms: complements pushed down to the leaves, unions and intersections as wide as they are,
//! leaves numbered from left to right.
//!
//! Every walk keeps its own stack on the heap: a chain of a million unions is a legal file.

use std::collections::{HashMap, HashSet};

use scenec_scene::{MaterialId, Op, Scene, SolidId, SolidKind};

use crate::node_facts::NodeFacts;
use crate::shapes::Shapes;
use crate::summary::Reason;
use crate::terms::{Join, LeafFacts, Term, Terms};
use crate::{Box3, Leaf};

/// The submitted solid as a union of terms.
#[derive(Default)]
pub(crate) struct Normal {
    pub(crate) shapes: Shapes,
    /// The distinct leaves, left before right.
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) materials: Vec<MaterialId>,
    pub(crate) terms: Terms,
    /// The operands of the root's unions.
    pub(crate) roots: Vec<Term>,
}

/// A solid under the outermost paint on the way to it, or its complement.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Painted {
    id: SolidId,
    paint: Option<MaterialId>,
    negative: bool,
}

/// What a walk finds at a solid.
enum Step {
    /// A base object.
    Leaf,
    /// Nothing but another solid.
    Inside(Painted),
    /// Two solids, joined.
    Both(Join, Painted, Painted),
}

/// A solid without its wrapping: a paint is handed down, as is a complement, and the union or intersection of a solid with
/// itself is that solid.
fn step(scene: &Scene, here: Painted) -> Step {
    let Painted { id, paint, negative } = here;
    match scene.solid(id).kind {
        SolidKind::Leaf(_) => Step::Leaf,
        SolidKind::Paint { inside, material } => Step::Inside(Painted {
            id: inside,
            paint: paint.or(Some(material)),
            negative,
        }),
        SolidKind::Combine { op, left, right } if left == right && op != Op::Subtraction => {
            Step::Inside(Painted { id: left, ..here })
        }
        SolidKind::Combine { op, left, right } => {
            let join = match op {
                Op::Union => Join::Union,
                Op::Intersection | Op::Subtraction => Join::Intersection,
            };
            let right = Painted {
                id: right,
                negative: negative != (op == Op::Subtraction),
                ..here
            };
            let join = if negative { join.other() } else { join };
            Step::Both(join, Painted { id: left, ..here }, right)
        }
    }
}

/// The submitted solid in normal form, world units.
pub(crate) fn normalise(scene: &Scene, facts: &[NodeFacts]) -> Normal {
    let mut work = Work {
        scene,
        facts,
        normal: Normal::default(),
        materials: HashMap::new(),
        leaves: HashMap::new(),
        known: HashMap::new(),
    };
    let mut seen = HashSet::new();
    let mut alone = HashSet::new();
    let mut open = vec![Painted {
        id: scene.root,
        paint: None,
        negative: false,
    }];
    while let Some(here) = open.pop() {
        match step(scene, here) {
            Step::Inside(inside) => open.push(inside),
            Step::Leaf => work.lone_leaf(here, &mut alone),
            // A part that is there already adds nothing to a union.
            Step::Both(..) if !seen.insert(here) => {}
            Step::Both(Join::Union, left, right) => open.extend([right, left]),
            Step::Both(..) => work.tree(here),
        }
    }
    let Normal {
        shapes, terms, roots, ..
    } = &mut work.normal;
    *roots = terms.union(shapes, std::mem::take(roots));
    work.normal
}

struct Work<'a> {
    scene: &'a Scene,
    facts: &'a [NodeFacts],
    normal: Normal,
    materials: HashMap<MaterialId, u32>,
    leaves: HashMap<(SolidId, MaterialId), u32>,
    known: HashMap<Painted, Term>,
}

impl Work<'_> {
    /// The number of a leaf; the solid and its material make it.
    fn leaf(&mut self, here: Painted) -> Option<u32> {
        let SolidKind::Leaf(leaf) = &self.scene.solid(here.id).kind else {
            return None;
        };
        let named = here.paint.unwrap_or(leaf.material);
        match self.leaves.get(&(here.id, named)) {
            Some(known) => Some(*known),
            None => {
                let shape = self.normal.shapes.intern(leaf.base, &self.scene.transform(leaf));
                Some(self.add(here.id, named, shape))
            }
        }
    }

    /// Takes up a leaf that is not there yet.
    fn add(&mut self, id: SolidId, named: MaterialId, shape: u32) -> u32 {
        let Normal {
            materials,
            leaves,
            terms,
            ..
        } = &mut self.normal;
        let material = *self.materials.entry(named).or_insert_with(|| {
            materials.push(named);
            materials.len() as u32 - 1
        });
        let complement = match &self.scene.solid(id).kind {
            SolidKind::Leaf(leaf) => Box3::of_complement(leaf.base, &self.scene.transform(leaf)),
            _ => Box3::ALL,
        };
        let solid = id.0;
        let number = leaves.len() as u32;
        leaves.push(Leaf { shape, material, solid });
        terms.leaves.push(LeafFacts {
            shape,
            solid,
            bounds: [self.facts[id.index()].bounds, complement],
        });
        self.leaves.insert((id, named), number);
        number
    }

    /// A leaf of the root's unions. A second one with the same surface can't be seen: the left one owns it.
    fn lone_leaf(&mut self, here: Painted, alone: &mut HashSet<u32>) {
        let SolidKind::Leaf(leaf) = &self.scene.solid(here.id).kind else {
            return;
        };
        let named = here.paint.unwrap_or(leaf.material);
        let known = self.leaves.get(&(here.id, named)).copied();
        let shape = match known {
            Some(known) => self.normal.leaves[known as usize].shape,
            None => self.normal.shapes.intern(leaf.base, &self.scene.transform(leaf)),
        };
        if !alone.insert(shape) {
            self.normal.terms.why.entry(here.id.0).or_insert(Reason::Twin);
            return;
        }
        let leaf = known.unwrap_or_else(|| self.add(here.id, named, shape));
        let negative = here.negative;
        self.normal.roots.push(Term::Leaf { leaf, negative });
    }

    /// An operand of the root's unions that is more than a leaf.
    fn tree(&mut self, top: Painted) {
        let term = self.term(top);
        if term != Term::Nothing {
            self.normal.roots.push(term);
        }
    }

    fn term(&mut self, top: Painted) -> Term {
        enum Task {
            Visit(Painted),
            Join(Painted, Join, Vec<Painted>),
        }
        let mut open = vec![Task::Visit(top)];
        while let Some(task) = open.pop() {
            match task {
                Task::Visit(here) if self.known.contains_key(&here) => {}
                Task::Visit(here) => {
                    let Step::Both(join, ..) = step(self.scene, here) else {
                        self.operand(here);
                        continue;
                    };
                    let operands = self.operands(join, here);
                    let visits: Vec<_> = operands.iter().rev().map(|operand| Task::Visit(*operand)).collect();
                    open.push(Task::Join(here, join, operands));
                    open.extend(visits);
                }
                Task::Join(here, join, operands) => {
                    let operands = operands.iter().map(|operand| self.operand(*operand)).collect();
                    let term = self.normal.terms.join(&self.normal.shapes, join, operands);
                    self.known.insert(here, term);
                }
            }
        }
        self.operand(top)
    }

    /// The term of a leaf, or of a combination that is known.
    fn operand(&mut self, here: Painted) -> Term {
        let negative = here.negative;
        match self.known.get(&here) {
            Some(known) => *known,
            None => self
                .leaf(here)
                .map_or(Term::Nothing, |leaf| Term::Leaf { leaf, negative }),
        }
    }

    /// The operands of a join, left before right. What is joined the same way further in is taken apart unless it is shared:
    /// written out at each of its uses, a shared chain would be quadratic.
    fn operands(&self, join: Join, top: Painted) -> Vec<Painted> {
        let mut operands = Vec::new();
        let mut open = vec![top];
        while let Some(here) = open.pop() {
            match step(self.scene, here) {
                Step::Inside(inside) => open.push(inside),
                Step::Both(inner, left, right)
                    if inner == join && (here == top || self.facts[here.id.index()].uses <= 1) =>
                {
                    open.extend([right, left]);
                }
                _ => operands.push(here),
            }
        }
        operands
    }
}
