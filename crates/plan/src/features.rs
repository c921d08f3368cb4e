//! What a scene needs of a tracer: the one door through which anything is specialised.

use scenec_scene::Material;

use crate::bvh::MAX_DEPTH;
use crate::cells::CELLS_DEPTH;
use crate::{Plan, ShapeKind};

/// Which parts of a tracer a scene needs. What is off may be left out of the code without any change to the picture.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Features {
    /// Some surface is a ball.
    pub balls: bool,
    /// Some surface is an ellipsoid.
    pub ellipsoids: bool,
    /// Some surface is a plane.
    pub half_spaces: bool,
    /// Some island is more than a leaf: an intersection of leaves and complements of leaves, if nothing else.
    pub products: bool,
    /// Some island, or what is left of one in a cell, needs a program.
    pub programs: bool,
    /// Some island is divided into cells.
    pub cells: bool,
    /// There is a hierarchy.
    pub hierarchy: bool,
    /// Rays are followed eight together, through a hierarchy with eight boxes to a node and eight balls to a leaf, as suits
    /// processors.
    pub eights: bool,
    /// There are lights, hence shadow rays.
    pub lights: bool,
    /// Some light lies on a surface.
    pub touches: bool,
    /// Some material shows highlights.
    pub highlights: bool,
    /// Some ray may be mirrored.
    pub reflections: bool,
    /// Some ray may go through a surface.
    pub refractions: bool,
    /// One hit may send out two rays, so that some must wait.
    pub branching: bool,
    /// Some ray may run inside the solid.
    pub inside: bool,
    /// Pixels have more than one sample.
    pub supersampling: bool,
    /// Distances are told too; no picture needs them.
    pub distances: bool,
    /// It is told how far a pixel's samples are apart; no picture needs that either.
    pub spread: bool,
    /// How many rays may wait, rounded up to a power of two; 1 where none does.
    pub waiting: u32,
    /// Room for the members of the largest island, rounded up to a power of two; 0 where they are computed anew instead.
    pub members: u32,
}

/// More members than this would fill a device's registers and spill into slow memory.
const MOST_MEMBERS: usize = 64;

impl Features {
    /// What this plan needs.
    #[must_use]
    pub fn of(plan: &Plan) -> Self {
        let bounces = plan.view.raydepth > 0;
        let any_shape = |kind| plan.shapes.iter().any(|shape| shape.kind() == kind);
        let any_material = |test: fn(&Material) -> bool| plan.materials.iter().any(test);
        let refractions = bounces && any_material(|material| material.refract != 0.0);
        let branching = bounces && any_material(|material| material.refract != 0.0 && material.reflect != 0.0);
        // What is divided is evaluated as a whole only for rays from far away.
        let whole = plan.islands.iter().filter(|island| island.cells.is_none());
        let kept = whole
            .map(|island| island.members)
            .chain(plan.parts.iter().map(|part| part.members));
        let largest = kept.map(|members| (members.1 - members.0) as usize).max().unwrap_or(0);
        Self {
            balls: any_shape(ShapeKind::Ball),
            ellipsoids: any_shape(ShapeKind::Ellipsoid),
            half_spaces: any_shape(ShapeKind::HalfSpace),
            products: plan
                .islands
                .iter()
                .any(|island| island.product && !plan.is_leaf(island)),
            programs: plan.islands.iter().any(|island| !island.product) || plan.parts.iter().any(|part| !part.product),
            cells: !plan.cells.is_empty(),
            hierarchy: !plan.nodes.is_empty(),
            eights: false,
            lights: !plan.lights.is_empty(),
            touches: !plan.touches.is_empty(),
            highlights: !plan.lights.is_empty() && any_material(|material| material.specular != 0.0),
            // Total reflection mirrors too.
            reflections: bounces && any_material(|material| material.reflect != 0.0 || material.refract != 0.0),
            refractions,
            branching,
            inside: plan.standpoint.in_front || plan.standpoint.behind || refractions,
            supersampling: plan.view.samples.len() > 1,
            distances: false,
            spread: false,
            waiting: if branching {
                plan.view.raydepth.next_power_of_two()
            } else {
                1
            },
            members: if largest > 1 && largest <= MOST_MEMBERS {
                largest.next_power_of_two() as u32
            } else {
                0
            },
        }
    }

    /// The tracer that serves every scene of this plan's ray depth.
    #[must_use]
    pub fn generic(plan: &Plan) -> Self {
        Self {
            balls: true,
            ellipsoids: true,
            half_spaces: true,
            products: true,
            programs: true,
            cells: true,
            hierarchy: true,
            eights: false,
            lights: true,
            touches: true,
            highlights: true,
            reflections: true,
            refractions: true,
            branching: true,
            inside: true,
            supersampling: true,
            distances: false,
            spread: false,
            waiting: plan.view.raydepth.max(1).next_power_of_two(),
            members: 0,
        }
    }

    /// Names and values for a kernel's source, and for people.
    #[must_use]
    pub fn list(&self) -> [(&'static str, u32); 22] {
        [
            ("BALLS", self.balls.into()),
            ("ELLIPSOIDS", self.ellipsoids.into()),
            ("HALF_SPACES", self.half_spaces.into()),
            ("PRODUCTS", self.products.into()),
            ("PROGRAMS", self.programs.into()),
            ("CELLS", self.cells.into()),
            ("HIERARCHY", self.hierarchy.into()),
            ("EIGHTS", self.eights.into()),
            ("LIGHTS", self.lights.into()),
            ("TOUCHES", self.touches.into()),
            ("HIGHLIGHTS", self.highlights.into()),
            ("REFLECTIONS", self.reflections.into()),
            ("REFRACTIONS", self.refractions.into()),
            ("BRANCHING", self.branching.into()),
            ("INSIDE", self.inside.into()),
            ("SUPERSAMPLING", self.supersampling.into()),
            ("DISTANCES", self.distances.into()),
            ("SPREAD", self.spread.into()),
            ("WAITING", self.waiting),
            ("MEMBERS", self.members),
            ("HIERARCHY_DEPTH", MAX_DEPTH as u32),
            ("CELLS_DEPTH", CELLS_DEPTH as u32),
        ]
    }
}
