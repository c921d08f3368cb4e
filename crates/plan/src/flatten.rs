//! The root's unions become a list of islands; what is left of the tree becomes programs.
//!
//! Every walk keeps its own stack on the heap: a chain of a million unions is a legal file.

use std::collections::{HashMap, HashSet};

use scenec_scene::{MaterialId, Op, Scene, SolidId, SolidKind};

use crate::frame::Place;
use crate::node_facts::NodeFacts;
use crate::packed::packed_structs::Node;
use crate::program::Instruction;
use crate::shapes::{Shape, Shapes};
use crate::{Box3, Island, Leaf, MAX_PROGRAM, PlanError};

/// The tree laid flat.
#[derive(Default)]
pub(crate) struct Flat {
    pub(crate) shapes: Vec<Shape>,
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) materials: Vec<MaterialId>,
    pub(crate) islands: Vec<Island>,
    pub(crate) linear: usize,
    pub(crate) program: Vec<Instruction>,
    pub(crate) members: Vec<u32>,
    pub(crate) nodes: Vec<Node>,
}

/// A solid under the outermost paint on the way to it.
type Painted = (SolidId, Option<MaterialId>);

/// What a walk finds at a solid.
enum Step {
    /// A base object.
    Leaf,
    /// Nothing but another solid.
    Inside(Painted),
    /// Two solids under an operator.
    Both(Op, SolidId, SolidId),
}

/// A solid without its wrapping: a paint is handed down, and the union or intersection of a solid with itself is that
/// solid.
fn step(scene: &Scene, (id, paint): Painted) -> Step {
    match scene.solid(id).kind {
        SolidKind::Leaf(_) => Step::Leaf,
        SolidKind::Paint { inside, material } => Step::Inside((inside, paint.or(Some(material)))),
        SolidKind::Combine { op, left, right } if left == right && op != Op::Subtraction => Step::Inside((left, paint)),
        SolidKind::Combine { op, left, right } => Step::Both(op, left, right),
    }
}

/// Lays the submitted solid flat, in world units.
pub(crate) fn flatten(scene: &Scene, facts: &[NodeFacts]) -> Result<Flat, PlanError> {
    let mut work = Work {
        scene,
        facts,
        shapes: Shapes::default(),
        interned: Interned::default(),
        flat: Flat::default(),
    };
    let mut seen = HashSet::new();
    let mut alone = HashSet::new();
    let mut open: Vec<Painted> = vec![(scene.root, None)];
    while let Some((id, paint)) = open.pop() {
        match step(scene, (id, paint)) {
            Step::Inside(painted) => open.push(painted),
            Step::Leaf => work.lone_leaf(id, paint, &mut alone),
            // A part that is there already adds nothing to a union.
            Step::Both(..) if !seen.insert((id, paint)) => {}
            Step::Both(Op::Union, left, right) => open.extend([(right, paint), (left, paint)]),
            Step::Both(..) => work.tree(id, paint)?,
        }
    }
    work.flat.shapes = work.shapes.list;
    // The largest numbers that the indices and offsets of the packed form must hold.
    let counted = [
        (work.flat.shapes.len(), "surfaces"),
        (work.flat.program.len(), "operators"),
        (work.flat.members.len(), "operands"),
        (work.flat.islands.len(), "objects"),
    ];
    match counted.into_iter().find(|(count, _)| *count >= u32::MAX as usize) {
        Some((_, what)) => Err(PlanError::TooMany(what)),
        None => Ok(work.flat),
    }
}

#[derive(Default)]
struct Interned {
    materials: HashMap<MaterialId, u32>,
    leaves: HashMap<(SolidId, MaterialId), u32>,
}

struct Work<'a> {
    scene: &'a Scene,
    facts: &'a [NodeFacts],
    shapes: Shapes,
    interned: Interned,
    flat: Flat,
}

