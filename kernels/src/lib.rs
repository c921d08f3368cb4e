//! The OpenCL sources by name, and nothing else.
//!
//! They are written over `real`, which the host defines as `float` or `double`, over the structs that it generates and the
//! numbers that these hold, and over its feature switches; in this order they make one program.

/// A piece of the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Piece {
    /// The file's name, for `#line`.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
}

macro_rules! pieces {
    ($($name:literal),+) => {
        &[$(Piece { name: $name, text: include_str!(concat!("../", $name)) },)+]
    };
}

/// The pieces of the tracer, in order.
pub const TRACER: &[Piece] = pieces![
    "lanes.cl",
    "vector.cl",
    "scene.cl",
    "shape.cl",
    "search.cl",
    "event.cl",
    "cells.cl",
    "island.cl",
    "pairs.cl",
    "eights.cl",
    "solid.cl",
    "contact.cl",
    "shade.cl",
    "path.cl",
    "sampled.cl",
    "pixel.cl",
    "trace.cl"
];
