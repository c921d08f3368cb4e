//! How the eye stands to the solid: inside, outside, or on a surface.

use scenec_scene::DVec3;

use crate::{Plan, ShapeKind, program};

/// Where rays from the eye start. An eye on a surface is inside on one side of it and perhaps not on the other, and the
/// surface must not stop a ray that leaves it only because the eye's coordinates are rounded.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Standpoint {
    /// The surface that the eye is on, if it is on one; the first of several.
    pub surface: Option<Foothold>,
    /// Whether a ray from the eye runs inside the solid at first, if it goes to the side of the surface's normal.
    pub in_front: bool,
    /// The same for the other side.
    pub behind: bool,
}

/// A place on a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Foothold {
    /// The surface's class.
    pub class: u32,
    /// Whether the surface is a plane.
    pub flat: bool,
    /// The place on the surface's own unit sphere; of no meaning for a plane.
    pub local: DVec3,
    /// The outward unit normal there.
    pub normal: DVec3,
}

impl Standpoint {
    /// In the open.
    pub(crate) const OUTSIDE: Self = Self {
        surface: None,
        in_front: false,
        behind: false,
    };

    /// How the eye of a plan stands.
    pub(crate) fn of(plan: &Plan) -> Self {
        let eye = plan.view.eye;
        let surface = plan.shapes.iter().find_map(|shape| {
            let local = shape.touched_by(eye)?;
            let flat = shape.kind() == ShapeKind::HalfSpace;
            let normal = if flat {
                shape.normal()
            } else {
                (shape.inverse().transpose() * local).normalize()
            };
            Some(Foothold {
                class: shape.class,
                flat,
                local,
                normal,
            })
        });
        Self {
            surface,
            in_front: holds(plan, surface, false),
            behind: holds(plan, surface, true),
        }
    }
}

/// Whether the solid holds the eye, or the points next to it on one side of the surface that it is on.
fn holds(plan: &Plan, surface: Option<Foothold>, behind: bool) -> bool {
    let eye = plan.view.eye;
    plan.islands.iter().any(|island| {
        let members = &plan.members[island.members.0 as usize..island.members.1 as usize];
        let leaf_holds = |local: u32| {
            let leaf = plan.leaves[members[local as usize] as usize];
            let shape = &plan.shapes[leaf.shape as usize];
            match surface.filter(|surface| surface.class == shape.class) {
                // A plane's two half-spaces are of one class.
                Some(surface) if surface.flat => (shape.normal().dot(surface.normal) > 0.0) == behind,
                Some(_) => behind,
                None => shape.holds(eye),
            }
        };
        let program = plan.program_of(island).iter().copied();
        let holds = || match island.product {
            true => program::evaluate_product(program, leaf_holds),
            false => program::evaluate(program, leaf_holds),
        };
        island.bounds.holds(eye) && holds()
    })
}
