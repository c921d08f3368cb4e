//! The numbers that stand for something in what tracers read, by the names that the kernels have for them.

use crate::cells::{CELL_FULL, CELL_PART};
use crate::program::{COMPLEMENT, OPERATION_SHIFT, PROGRAM_DEPTH};
use crate::shape::ShapeKind;
use crate::wide::Child;

/// Names and values for a kernel's source, whatever the scene.
pub const NUMBERS: &[(&str, u32)] = &[
    ("KIND_BALL", ShapeKind::Ball.number()),
    ("KIND_HALF_SPACE", ShapeKind::HalfSpace.number()),
    ("CELL_PART", CELL_PART),
    ("CELL_FULL", CELL_FULL),
    ("OPERATION_SHIFT", OPERATION_SHIFT),
    ("COMPLEMENT", COMPLEMENT),
    ("PROGRAM_DEPTH", PROGRAM_DEPTH as u32),
    ("CHILD_SHIFT", Child::SHIFT),
    ("CHILD_NODE", Child::NODE),
    ("CHILD_BLOCK", Child::BLOCK),
];
