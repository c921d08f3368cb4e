//! From a scene to what a tracer needs and nothing more: the tree in normal form without what can't be seen, the root's
//! unions as islands, large islands divided into cells, bounds, a bounding volume hierarchy, features, and numbers relative
//! to the eye.
//!
//! It must not know pictures, OpenCL, or how a scene is written.

mod bounds;
mod bvh;
mod cells;
mod features;
mod flatten;
mod frame;
mod key;
mod layout;
mod normal;
mod numbers;
mod packed;
mod packed_parts;
mod parts;
mod postfix;
mod precision;
mod program;
mod real;
mod register;
mod shape;
mod shapes;
mod side;
mod standpoint;
mod summary;
mod terms;
mod together;
mod uses;
mod wide;

use std::fmt;

use scenec_scene::{DVec3, Material, Scene};

pub use bounds::Box3;
pub use cells::{CELL_EMPTY, CELL_FULL, CELL_PART, CELLS_DEPTH, CELLS_REACH};
pub use features::Features;
pub use frame::{Lamp, Touch, View, sample_points};
pub use layout::{Field, FieldKind, Layout};
pub use numbers::NUMBERS;
pub use packed::{LAYOUTS, Packed, packed_structs};
pub use precision::BeyondSingle;
pub use program::{Instruction, OPERATION_SHIFT, PROGRAM_DEPTH, evaluate, evaluate_product, owner};
pub use real::{Real, in_doubles, in_singles};
pub use shape::{Axes, Form, Shape, ShapeKind};
pub use standpoint::{Foothold, Standpoint};
pub use summary::{Dropped, Reason, Summary, Tiers};
pub use wide::{Child, Kind, LANES, Wide};

/// The deepest hierarchy that a plan may hold: a traversal waits with at most this many nodes.
pub const HIERARCHY_DEPTH: usize = bvh::MAX_DEPTH;

/// The most leaves that one island's program may name; a shared operand counts every time it is used.
pub const MAX_PROGRAM: u64 = 1 << 24;

/// Everything a tracer needs. Lengths are in plan units: world units times `scale`, measured from `origin`.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The camera, the picture's size, the sample points.
    pub view: View,
    /// The lights.
    pub lights: Vec<Lamp>,
    /// The surfaces that lights lie on.
    pub touches: Vec<Touch>,
    /// The materials that some leaf uses.
    pub materials: Vec<Material>,
    /// The distinct surfaces.
    pub shapes: Vec<Shape>,
    /// The distinct leaves, left before right: the lower number owns where two coincide.
    pub leaves: Vec<Leaf>,
    /// The operands of the root's unions: first the unbounded ones, then the bounded ones in the order of the hierarchy.
    pub islands: Vec<Island>,
    /// How many islands stand before those that the hierarchy holds.
    pub linear: usize,
    /// What is left of an island in a cell of space.
    pub parts: Vec<Part>,
    /// The cells of the islands that are divided; a part is named by its number among [`Plan::parts`].
    pub cells: Vec<packed_structs::Cell>,
    /// The programs of all islands and parts, one after another.
    pub program: Vec<Instruction>,
    /// The leaves (indices) that the programs name, left before right within a program.
    pub members: Vec<u32>,
    /// The hierarchy over the bounded islands; empty where a list serves better. The root is node 0, and
    /// each node stands before its children.
    pub nodes: Vec<packed_structs::Node>,
    /// Entry j bounds what a ray that may still bounce j times can bring back, any component.
    pub reach: Vec<f64>,
    /// How the eye stands to the solid.
    pub standpoint: Standpoint,
    /// The base objects of the scene that are not here.
    pub dropped: Vec<Dropped>,
    /// The point of the world that is the plan's origin.
    pub origin: DVec3,
    /// Plan units per world unit: a power of two.
    pub scale: f64,
    beyond_single: Option<BeyondSingle>,
}

/// A surface and what it is made of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Leaf {
    /// Its surface, an index of [`Plan::shapes`].
    pub shape: u32,
    /// Its material, an index of [`Plan::materials`].
    pub material: u32,
    /// The scene's number of the solid that it comes from.
    pub solid: u32,
}

