//! The plan as flat arrays of plain structs: what the tracers read, on this processor and on a device.
//!
//! Each struct is written once, below. The macro makes the Rust type and a description of it from which the kernels'
//! side is generated, and refuses a struct that would hold padding in either precision.

use crate::layout::{Describe, Field, Layout, Number};
use crate::wide::{Child, LANES};
use crate::{Plan, Real};

macro_rules! packed {
    ($($(#[$doc:meta])+ $name:ident $(<$real:ident>)? {
        $($(#[$field_doc:meta])+ $field:ident: $type:ty,)+
    })+) => {
        /// The structs that the tracers share.
        pub mod packed_structs {
            use super::{Child, LANES};

            $(
                $(#[$doc])+
                #[derive(Clone, Copy, PartialEq, Debug, Default)]
                #[repr(C)]
                pub struct $name $(<$real>)? {
                    $($(#[$field_doc])+ pub $field: $type,)+
                }
            )+
        }

        /// Every shared struct, in the order in which they are declared.
        pub const LAYOUTS: &[Layout] = &[$({
            $(type $real = Number;)?
            Layout {
                name: stringify!($name),
                fields: &[$(Field {
                    name: stringify!($field),
                    kind: <$type as Describe>::KIND,
                    count: <$type as Describe>::COUNT,
                },)+],
            }
        },)+];

        // A size beyond the sum of the fields would be padding, which the two sides might place differently.
        const _: () = {
            let mut i = 0;
            $(
                {
                    $(type $real = f32;)?
                    assert!(size_of::<packed_structs::$name $(<$real>)?>() == LAYOUTS[i].bytes(4));
                }
                {
                    $(type $real = f64;)?
                    assert!(size_of::<packed_structs::$name $(<$real>)?>() == LAYOUTS[i].bytes(8));
                }
                i += 1;
            )+
            assert!(i == LAYOUTS.len());
        };
    };
}

packed! {
    /// A surface.
    Shape<R> {
        /// The centre; of a half-space, the foot of the perpendicular from the origin.
        centre: [R; 3],
        /// World to object by rows; of a ball, the first is 1/radius; of a half-space, the first row is its normal.
        inverse: [R; 9],
        /// Object to world by rows; of a ball, the first is the radius.
        linear: [R; 9],
        /// 0 a ball, 1 an ellipsoid, 2 a half-space.
        kind: u32,
        /// Equal for equal surfaces.
        class: u32,
    }
    /// A surface and its material.
    Leaf {
        /// Which surface.
        shape: u32,
        /// Which material.
        material: u32,
        /// The number that the leaf layer shows.
        solid: u32,
    }
    /// An operand of the root's unions, or what is left of one in a cell.
    Island {
        /// First instruction.
        program: u32,
        /// One past the last instruction.
        program_end: u32,
        /// First member.
        members: u32,
        /// One past the last member.
        members_end: u32,
        /// 1 if the instructions are members and complements, all intersected.
        product: u32,
        /// The first of its cells, or the largest number.
        cells: u32,
    }
    /// A part of space: two cells on either side of a wall, `first` and the next, or what is there of an island.
    Cell {
        /// Where the wall stands.
        wall: f32,
        /// The axis that the wall stands on, or what is there.
        kind: u32,
        /// First of the two cells, or the number of the part among the islands.
        first: u32,
    }
    /// A node of the hierarchy: `count` islands from `first`, or two nodes, `first` and the next.
    Node {
        /// Lower corner.
        low: [f32; 3],
        /// Upper corner.
        high: [f32; 3],
        /// First island or first child.
        first: u32,
        /// How many islands; 0 for an inner node.
        count: u32,
    }
    /// Eight boxes and what is in them. A box that is not there has its corners the wrong way round, and no ray meets it.
    #[repr(align(64))]
    WideNode {
        /// Lower and then upper corners: by axis, then by child.
        bounds: [[[f32; LANES]; 3]; 2],
        /// What is in the boxes.
        children: [Child; LANES],
        /// Fills up a processor's lines of memory.
        unused: [u32; 8],
    }
    /// Up to eight balls, with all that a hit wants to know: what a ray that misses them reads stands first, and nothing has to be
    /// fetched from elsewhere.
    #[repr(align(64))]
    Block<R> {
        /// Where they are: by axis, then by ball.
        centre: [[R; LANES]; 3],
        /// The square of the radius and a thousandth more.
        reach: [R; LANES],
        /// 1 / radius.
        inverse: [R; LANES],
        /// The radius.
        radius: [R; LANES],
        /// Their leaves.
        leaf: [u32; LANES],
        /// Their classes.
        class: [u32; LANES],
        /// Their materials.
        material: [u32; LANES],
        /// A bit for each ball that is there.
        there: u32,
        /// Fills up a processor's lines of memory.
        unused: [u32; 7],
    }
    /// What a surface is made of.
    Material<R> {
        /// ka.
        ambient: R,
        /// kd.
        diffuse: R,
        /// ks.
        specular: R,
        /// kr.
        reflect: R,
        /// kt.
        refract: R,
        /// n.
        index: R,
        /// s.
        shiny: R,
        /// C.
        colour: [R; 3],
    }
    /// A point light.
    Light<R> {
        /// Where it stands.
        position: [R; 3],
        /// Its colour.
        colour: [R; 3],
        /// First of its touches.
        touches: u32,
        /// One past the last of its touches.
        touches_end: u32,
    }
    /// A surface that a light lies on.
    Touch<R> {
        /// The light on the surface's own unit sphere.
        local_point: [R; 3],
        /// The surface's class.
        class: u32,
        /// Fills up to the alignment of a double.
        unused: u32,
    }
    /// What a device says of one pixel.
    Outcome<R> {
        /// The mean of the samples.
        colour: [R; 3],
        /// The most that the dropped branches could have added.
        dropped: R,
        /// How far the first sample goes before it hits something, where distances are told.
        distance: R,
        /// The number of the solid that the first sample hits.
        solid: u32,
        /// Rays from the eye.
        primary: u32,
        /// Rays towards lights.
        shadow: u32,
        /// Rays off a mirror.
        reflected: u32,
        /// Rays through a surface.
        refracted: u32,
        /// 1 if the ray budget was met.
        over: u32,
    }
    /// What the samples of a pixel add up to on a device, in blocks of samples that follow one another.
    Sampled<R> {
        /// Sums of the blocks' first components.
        red: [R; 16],
        /// Sums of their second components.
        green: [R; 16],
        /// Sums of their third components.
        blue: [R; 16],
        /// What roundings took from the block that is being filled.
        lost: [R; 3],
        /// The least of any sample.
        low: [R; 3],
        /// The most of any sample.
        high: [R; 3],
        /// The sum of what dropped branches could have added.
        dropped: R,
        /// How many samples.
        count: u32,
        /// Whole blocks.
        whole: u32,
        /// Samples in a whole block.
        size: u32,
        /// Samples in the last block.
        filled: u32,
    }
    /// Everything there is one of.
    Frame<R> {
        /// Where the camera stands.
        eye: [R; 3],
        /// The outward unit normal of the surface that the eye is on, or zero.
        eye_normal: [R; 3],
        /// The eye on that surface's own unit sphere.
        eye_local: [R; 3],
        /// Unit view direction.
        forward: [R; 3],
        /// To the right edge.
        right: [R; 3],
        /// To the upper edge.
        up: [R; 3],
        /// Ambient light on every surface.
        ambient: [R; 3],
        /// Background straight below.
        nadir: [R; 3],
        /// Background straight above.
        zenith: [R; 3],
        /// A branch that can add less is dropped.
        cutoff: R,
        /// The most that one sample may lose that way.
        spare: R,
        /// Columns of the whole picture.
        width: u32,
        /// Rows of the whole picture.
        height: u32,
        /// First column of the window.
        window_x: u32,
        /// First row of the window.
        window_y: u32,
        /// Columns of the window.
        window_width: u32,
        /// Rows of the window.
        window_height: u32,
        /// Sample points per pixel.
        samples: u32,
        /// The most bounces of a path.
        raydepth: u32,
        /// The most rays of a pixel.
        ray_budget: u32,
        /// Islands.
        islands: u32,
        /// Islands outside the hierarchy.
        linear: u32,
        /// Lights.
        lights: u32,
        /// The class of the surface that the eye is on, or the largest number.
        eye_class: u32,
        /// 1 if that surface is a plane.
        eye_flat: u32,
        /// Plus 1 if a ray from the eye to the side of the normal runs inside the solid, plus 2 if one to the other side
        /// does.
        eye_inside: u32,
        /// Nodes of the hierarchy.
        nodes: u32,
    }
}

use packed_structs::{Cell, Frame, Island, Leaf, Light, Material, Node, Shape, Touch};

/// The plan in one precision.
#[derive(Clone, Debug)]
pub struct Packed<R> {
    /// Everything there is one of; the window is the whole picture and nothing is cut off until a tracer says so.
    pub frame: Frame<R>,
    /// Surfaces.
    pub shapes: Vec<Shape<R>>,
    /// Leaves.
    pub leaves: Vec<Leaf>,
    /// Islands, and behind them the parts that cells name.
    pub islands: Vec<Island>,
    /// Cells of islands.
    pub cells: Vec<Cell>,
    /// Instructions of all islands.
    pub program: Vec<u32>,
    /// Members of all islands.
    pub members: Vec<u32>,
    /// The hierarchy.
    pub nodes: Vec<Node>,
    /// Materials.
    pub materials: Vec<Material<R>>,
    /// Lights.
    pub lights: Vec<Light<R>>,
    /// Surfaces that lights lie on.
    pub touches: Vec<Touch<R>>,
    /// Sample points, measured from the pixel's centre.
    pub samples: Vec<[R; 2]>,
    /// Entry j bounds what a ray with j bounces left brings back.
    pub reach: Vec<R>,
}

impl Plan {
    /// The plan's numbers rounded once to the precision of a tracer.
    #[must_use]
    pub fn packed<R: Real>(&self) -> Packed<R> {
        let uint = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        Packed {
            frame: self.packed_frame(),
            shapes: self.shapes.iter().map(packed_shape).collect(),
            leaves: self
                .leaves
                .iter()
                .map(|&crate::Leaf { shape, material, solid }| Leaf { shape, material, solid })
                .collect(),
            islands: self.packed_islands(),
            cells: self.packed_cells(),
            program: self.program.iter().map(|instruction| instruction.0).collect(),
            members: self.members.clone(),
            nodes: self.nodes.clone(),
            materials: self
                .materials
                .iter()
                .map(|material| Material {
                    ambient: R::of(material.ambient),
                    diffuse: R::of(material.diffuse),
                    specular: R::of(material.specular),
                    reflect: R::of(material.reflect),
                    refract: R::of(material.refract),
                    index: R::of(material.index),
                    shiny: R::of(material.shiny),
                    colour: vector(material.colour.to_array()),
                })
                .collect(),
            lights: self.lights.iter().map(packed_light).collect(),
            touches: self
                .touches
                .iter()
                .map(|touch| Touch {
                    local_point: vector(touch.local.to_array()),
                    class: touch.class,
                    unused: 0,
                })
                .collect(),
            samples: self.view.samples.iter().map(|point| point.map(R::of)).collect(),
            reach: self.reach.iter().map(|bound| R::of(*bound)).collect(),
        }
        .counted(uint)
    }

    fn packed_frame<R: Real>(&self) -> Frame<R> {
        let (view, surface) = (&self.view, self.standpoint.surface);
        Frame {
            eye: vector(view.eye.to_array()),
            forward: vector(view.forward.to_array()),
            right: vector(view.right.to_array()),
            up: vector(view.up.to_array()),
            ambient: vector(view.ambient.to_array()),
            nadir: vector(view.nadir.to_array()),
            zenith: vector(view.zenith.to_array()),
            width: view.width,
            height: view.height,
            window_width: view.width,
            window_height: view.height,
            raydepth: view.raydepth,
            ray_budget: u32::MAX,
            islands: u32::try_from(self.islands.len()).unwrap_or(u32::MAX),
            linear: u32::try_from(self.linear).unwrap_or(u32::MAX),
            eye_class: surface.map_or(u32::MAX, |surface| surface.class),
            eye_flat: surface.map_or(0, |surface| u32::from(surface.flat)),
            eye_inside: u32::from(self.standpoint.in_front) + 2 * u32::from(self.standpoint.behind),
            eye_normal: surface.map_or([R::ZERO; 3], |surface| vector(surface.normal.to_array())),
            eye_local: surface.map_or([R::ZERO; 3], |surface| vector(surface.local.to_array())),
            ..Frame::default()
        }
    }
}

impl<R: Real> Frame<R> {
    /// Sets what one request asks for: the window's first column and row, its columns and rows, the weight below which a
    /// branch is dropped, however many there are, and the most rays of a pixel, of which there is at least one.
    pub fn ask(&mut self, corner: [u32; 2], size: [u32; 2], cutoff: f64, ray_budget: u32) {
        [self.window_x, self.window_y] = corner;
        [self.window_width, self.window_height] = size;
        (self.cutoff, self.spare) = (R::of(cutoff), R::INFINITY);
        self.ray_budget = ray_budget.max(1);
    }
}

impl<R> Packed<R> {
    fn counted(mut self, uint: impl Fn(usize) -> u32) -> Self {
        self.frame.samples = uint(self.samples.len());

        self.frame.lights = uint(self.lights.len());
        self.frame.nodes = uint(self.nodes.len());
        self
    }
}

fn packed_light<R: Real>(lamp: &crate::Lamp) -> Light<R> {
    Light {
        position: vector(lamp.position.to_array()),
        colour: vector(lamp.colour.to_array()),
        touches: lamp.touches.0,
        touches_end: lamp.touches.1,
    }
}

fn packed_shape<R: Real>(shape: &crate::Shape) -> Shape<R> {
    Shape {
        centre: vector(shape.centre.to_array()),
        inverse: vector(shape.inverse().transpose().to_cols_array()),
        linear: vector(shape.linear().transpose().to_cols_array()),
        kind: shape.kind().number(),
        class: shape.class,
    }
}

fn vector<R: Real, const N: usize>(values: [f64; N]) -> [R; N] {
    values.map(R::of)
}
