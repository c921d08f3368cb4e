//! Values that do not do what they seem to.

pub(super) mod colour_out_of_range;
pub(super) mod dark_light;
pub(super) mod energy_gain;
pub(super) mod huge_picture;
pub(super) mod idle_depth;
pub(super) mod likely_degrees;
pub(super) mod lost_highlight;
pub(super) mod lost_reflection;
pub(super) mod many_samples;
pub(super) mod negative_coefficient;
pub(super) mod negative_light;
pub(super) mod unbent_glass;

use scenec_syntax::quote;
use scenec_text::Span;

use crate::context::Context;

/// Place of the weight of the reflection among a material's values.
const REFLECT: usize = 3;
/// Place of the weight of the refraction.
const REFRACT: usize = 4;

/// A number for a message: short, however large or small it is.
fn figure(number: f64) -> String {
    if number == 0.0 || (1e-4..1e9).contains(&number.abs()) {
        number.to_string()
    } else {
        format!("{number:e}")
    }
}

/// The name of the material that a statement defines, for a message.
fn material_name(context: &Context<'_>, statement: Span) -> String {
    let name = context.statement_at(statement).map_or(statement, |found| found.name());
    quote(&format!("?{}", name.of(context.text())))
}
