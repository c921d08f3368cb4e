//! From the tree of solids to terms: complements pushed down to the leaves, unions and intersections as wide as they are,
//! leaves numbered from left to right.
//!
//! Every walk keeps its own stack on the heap: a chain of a million unions is a legal file.

use hashbrown::{HashMap, HashSet};

use scenec_scene::{Base, MaterialId, Op, Scene, Solid, SolidId, SolidKind};

use crate::register::AT_ONCE;
use crate::shapes::{Shapes, Sought};
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

impl Normal {
    /// Of nothing so far, with room for so many leaves: lists that grow are moved, and take memory anew each time.
    fn with_room(room: usize) -> Self {
        Self {
            shapes: Shapes::with_room(room),
            leaves: Vec::with_capacity(room),
            terms: Terms::with_room(room),
            ..Self::default()
        }
    }
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
pub(crate) fn normalise(scene: &Scene, uses: &[u32]) -> Normal {
    let leaf = |(solid, uses): (&Solid, &u32)| *uses > 0 && matches!(solid.kind, SolidKind::Leaf(_));
    let room = scene.solids.iter().zip(uses).filter(|both| leaf(*both)).count();
    let mut work = Work {
        scene,
        uses,
        normal: Normal::with_room(room),
        materials: HashMap::new(),
        leaves: Leaves {
            own: vec![NONE; uses.len()],
            painted: HashMap::new(),
        },
        known: HashMap::new(),
        alone: Vec::new(),
    };
    let mut seen = HashSet::new();
    let mut lone = Vec::with_capacity(AT_ONCE);
    let mut open = vec![Painted {
        id: scene.root,
        paint: None,
        negative: false,
    }];
    while let Some(here) = open.pop() {
        match step(scene, here) {
            Step::Inside(inside) => open.push(inside),
            Step::Leaf => {
                lone.push(here);
                if lone.len() == AT_ONCE {
                    work.lone_leaves(&mut lone);
                }
            }
            // A part that is there already adds nothing to a union.
            Step::Both(..) if uses[here.id.index()] > 1 && !seen.insert(here) => {}
            Step::Both(Join::Union, left, right) => open.extend([right, left]),
            Step::Both(..) => {
                work.lone_leaves(&mut lone);
                work.tree(here);
            }
        }
    }
    work.lone_leaves(&mut lone);
    let Normal {
        shapes, terms, roots, ..
    } = &mut work.normal;
    *roots = terms.union(shapes, std::mem::take(roots));
    work.normal
}

/// No leaf.
const NONE: u32 = u32::MAX;

/// The numbers of leaves: the solid and its paint make one. Few scenes have paint.
struct Leaves {
    /// Without paint, by solid.
    own: Vec<u32>,
    painted: HashMap<(SolidId, MaterialId), u32>,
}

impl Leaves {
    fn get(&self, id: SolidId, paint: Option<MaterialId>) -> Option<u32> {
        match paint {
            None => Some(self.own[id.index()]).filter(|number| *number != NONE),
            Some(paint) => self.painted.get(&(id, paint)).copied(),
        }
    }

    fn insert(&mut self, id: SolidId, paint: Option<MaterialId>, number: u32) {
        match paint {
            None => self.own[id.index()] = number,
            Some(paint) => {
                self.painted.insert((id, paint), number);
            }
        }
    }
}

/// A paint that changes something.
fn paint(here: Painted, leaf: &scenec_scene::Leaf) -> Option<MaterialId> {
    here.paint.filter(|paint| *paint != leaf.material)
}

struct Work<'a> {
    scene: &'a Scene,
    uses: &'a [u32],
    normal: Normal,
    materials: HashMap<MaterialId, u32>,
    leaves: Leaves,
    known: HashMap<Painted, Term>,
    /// Of each surface, whether a leaf of the root's unions has it.
    alone: Vec<bool>,
}

impl Work<'_> {
    /// The number of a leaf; the solid and its material make it.
    fn leaf(&mut self, here: Painted) -> Option<u32> {
        let SolidKind::Leaf(leaf) = &self.scene.solid(here.id).kind else {
            return None;
        };
        if let Some(known) = self.leaves.get(here.id, paint(here, leaf)) {
            return Some(known);
        }
        let (sought, bounds) = self.look(leaf);
        let shape = self.normal.shapes.intern(sought);
        Some(self.add(here, leaf, bounds, shape))
    }

    /// The surface of a leaf as it is looked for, and the leaf's box.
    fn look(&self, leaf: &scenec_scene::Leaf) -> (Sought, Box3) {
        let transform = self.scene.transform(leaf);
        let sought = self.normal.shapes.sought(leaf.base, &transform);
        (sought, Box3::of_leaf(leaf.base, &transform))
    }

    /// Takes up a leaf that is not there yet.
    fn add(&mut self, here: Painted, leaf: &scenec_scene::Leaf, bounds: Box3, shape: u32) -> u32 {
        let named = here.paint.unwrap_or(leaf.material);
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
        let solid = here.id.0;
        let number = leaves.len() as u32;
        if leaf.base == Base::HalfSpace {
            let transform = self.scene.transform(leaf);
            let complement = Box3::of_complement(leaf.base, &transform);
            terms.complements.insert(number, complement);
        }
        leaves.push(Leaf { shape, material, solid });
        terms.leaves.push(LeafFacts { shape, solid, bounds });
        self.leaves.insert(here.id, paint(here, leaf), number);
        number
    }

    /// Takes leaves of the root's unions out of a list.
    fn lone_leaves(&mut self, list: &mut Vec<Painted>) {
        let scene = self.scene;
        let mut looked: Vec<_> = Vec::with_capacity(list.len());
        for here in list.drain(..) {
            if let SolidKind::Leaf(leaf) = &scene.solid(here.id).kind {
                looked.push((here, leaf, self.look(leaf)));
            }
        }
        let shapes = &self.normal.shapes;
        looked.iter().for_each(|(_, _, (sought, _))| shapes.expect(sought));
        for (here, leaf, (sought, bounds)) in looked {
            self.lone_leaf(here, leaf, sought, bounds);
        }
    }

    /// A leaf of the root's unions. A second one with the same surface can't be seen: the left one owns it.
    fn lone_leaf(&mut self, here: Painted, leaf: &scenec_scene::Leaf, sought: Sought, bounds: Box3) {
        let known = self.leaves.get(here.id, paint(here, leaf));
        let shape = match known {
            Some(known) => self.normal.leaves[known as usize].shape,
            None => self.normal.shapes.intern(sought),
        };
        self.alone.resize(self.normal.shapes.list.len(), false);
        if std::mem::replace(&mut self.alone[shape as usize], true) {
            self.normal.terms.why.entry(here.id.0).or_insert(Reason::Twin);
            return;
        }
        let leaf = known.unwrap_or_else(|| self.add(here, leaf, bounds, shape));
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
                Step::Both(inner, left, right) if inner == join && (here == top || self.uses[here.id.index()] <= 1) => {
                    open.extend([right, left]);
                }
                _ => operands.push(here),
            }
        }
        operands
    }
}