impl Work<'_> {
    /// The number of a leaf; the solid and its material make it.
    fn leaf(&mut self, id: SolidId, paint: Option<MaterialId>) -> Option<u32> {
        let SolidKind::Leaf(leaf) = &self.scene.solid(id).kind else {
            return None;
        };
        let named = paint.unwrap_or(leaf.material);
        match self.interned.leaves.get(&(id, named)) {
            Some(known) => Some(*known),
            None => {
                let shape = self.shapes.intern(leaf.base, &self.scene.transform(leaf));
                Some(self.add(id, named, shape))
            }
        }
    }

    /// Takes up a leaf that is not there yet.
    fn add(&mut self, id: SolidId, named: MaterialId, shape: u32) -> u32 {
        let material = *self.interned.materials.entry(named).or_insert_with(|| {
            self.flat.materials.push(named);
            self.flat.materials.len() as u32 - 1
        });
        let number = self.flat.leaves.len() as u32;
        self.flat.leaves.push(Leaf {
            shape,
            material,
            solid: id.0,
        });
        self.interned.leaves.insert((id, named), number);
        number
    }

    /// A leaf of the root's unions. A second one with the same surface can't be seen: the left one owns it.
    fn lone_leaf(&mut self, id: SolidId, paint: Option<MaterialId>, alone: &mut HashSet<u32>) {
        let SolidKind::Leaf(leaf) = &self.scene.solid(id).kind else {
            return;
        };
        let named = paint.unwrap_or(leaf.material);
        let known = self.interned.leaves.get(&(id, named)).copied();
        let shape = match known {
            Some(known) => self.flat.leaves[known as usize].shape,
            None => self.shapes.intern(leaf.base, &self.scene.transform(leaf)),
        };
        if !alone.insert(shape) {
            return;
        }
        let leaf = known.unwrap_or_else(|| self.add(id, named, shape));
        let (program, members) = (self.flat.program.len() as u32, self.flat.members.len() as u32);
        self.flat.program.push(Instruction::member(0));
        self.flat.members.push(leaf);
        self.flat.islands.push(Island {
            program: (program, program + 1),
            members: (members, members + 1),
            bounds: self.facts[id.index()].bounds,
        });
    }

    /// A tree of intersections, subtractions and unions below them.
    fn tree(&mut self, id: SolidId, paint: Option<MaterialId>) -> Result<(), PlanError> {
        let NodeFacts { bounds, leaves, .. } = self.facts[id.index()];
        if leaves > MAX_PROGRAM {
            return Err(PlanError::ProgramTooLarge { leaves });
        }
        if bounds.is_empty() {
            return Ok(());
        }
        let locals = self.members((id, paint));
        let (program, members) = (self.flat.program.len() as u32, self.flat.members.len() as u32);
        self.instructions((id, paint), &locals);
        let mut order = vec![0; locals.len()];
        for (leaf, local) in &locals {
            order[*local as usize] = *leaf;
        }
        self.flat.members.extend(order);
        self.flat.islands.push(Island {
            program: (program, self.flat.program.len() as u32),
            members: (members, self.flat.members.len() as u32),
            bounds,
        });
        Ok(())
    }

    /// The leaves below a solid with their numbers within the island, which rise from left to right.
    fn members(&mut self, top: Painted) -> HashMap<u32, u32> {
        let mut locals = HashMap::new();
        let mut seen = HashSet::new();
        let mut open = vec![top];
        while let Some((id, paint)) = open.pop() {
            match step(self.scene, (id, paint)) {
                Step::Inside(painted) => open.push(painted),
                Step::Both(_, left, right) => {
                    if seen.insert((id, paint)) {
                        open.extend([(right, paint), (left, paint)]);
                    }
                }
                Step::Leaf => {
                    if let Some(leaf) = self.leaf(id, paint) {
                        let next = locals.len() as u32;
                        locals.entry(leaf).or_insert(next);
                    }
                }
            }
        }
        locals
    }

    /// Emits a solid's program, the operand that needs more bits first.
    fn instructions(&mut self, top: Painted, locals: &HashMap<u32, u32>) {
        enum Task {
            Visit(Painted),
            Emit(Instruction),
        }
        let mut open = vec![Task::Visit(top)];
        while let Some(task) = open.pop() {
            let (id, paint) = match task {
                Task::Emit(instruction) => {
                    self.flat.program.push(instruction);
                    continue;
                }
                Task::Visit(painted) => painted,
            };
            match step(self.scene, (id, paint)) {
                Step::Inside(painted) => open.push(Task::Visit(painted)),
                Step::Leaf => {
                    if let Some(local) = self.leaf(id, paint).and_then(|leaf| locals.get(&leaf)) {
                        self.flat.program.push(Instruction::member(*local));
                    }
                }
                Step::Both(op, left, right) => {
                    let swapped = self.facts[right.index()].height > self.facts[left.index()].height;
                    let (first, second) = if swapped { (right, left) } else { (left, right) };
                    let operation = match op {
                        Op::Union => Instruction::UNION,
                        Op::Intersection => Instruction::INTERSECTION,
                        Op::Subtraction => Instruction::SUBTRACTION,
                    };
                    open.push(Task::Emit(if swapped { operation.swapped() } else { operation }));
                    open.push(Task::Visit((second, paint)));
                    open.push(Task::Visit((first, paint)));
                }
            }
        }
    }
}

impl Flat {
    /// The smallest box around all bounded islands, world units; empty if there is none.
    pub(crate) fn finite_bounds(&self) -> Box3 {
        let finite = self
            .islands
            .iter()
            .map(|island| island.bounds)
            .filter(|bounds| bounds.is_finite());
        finite.fold(Box3::EMPTY, Box3::hull)
    }

    /// The same in plan units.
    pub(crate) fn relative(mut self, place: &Place) -> Self {
        for shape in &mut self.shapes {
            *shape = shape.relative(place.origin, place.scale);
        }
        for island in &mut self.islands {
            island.bounds = island.bounds.relative(place.origin, place.scale);
        }
        self
    }
}