/// A tree of leaves. Of a product the instructions are members and complements of members, all intersected; else they are a
/// program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    /// First and one past the last of its instructions.
    pub program: (u32, u32),
    /// First and one past the last of its members.
    pub members: (u32, u32),
    /// Whether it is a product.
    pub product: bool,
}

/// An operand of the root's unions: a tree of leaves, perhaps divided into cells of space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Island {
    /// First and one past the last of its instructions; a single leaf has one.
    pub program: (u32, u32),
    /// First and one past the last of its members.
    pub members: (u32, u32),
    /// Whether its instructions are a product's; see [`Part`].
    pub product: bool,
    /// The first of its cells, if it has any.
    pub cells: Option<u32>,
    /// What holds it.
    pub bounds: Box3,
}

/// Why there is no plan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PlanError {
    /// A tree of intersections and subtractions that shares its operands so often that, written out, it is too large.
    ProgramTooLarge {
        /// How many leaves it has, written out.
        leaves: u64,
    },
    /// More of something than 32 bits count.
    TooMany(&'static str),
    /// The camera's frame does not exist; interpretation refuses such a scene.
    NoView,
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ProgramTooLarge { leaves } => write!(
                f,
                "a combination has {leaves} base objects when each use of a shared operand is counted; at most {MAX_PROGRAM} are traced"
            ),
            Self::TooMany(what) => write!(f, "the scene has more {what} than 32 bits can count"),
            Self::NoView => f.write_str("the camera has no direction"),
        }
    }
}

impl std::error::Error for PlanError {}

/// Plans a scene.
///
/// # Errors
/// [`PlanError`] for a scene beyond the stated limits.
pub fn plan(scene: &Scene) -> Result<Plan, PlanError> {
    let uses = uses::uses(scene);
    let mut normal = normal::normalise(scene, &uses);
    let why = std::mem::take(&mut normal.terms.why);
    let flat = flatten::flatten(normal)?;
    let place = frame::place(scene, &flat)?;
    let view = frame::view(scene, &place);
    let rays = view.rays() * (1.0 + scene.lights.len() as f64);
    let flat = flat.relative(&place).divided(view.eye, rays)?;
    let (islands, beyond_single) = together::together(
        flat.leaves.len(),
        || bvh::arrange(flat.islands),
        || precision::beyond_single(&view, &flat.shapes, &flat.leaves),
    );
    let mut lights = frame::lamps(scene, &place);
    let touches = frame::touches(&mut lights, &flat.shapes);
    let materials: Vec<_> = flat.materials.iter().map(|id| *scene.material(*id)).collect();
    let kept = flat.leaves.iter().map(|leaf| leaf.solid);
    let reached = |number: usize| uses.get(number).is_some_and(|uses| *uses > 0);
    let mut plan = Plan {
        dropped: summary::dropped(scene, kept, reached, |number| why.get(&(number as u32)).copied()),
        reach: frame::reach(scene, &materials, &lights),
        standpoint: Standpoint::OUTSIDE,
        origin: place.origin,
        scale: place.scale,
        view,
        lights,
        touches,
        materials,
        shapes: flat.shapes,
        leaves: flat.leaves,
        islands: islands.list,
        linear: islands.linear,
        parts: flat.parts,
        cells: flat.cells,
        program: flat.program,
        members: flat.members,
        nodes: islands.nodes,
        beyond_single,
    };
    plan.standpoint = Standpoint::of(&plan);
    Ok(plan)
}

impl Plan {
    /// The instructions of an island.
    #[must_use]
    pub fn program_of(&self, island: &Island) -> &[Instruction] {
        &self.program[island.program.0 as usize..island.program.1 as usize]
    }

    /// Whether an island is one leaf and nothing else.
    #[must_use]
    pub fn is_leaf(&self, island: &Island) -> bool {
        matches!(self.program_of(island), [only] if only.parts().0 == 0)
    }
}
