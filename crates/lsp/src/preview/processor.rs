//! The built-in tracer in the precision that a plan asks for. Its threads outlive plans.

use scenec_cpu::Cpu;
use scenec_device::Precision;
use scenec_picture::{Frame, Request, TraceError, Tracer};
use scenec_plan::Plan;

/// A tracer with threads that wait for the next plan.
pub(super) enum Processor {
    Single(Cpu<f32>),
    Double(Cpu<f64>),
}

/// The precision in which `scenec render` would trace a plan.
pub(super) fn precision(plan: &Plan) -> Precision {
    match plan.beyond_single() {
        Some(_) => Precision::F64,
        None => Precision::F32,
    }
}

impl Processor {
    /// Takes a plan up: on the threads of `before` if they serve its precision.
    pub(super) fn show(before: Option<Self>, plan: &Plan) -> Result<Self, TraceError> {
        Ok(match (before, precision(plan)) {
            (Some(Self::Single(mut cpu)), Precision::F32) => {
                cpu.show(plan);
                Self::Single(cpu)
            }
            (Some(Self::Double(mut cpu)), Precision::F64) => {
                cpu.show(plan);
                Self::Double(cpu)
            }
            (_, Precision::F32) => Self::Single(Cpu::new(plan, 0)?),
            (_, Precision::F64) => Self::Double(Cpu::new(plan, 0)?),
        })
    }

    /// Divides the picture; see [`Cpu::divide`].
    pub(super) fn divide(&mut self, (width, height): (u32, u32), samples: &[[f64; 2]]) {
        match self {
            Self::Single(cpu) => cpu.divide(width, height, samples),
            Self::Double(cpu) => cpu.divide(width, height, samples),
        }
    }

    pub(super) fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError> {
        match self {
            Self::Single(cpu) => cpu.trace(request),
            Self::Double(cpu) => cpu.trace(request),
        }
    }

    /// What computes, for people.
    pub(super) fn name(&self) -> String {
        match self {
            Self::Single(cpu) => cpu.name(),
            Self::Double(cpu) => cpu.name(),
        }
    }
}
