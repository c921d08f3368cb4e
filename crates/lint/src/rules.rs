//! The rules: one file each.

mod dropped;

use crate::rule::Rule;

/// Every rule. What one reports no other reports again.
pub(crate) const RULES: &[Rule] = &[
    // Work that does nothing.
    dropped::unused_material::RULE,
    dropped::idle_transform::RULE,
];
