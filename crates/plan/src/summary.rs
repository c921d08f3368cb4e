//! What a plan keeps of its scene, what it leaves out and why, as plain data for people.

use std::fmt;

use scenec_scene::{Scene, SolidKind};

use crate::packed::{LAYOUTS, packed_structs};
use crate::{Plan, Real};

/// Why a base object is not in the plan.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Reason {
    /// The submitted solid is not made of it.
    Unreached,
    /// It has the same points as one to its left, which is seen in its place.
    Twin,
    /// What it is a part of holds no point.
    Nothing,
    /// It lies within something else that it is united with, or cuts what is cut already.
    Covered,
    /// What it would cut or be taken from lies elsewhere.
    Idle,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Unreached => "not part of the submitted object",
            Self::Twin => "the same as another one",
            Self::Nothing => "part of something that holds no point",
            Self::Covered => "covered by others",
            Self::Idle => "cuts nothing off",
        })
    }
}

/// Base objects that were left out for one reason.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dropped {
    /// Why.
    pub reason: Reason,
    /// How many.
    pub count: usize,
    /// The scene's number of the first of them.
    pub solid: u32,
}

/// How many islands are evaluated in which way, from the cheapest to the dearest.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Tiers {
    /// A base object and nothing else.
    pub single: usize,
    /// Base objects and complements of them, intersected: no program is needed.
    pub products: usize,
    /// A program over all of its leaves.
    pub programs: usize,
    /// Cells in space, each with what is left of the tree there.
    pub divided: usize,
}

/// The figures of a plan.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Summary {
    /// Base objects in the scene.
    pub leaves: usize,
    /// Those that are left.
    pub kept: usize,
    /// Why the others are not.
    pub dropped: Vec<Dropped>,
    /// Distinct surfaces.
    pub shapes: usize,
    /// Operands of the root's unions.
    pub islands: usize,
    /// How they are evaluated.
    pub tiers: Tiers,
    /// Cells of the islands that are divided.
    pub cells: usize,
    /// Nodes of the hierarchy over the islands.
    pub nodes: usize,
    /// Bytes of the plan as a tracer holds it in single precision.
    pub bytes: u64,
}

impl Plan {
    /// What the plan keeps and leaves out.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let dropped: usize = self.dropped.iter().map(|dropped| dropped.count).sum();
        let mut solids: Vec<_> = self.leaves.iter().map(|leaf| leaf.solid).collect();
        solids.sort_unstable();
        solids.dedup();
        Summary {
            leaves: solids.len() + dropped,
            kept: solids.len(),
            dropped: self.dropped.clone(),
            shapes: self.shapes.len(),
            islands: self.islands.len(),
            tiers: self.tiers(),
            cells: self.cells.len(),
            nodes: self.nodes.len(),
            bytes: self.bytes::<f32>(),
        }
    }

    fn tiers(&self) -> Tiers {
        let mut tiers = Tiers::default();
        for island in &self.islands {
            *match island.program.1 - island.program.0 {
                _ if island.cells.is_some() => &mut tiers.divided,
                1 => &mut tiers.single,
                _ if island.product => &mut tiers.products,
                _ => &mut tiers.programs,
            } += 1;
        }
        tiers
    }

    /// What the plan's arrays take in a tracer of this precision.
    fn bytes<R: Real>(&self) -> u64 {
        let real = size_of::<R>();
        let of = |name: &str| {
            LAYOUTS
                .iter()
                .find(|layout| layout.name == name)
                .map_or(0, |layout| layout.bytes(real))
        };
        let sizes = [
            (1, of("Frame")),
            (self.shapes.len(), of("Shape")),
            (self.leaves.len(), of("Leaf")),
            (self.islands.len() + self.parts.len(), of("Island")),
            (self.cells.len(), of("Cell")),
            (self.program.len(), size_of::<u32>()),
            (self.members.len(), size_of::<u32>()),
            (self.nodes.len(), size_of::<packed_structs::Node>()),
            (self.materials.len(), of("Material")),
            (self.lights.len(), of("Light")),
            (self.touches.len(), of("Touch")),
            (self.view.samples.len(), 2 * real),
            (self.reach.len(), real),
        ];
        sizes
            .into_iter()
            .map(|(count, bytes)| count as u64 * bytes as u64)
            .sum()
    }
}

/// Counts the base objects of a scene that no leaf of the plan comes from. `why` is the reason that was found for a solid
/// on the way, and `reached` whether the submitted one is made of it.
pub(crate) fn dropped(
    scene: &Scene,
    kept: impl IntoIterator<Item = u32>,
    reached: impl Fn(usize) -> bool,
    why: impl Fn(usize) -> Option<Reason>,
) -> Vec<Dropped> {
    let mut there = vec![false; scene.solids.len()];
    for solid in kept {
        there[solid as usize] = true;
    }
    let mut dropped: Vec<Dropped> = Vec::new();
    for (number, solid) in scene.solids.iter().enumerate() {
        if there[number] || !matches!(solid.kind, SolidKind::Leaf(_)) {
            continue;
        }
        let reason = if reached(number) {
            why(number).unwrap_or(Reason::Nothing)
        } else {
            Reason::Unreached
        };
        match dropped.iter_mut().find(|dropped| dropped.reason == reason) {
            Some(known) => known.count += 1,
            None => dropped.push(Dropped {
                reason,
                count: 1,
                solid: number as u32,
            }),
        }
    }
    dropped.sort_by_key(|dropped| dropped.reason);
    dropped
}
