//! A plan in the memory of a device, and how it is handed to the kernel.

use scenec_plan::{Child, Features, Packed, Real, Wide, packed_structs};

use crate::buffer::{Arg, Buffer};
use crate::calls::Plain;
use crate::error::DeviceError;
use crate::session::Session;

/// The plan in the device's memory.
pub(crate) struct Scene<R> {
    shapes: Buffer<packed_structs::Shape<R>>,
    leaves: Buffer<packed_structs::Leaf>,
    islands: Buffer<packed_structs::Island>,
    cells: Buffer<packed_structs::Cell>,
    program: Buffer<u32>,
    members: Buffer<u32>,
    hierarchy: Hierarchy<R>,
    materials: Buffer<packed_structs::Material<R>>,
    lights: Buffer<packed_structs::Light<R>>,
    touches: Buffer<packed_structs::Touch<R>>,
    samples: Buffer<[R; 2]>,
    reach: Buffer<R>,
}

/// What a ray finds islands by.
enum Hierarchy<R> {
    Pairs(Buffer<packed_structs::Node>),
    Eights {
        nodes: Buffer<packed_structs::WideNode>,
        blocks: Buffer<packed_structs::Block<R>>,
        runs: Buffer<[u32; 2]>,
        start: Buffer<Child>,
    },
}

impl<R: Real + Plain> Hierarchy<R> {
    fn upload(session: &Session, packed: &Packed<R>, features: &Features) -> Result<Self, DeviceError> {
        if !features.eights {
            return Ok(Self::Pairs(session.upload(&packed.nodes)?));
        }
        let wide = Wide::new(packed);
        Ok(Self::Eights {
            nodes: session.upload(&wide.nodes)?,
            blocks: session.upload(&wide.blocks)?,
            runs: session.upload(&wide.runs)?,
            start: session.upload(&wide.start)?,
        })
    }

    fn args(&self) -> Vec<Arg<'_>> {
        match self {
            Self::Pairs(nodes) => vec![nodes.into()],
            Self::Eights {
                nodes,
                blocks,
                runs,
                start,
            } => vec![
                nodes.into(),
                blocks.into(),
                runs.into(),
                start.into(),
                (start.len() as u32).into(),
            ],
        }
    }
}

impl<R: Real + Plain> Scene<R> {
    /// Copies what a program with these features reads.
    ///
    /// # Errors
    /// The device can't hold it.
    pub(crate) fn upload(session: &Session, packed: &Packed<R>, features: &Features) -> Result<Self, DeviceError> {
        Ok(Self {
            shapes: session.upload(&packed.shapes)?,
            leaves: session.upload(&packed.leaves)?,
            islands: session.upload(&packed.islands)?,
            cells: session.upload(&packed.cells)?,
            program: session.upload(&packed.program)?,
            members: session.upload(&packed.members)?,
            hierarchy: Hierarchy::upload(session, packed, features)?,
            materials: session.upload(&packed.materials)?,
            lights: session.upload(&packed.lights)?,
            touches: session.upload(&packed.touches)?,
            samples: session.upload(&packed.samples)?,
            reach: session.upload(&packed.reach)?,
        })
    }

    /// The arguments of the kernel up to where the outcomes go.
    pub(crate) fn args<'a>(&'a self, frame: &'a Buffer<packed_structs::Frame<R>>) -> Vec<Arg<'a>> {
        let mut args = vec![
            frame.into(),
            (&self.shapes).into(),
            (&self.leaves).into(),
            (&self.islands).into(),
            (&self.cells).into(),
            (&self.program).into(),
            (&self.members).into(),
        ];
        args.extend(self.hierarchy.args());
        args.extend::<[Arg<'_>; 5]>([
            (&self.materials).into(),
            (&self.lights).into(),
            (&self.touches).into(),
            (&self.samples).into(),
            (&self.reach).into(),
        ]);
        args
    }
}
