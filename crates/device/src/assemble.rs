//! The program's text: the precision, the scene's features, the shared structs, and the kernels.
//!
//! This is the only place that writes a `#define`.

use std::fmt::Write;

use scenec_kernels::{Piece, TRACER};
use scenec_plan::{Features, FieldKind, LAYOUTS, Layout, NUMBERS};

use crate::info::DeviceInfo;

/// The number that the kernels compute in.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Precision {
    /// Singles: every device has them.
    F32,
    /// Doubles, where the device has them.
    F64,
}

impl Precision {
    const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

impl std::fmt::Display for Precision {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// The side of the square of pixels that a work-item traces: enough to keep eight rays together, or one.
#[must_use]
pub(crate) const fn item_side(features: &Features) -> u32 {
    if features.eights { 4 } else { 1 }
}

/// The source of the tracer for scenes with these features.
#[must_use]
pub fn source(precision: Precision, features: &Features) -> String {
    let mut text = prelude(precision);
    for (name, value) in NUMBERS.iter().copied().chain(features.list()) {
        // Writing to a string does not fail.
        let _ = writeln!(text, "#define {name} {value}");
    }
    let _ = writeln!(text, "#define ITEM_SIDE {}", item_side(features));
    for Piece { name, text: piece } in TRACER {
        let _ = write!(text, "#line 1 \"{name}\"\n{piece}");
    }
    text
}

/// The source of a kernel that writes, for each shared struct, its size and then the offset of each field.
#[must_use]
pub fn probe(precision: Precision) -> String {
    let mut text = prelude(precision);
    text.push_str("__kernel void probe(__global uint *out) {\n    uint i = 0;\n");
    for Layout { name, fields } in LAYOUTS {
        let _ = writeln!(text, "    {{ {name} s; out[i++] = sizeof(s);");
        for field in *fields {
            let _ = writeln!(text, "    out[i++] = (uint)((size_t)&s.{} - (size_t)&s);", field.name);
        }
        text.push_str("    }\n");
    }
    text.push_str("}\n");
    text
}

/// How the compiler is asked to work. Nothing that trades accuracy for speed: infinite ends of intervals and the tests for
/// NaN must mean what they say.
#[must_use]
pub fn options(info: &DeviceInfo, precision: Precision) -> String {
    strict(info, precision, " -cl-denorms-are-zero")
}

/// The same without leave to take the numbers below the smallest normal one for zero.
pub(crate) fn options_with_denormals(info: &DeviceInfo, precision: Precision) -> String {
    strict(info, precision, "")
}

fn strict(info: &DeviceInfo, precision: Precision, denormals: &str) -> String {
    let exact = precision == Precision::F32 && info.exact_divide;
    let divide = if exact {
        " -cl-fp32-correctly-rounded-divide-sqrt"
    } else {
        ""
    };
    format!("-cl-std=CL1.2{denormals}{divide}")
}

/// The same with leave to round as the compiler likes, and to take every number for a finite one. What comes of that is
/// promised by nobody.
pub(crate) fn relaxed_options() -> String {
    "-cl-std=CL1.2 -cl-fast-relaxed-math".to_owned()
}

fn prelude(precision: Precision) -> String {
    // A compiler that fuses on its own would fuse differently in a specialised program than in the general one.
    let mut text = String::from("#pragma OPENCL FP_CONTRACT OFF\n");
    text.push_str(match precision {
        Precision::F32 => "typedef float real;\n#define REAL_EPSILON FLT_EPSILON\n#define DOUBLES 0\n",
        Precision::F64 => {
            "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\ntypedef double real;\n#define REAL_EPSILON DBL_EPSILON\n\
             #define DOUBLES 1\n"
        }
    });
    for Layout { name, fields } in LAYOUTS {
        text.push_str("typedef struct {\n");
        for field in *fields {
            let kind = match field.kind {
                FieldKind::Real => "real",
                FieldKind::Float => "float",
                FieldKind::Uint => "uint",
            };
            let count = field.count.map(|count| format!("[{count}]")).unwrap_or_default();
            let _ = writeln!(text, "    {kind} {}{count};", field.name);
        }
        let _ = writeln!(text, "}} {name};");
    }
    text
}
