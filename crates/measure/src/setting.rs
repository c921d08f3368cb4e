//! What a picture is traced with.

use scenec_device::{DeviceInfo, Precision};
use scenec_picture::Limits;
use scenec_scene::Scene;

/// What computes.
#[derive(Clone, PartialEq, Debug)]
pub enum Machine {
    /// The built-in tracer.
    Cpu,
    /// An OpenCL device.
    OpenCl {
        /// Which.
        device: DeviceInfo,
        /// What it runs.
        program: Program,
    },
}

/// What an OpenCL device runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Program {
    /// One that is made for the scene.
    Made,
    /// One that serves any scene.
    General,
    /// One that is made for the scene by a compiler that need not keep to the rules of arithmetic, in singles. Nothing is
    /// promised of its pictures; it is there for comparison.
    FastMath,
}

impl Machine {
    /// One word or three.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            Self::OpenCl { program, .. } => match program {
                Program::Made => "opencl",
                Program::General => "opencl general",
                Program::FastMath => "opencl fast-math",
            },
        }
    }

    /// Whether what it computes is known to be within a bound.
    #[must_use]
    pub fn promises(&self) -> bool {
        !matches!(
            self,
            Self::OpenCl {
                program: Program::FastMath,
                ..
            }
        )
    }
}

/// What a picture is traced with.
#[derive(Clone, PartialEq, Debug)]
pub struct Setting {
    /// What computes.
    pub machine: Machine,
    /// In which numbers.
    pub precision: Precision,
    /// Samples per pixel.
    pub samples: u32,
    /// The most reflections and refractions of one path.
    pub raydepth: u32,
    /// Where branches are dropped.
    pub cutoff: f64,
}

impl Setting {
    /// The scene as this setting has it traced.
    pub(crate) fn scene(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        (scene.settings.samples, scene.settings.raydepth) = (self.samples, self.raydepth);
        scene
    }

    pub(crate) fn limits(&self) -> Limits {
        Limits {
            cutoff: self.cutoff,
            ..Limits::DEFAULT
        }
    }

    /// How much one rounding changes a number, relative to it.
    pub(crate) fn roundoff(&self) -> f64 {
        roundoff(self.precision)
    }

    /// The same, on a machine that keeps to the rules of arithmetic.
    pub(crate) fn strict(&self) -> Self {
        let mut strict = self.clone();
        if let Machine::OpenCl { program, .. } = &mut strict.machine
            && *program == Program::FastMath
        {
            *program = Program::Made;
        }
        strict
    }

    /// The same with other samples.
    pub(crate) fn with_samples(&self, samples: u32) -> Self {
        Self {
            samples,
            ..self.clone()
        }
    }
}

/// How much one rounding changes a number, relative to it.
pub(crate) const fn roundoff(precision: Precision) -> f64 {
    match precision {
        Precision::F32 => f32::EPSILON as f64 / 2.0,
        Precision::F64 => f64::EPSILON / 2.0,
    }
}
