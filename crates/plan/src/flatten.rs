//! The normal form becomes what a tracer reads: islands with their parts and cells, and of leaves, surfaces and materials
//! those that are left.

use scenec_scene::{DVec3, MaterialId};

use crate::cells::{Divider, Stage, holder};
use crate::frame::Place;
use crate::normal::Normal;
use crate::packed::packed_structs::Cell;
use crate::parts::Parts;
use crate::postfix::{Token, write_out};
use crate::program::Instruction;
use crate::shape::Shape;
use crate::terms::{Term, Terms};
use crate::{Box3, Island, Leaf, MAX_PROGRAM, Part, PlanError};

/// The tree laid flat.
#[derive(Default)]
pub(crate) struct Flat {
    pub(crate) shapes: Vec<Shape>,
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) materials: Vec<MaterialId>,
    pub(crate) islands: Vec<Island>,
    pub(crate) program: Vec<Instruction>,
    pub(crate) members: Vec<u32>,
    pub(crate) parts: Vec<Part>,
    pub(crate) cells: Vec<Cell>,
    /// The trees of those islands that are more than a leaf, by island.
    trees: Vec<(usize, Vec<Token>)>,
}

/// Leaves out all leaves, surfaces and materials that no island is made of; world units.
pub(crate) fn flatten(normal: Normal) -> Result<Flat, PlanError> {
    let Normal {
        shapes,
        mut leaves,
        mut materials,
        terms,
        roots,
    } = normal;
    let (sizes, used) = survey(&terms, &roots, leaves.len());
    let most = sizes.into_iter().max().unwrap_or_default();
    if most > MAX_PROGRAM {
        return Err(PlanError::ProgramTooLarge { leaves: most });
    }
    let numbers = keep(&mut leaves, &used);
    let mut shapes = shapes.list;
    let named = |count: usize, of: fn(&Leaf) -> u32| {
        let mut named = vec![false; count];
        leaves.iter().for_each(|leaf| named[of(leaf) as usize] = true);
        named
    };
    let named_shapes = named(shapes.len(), |leaf| leaf.shape);
    let named_materials = named(materials.len(), |leaf| leaf.material);
    let shape_numbers = keep(&mut shapes, &named_shapes);
    let material_numbers = keep(&mut materials, &named_materials);
    for leaf in &mut leaves {
        leaf.shape = shape_numbers[leaf.shape as usize];
        leaf.material = material_numbers[leaf.material as usize];
    }
    let mut flat = Flat {
        shapes,
        leaves,
        materials,
        ..Flat::default()
    };
    flat.islands(&terms, &roots, &numbers);
    Ok(flat)
}

/// Leaves only what is used; returns the new numbers by the old ones.
fn keep<T>(list: &mut Vec<T>, used: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let numbers = used.iter().map(|used| {
        next += u32::from(*used);
        // What is not kept has no number.
        if *used { next - 1 } else { u32::MAX }
    });
    let numbers = numbers.collect();
    let mut used = used.iter();
    list.retain(|_| used.next().copied().unwrap_or_default());
    numbers
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
    /// Makes islands of the root's operands; a leaf goes by its new number.
    fn islands(&mut self, terms: &Terms, roots: &[Term], numbers: &[u32]) {
        let mut parts = Parts::default();
        self.islands.reserve_exact(roots.len());
        for root in roots {
            let part = match *root {
                Term::Leaf { leaf, negative } => parts.leaf(numbers[leaf as usize], negative),
                root => {
                    let mut tokens = Vec::new();
                    write_out(terms, root, &mut tokens);
                    for token in &mut tokens {
                        if let Token::Leaf { leaf, .. } = token {
                            *leaf = numbers[*leaf as usize];
                        }
                    }
                    let part = parts.tree(&tokens);
                    self.trees.push((self.islands.len(), tokens));
                    part
                }
            };
            self.islands.push(Island {
                program: part.program,
                members: part.members,
                product: part.product,
                cells: None,
                bounds: terms.bounds(*root),
            });
        }
        (self.program, self.members) = (parts.program, parts.members);
    }

    /// The smallest box around all bounded islands, world units; empty if there is none.
    pub(crate) fn finite_bounds(&self) -> Box3 {
        let boxes = self.islands.iter().map(|island| island.bounds);
        boxes.filter(|bounds| bounds.is_finite()).fold(Box3::EMPTY, Box3::hull)
    }

    /// The same in plan units.
    pub(crate) fn relative(mut self, place: &Place) -> Self {
        for shape in &mut self.shapes {
            shape.relate(place.origin, place.scale);
        }
        for island in &mut self.islands {
            island.bounds = island.bounds.relative(place.origin, place.scale);
        }
        self
    }

    /// Divides islands that are large trees into cells; `eye` in plan units, `rays` about how many there are.
    pub(crate) fn divided(mut self, eye: DVec3, rays: f64) -> Result<Self, PlanError> {
        let trees = std::mem::take(&mut self.trees);
        if !trees.is_empty() {
            self.divide(&trees, eye, rays);
        }
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

    fn divide(&mut self, trees: &[(usize, Vec<Token>)], eye: DVec3, rays: f64) {
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
        let bounds = places.fold(Box3::point(eye), Box3::hull);
        let stage = Stage {
            shapes: &self.shapes,
            leaves: &self.leaves,
            boxes: &boxes,
            bounds: Box3 {
                min: bounds.min - 1.0,
                max: bounds.max + 1.0,
            },
            rays,
        };
        let mut parts = Parts {
            program: std::mem::take(&mut self.program),
            members: std::mem::take(&mut self.members),
        };
        let mut divider = Divider::new(stage);
        for (island, tokens) in trees {
            self.islands[*island].cells = divider.divide(tokens, &mut parts);
        }
        (self.parts, self.cells) = (divider.parts, divider.cells);
        (self.program, self.members) = (parts.program, parts.members);
    }
}
