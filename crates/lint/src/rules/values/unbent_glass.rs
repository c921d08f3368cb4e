//! Refraction that bends nothing.

use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::material_name;

rule! {
    /// A material refracts, but its index is exactly 1, that of the air outside.
    ///
    /// Light goes straight through: the object dims or tints what is behind it like a foil, and has no lens to it. That
    /// may be meant; if it should look like glass, it needs another index.
    ///
    /// ## Example
    ///
    /// ```scene
    /// raydepth := 4
    /// ?glass := 0 0 0 0.1 0.9 1 1 1 1 1
    /// !ball := sphere
    /// !ball ?= glass
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// raydepth := 4
    /// ?glass := 0 0 0 0.1 0.9 1.5 1 1 1 1
    /// !ball := sphere
    /// !ball ?= glass
    /// !ball <=
    /// ```
    UnbentGlass, check
}

/// Place of the index among a material's values.
const INDEX: usize = 5;

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (material, statement) in context.materials() {
        if material.refract > 0.0 && material.index == 1.0 {
            findings.push(
                Diagnostic::new(
                    Code::UnbentGlass,
                    format!("{} refracts, but bends no light", material_name(context, statement)),
                    context.value_at(statement, INDEX),
                    "the index of the air outside",
                )
                .help("water has the index 1.33, glass about 1.5"),
            );
        }
    }
}
