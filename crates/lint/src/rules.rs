//! The rules: one file each, in folders by what they are about.

mod dropped;
mod geometry;
mod values;

use crate::rule::Rule;

/// Every rule. What one reports no other reports again.
pub(crate) fn all() -> impl Iterator<Item = &'static Rule> {
    [STATEMENTS, STEPS, EACH, SOLIDS].into_iter().flatten()
}

/// Rules that look at one statement or number after the other.
pub(crate) const STATEMENTS: &[Rule] = &[
    // Work that does nothing.
    dropped::unused_object::RULE,
    dropped::unused_material::RULE,
    dropped::idle_transform::RULE,
    dropped::material_replaced::RULE,
    // Values that do not do what they seem to.
    values::energy_gain::RULE,
    values::negative_coefficient::RULE,
    values::colour_out_of_range::RULE,
    values::negative_light::RULE,
    values::lost_highlight::RULE,
    values::likely_degrees::RULE,
    values::huge_picture::RULE,
    values::lost_reflection::RULE,
    values::dark_light::RULE,
    values::unbent_glass::RULE,
    values::many_samples::RULE,
    values::idle_depth::RULE,
];

/// Rules that keep something about every transform. They go before those that build trees of solids, so that their lists are
/// gone by then.
pub(crate) const STEPS: &[Rule] = &[dropped::effectless_transform::RULE];

/// Rules about solids that come out badly or not at all, each for itself.
pub(crate) const EACH: &[Rule] = &[
    geometry::ill_conditioned::RULE,
    geometry::too_far_to_resolve::RULE,
    geometry::nothing_in_view::RULE,
];

/// Rules about how solids lie to each other and to points, each with its proof. In a large scene they take longer than
/// all others.
pub(crate) const SOLIDS: &[Rule] = &[
    geometry::covered_solid::RULE,
    geometry::idle_subtraction::RULE,
    geometry::empty_subtraction::RULE,
    geometry::empty_intersection::RULE,
    geometry::idle_intersection::RULE,
    geometry::coincident_operands::RULE,
    geometry::buried_light::RULE,
    geometry::buried_eye::RULE,
];
