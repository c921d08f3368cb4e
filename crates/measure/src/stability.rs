//! The stability suite: awkward scenes, each with an oracle and a threshold, through every tracer that there is.
//!
//! A case is a file of data. This module reads cases, judges what the tracers make of them, and writes the table. It must
//! not know how a scene is written: whoever calls it brings the reader of scene texts.

mod case;
mod judge;
mod list;
mod machines;
mod off;
mod picture_error;
mod table;
mod template;
mod tree;
mod verdict;
mod work;

pub use case::{Case, CaseError, Oracle, Run, Sum};
pub use judge::judge;
pub use list::cases;
pub use machines::Machines;
pub use picture_error::apart;
pub use table::{summary, table};
pub use verdict::{Outcome, Verdict};

use scenec_scene::Scene;

/// Turns a scene's text into a scene, or into the codes of the errors in it.
pub type Reader<'a> = &'a dyn Fn(&str) -> Result<Scene, Vec<String>>;
