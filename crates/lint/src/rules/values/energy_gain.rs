//! Materials that give back more light than they get.

use scenec_text::{Code, Diagnostic};

use crate::context::Context;
use crate::findings::Findings;
use crate::rules::values::{REFLECT, REFRACT, figure, material_name};

rule! {
    /// A material whose reflection and refraction together are more than 1.
    ///
    /// Such a surface passes on more light than reaches it. Between two of them each bounce is brighter than the one
    /// before, so the picture grows brighter with `raydepth` and never settles.
    ///
    /// ## Example
    ///
    /// ```scene
    /// raydepth := 4
    /// ?glass := 0 0 0 0.5 0.9 1.5 1 1 1 1
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
    EnergyGain, check
}

/// Decimal fractions that are meant to add up to 1 may miss it by their rounding.
const ONE: f64 = 1.0 + 1e-9;

fn check(context: &Context<'_>, findings: &mut Findings) {
    for (material, statement) in context.materials() {
        let sum = material.reflect + material.refract;
        if sum <= ONE {
            continue;
        }
        let (reflect, refract) = (
            context.value_at(statement, REFLECT),
            context.value_at(statement, REFRACT),
        );
        findings.push(
            Diagnostic::new(
                Code::EnergyGain,
                format!(
                    "{} gives back {} times the light that it gets",
                    material_name(context, statement),
                    figure(rounded(sum))
                ),
                reflect,
                format!("reflects {}", figure(material.reflect)),
            )
            .label(refract, format!("refracts {}", figure(material.refract)))
            .help("let the two add up to 1 at most"),
        );
    }
}

/// To three decimals, without the rounding of the sum.
fn rounded(sum: f64) -> f64 {
    let rounded = (sum * 1e3).round() / 1e3;
    if rounded > 1.0 && rounded.is_finite() {
        rounded
    } else {
        sum
    }
}
