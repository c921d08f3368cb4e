//! Rules about scene files: one file for each, whose doc comment is its manual page.
//!
//! Owns the rules, the pages of every code, mechanical repairs, and the comments that silence a finding. It must not know
//! how reports are printed, nor what renders a scene.

#[macro_use]
mod page;
mod check;
mod context;
mod findings;
mod geometry;
mod mend;
mod pages;
mod removal;
mod rule;
mod rules;
mod suppress;

pub use check::{Checked, Reading, check, check_without_geometry, lint};
pub use page::{PRELUDE, Page, page, pages};
pub use suppress::{allow_also, suppress};
