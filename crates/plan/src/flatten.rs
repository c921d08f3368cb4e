//! The normal form becomes what a tracer reads: islands with their parts and cells, and of leaves, surfaces and materials
//! those that are left.

use std::collections::HashMap;

use scenec_scene::{DVec3, MaterialId};

use crate::cells::{Divider, holder};
use crate::frame::Place;
use crate::normal::Normal;
use crate::packed::packed_structs::{Cell, Node};
use crate::parts::Parts;
use crate::postfix::{Pruner, Token, write_out};
use crate::program::Instruction;
use crate::shapes::Shape;
use crate::terms::{Term, Terms};
use crate::{Box3, Island, Leaf, MAX_PROGRAM, Part, PlanError};

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
    pub(crate) parts: Vec<Part>,
    pub(crate) cells: Vec<Cell>,
    pub(crate) nodes: Vec<Node>,
    /// The islands before they are laid flat.
    drafts: Vec<Draft>,
}

/// An island as a tree.
#[derive(Clone, Debug)]
struct Draft {
    bounds: Box3,
    tree: Tree,
}

/// Most islands are a leaf.
#[derive(Clone, Debug)]
enum Tree {
    Leaf { leaf: u32, negative: bool },
    Tokens(Vec<Token>),
}

/// Leaves out all leaves, surfaces and materials that no island is made of; world units.
pub(crate) fn flatten(mut normal: Normal) -> Result<Flat, PlanError> {
    let (sizes, used) = survey(&normal.terms, &normal.roots, normal.leaves.len());
    let leaves = sizes.into_iter().max().unwrap_or_default();
    if leaves > MAX_PROGRAM {
        return Err(PlanError::ProgramTooLarge { leaves });
    }
    let mut flat = Flat::default();
    let numbers = flat.keep(&normal, &used);
    let bounds: Vec<_> = normal.roots.iter().map(|root| normal.terms.bounds(*root)).collect();
    for (root, bounds) in std::mem::take(&mut normal.roots).into_iter().zip(bounds) {
        let tree = match root {
            Term::Leaf { leaf, negative } => Tree::Leaf {
                leaf: numbers[leaf as usize],
                negative,
            },
            root => {
                let mut tokens = Vec::new();
                write_out(&normal.terms, root, &mut tokens);
                for token in &mut tokens {
                    if let Token::Leaf { leaf, .. } = token {
                        *leaf = numbers[*leaf as usize];
                    }
                }
                Tree::Tokens(tokens)
            }
        };
        flat.drafts.push(Draft { bounds, tree });
    }
    Ok(flat)
}

/// How many leaves each root has, every use counted, and which leaves they have.
fn survey(terms: &Terms, roots: &[Term], leaves: usize) -> (Vec<u64>, Vec<bool>) {
    let mut used = vec![false; leaves];
    let sizes = terms.sizes();
    let size = |term: &Term| match *term {
        Term::Node(node) => sizes[node as usize],
        _ => 1,
    };
    let mut seen = vec![false; sizes.len()];
    let mut open = roots.to_vec();
    while let Some(term) = open.pop() {
        match term {
            Term::Leaf { leaf, .. } => used[leaf as usize] = true,
            Term::Node(node) if !seen[node as usize] => {
                seen[node as usize] = true;
                open.extend(terms.node(term).into_iter().flat_map(|(_, operands)| operands));
            }
            _ => {}
        }
    }
    (roots.iter().map(size).collect(), used)
}

impl Flat {
    /// Takes over the used leaves with their surfaces and materials; returns the new numbers by the old ones.
    fn keep(&mut self, normal: &Normal, used: &[bool]) -> Vec<u32> {
        let (mut shapes, mut materials) = (HashMap::new(), HashMap::new());
        let mut numbers = vec![u32::MAX; used.len()];
        for (old, leaf) in normal.leaves.iter().enumerate().filter(|(old, _)| used[*old]) {
            let shape = *shapes.entry(leaf.shape).or_insert_with(|| {
                self.shapes.push(normal.shapes.list[leaf.shape as usize]);
                self.shapes.len() as u32 - 1
            });
            let material = *materials.entry(leaf.material).or_insert_with(|| {
                self.materials.push(normal.materials[leaf.material as usize]);
                self.materials.len() as u32 - 1
            });
            numbers[old] = self.leaves.len() as u32;
            self.leaves.push(Leaf {
                shape,
                material,
                ..*leaf
            });
        }
        numbers
    }

    /// The smallest box around all bounded islands, world units; empty if there is none.
    pub(crate) fn finite_bounds(&self) -> Box3 {
        let finite = self
            .drafts
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
        for island in &mut self.drafts {
            island.bounds = island.bounds.relative(place.origin, place.scale);
        }
        self
    }

    /// Makes islands of the drafts; `eye` in plan units.
    pub(crate) fn divided(mut self, eye: DVec3) -> Result<Self, PlanError> {
        let boxes: Vec<_> = self
            .leaves
            .iter()
            .map(|leaf| holder(&self.shapes[leaf.shape as usize]))
            .collect();
        // Of a half-space counts the point that is nearest to the origin.
        let place = |(bounds, leaf): (&Box3, &Leaf)| match bounds.is_finite() {
            true => *bounds,
            false => Box3::point(self.shapes[leaf.shape as usize].centre),
        };
        let places = boxes.iter().zip(&self.leaves).map(place);
        let stage = places.fold(Box3::point(eye), Box3::hull);
        let stage = Box3 {
            min: stage.min - 1.0,
            max: stage.max + 1.0,
        };
        let mut parts = Parts::default();
        let mut divider = Divider::new(Pruner::new(&self.shapes, &self.leaves), &boxes, stage);
        for Draft { bounds, tree } in std::mem::take(&mut self.drafts) {
            let (part, cells) = match tree {
                Tree::Leaf { leaf, negative } => (parts.leaf(leaf, negative), None),
                Tree::Tokens(tokens) => (parts.tree(&tokens), divider.divide(&tokens, &mut parts)),
            };
            self.islands.push(Island {
                program: part.program,
                members: part.members,
                product: part.product,
                cells,
                bounds,
            });
        }
        (self.parts, self.cells) = (divider.parts, divider.cells);
        (self.program, self.members) = (parts.program, parts.members);
        // The largest numbers that the indices and offsets of the packed form must hold.
        let counted = [
            (self.shapes.len(), "surfaces"),
            (self.program.len(), "operators"),
            (self.members.len(), "operands"),
            (self.islands.len() + self.parts.len(), "objects"),
            (self.cells.len(), "cells"),
        ];
        match counted.into_iter().find(|(count, _)| *count >= u32::MAX as usize) {
            Some((_, what)) => Err(PlanError::TooMany(what)),
            None => Ok(self),
        }
    }
}
