//! From statements to a scene: what the names on the lines mean.
//!
//! Owns binding, the hierarchy of objects, the settings and every finding about them, and keeps the symbol table that
//! an editor reads. It must not know disks, renderers or editors.

mod bindings;
mod finish;
mod interpret;
mod names;
mod state;
mod statements;
mod suggest;
mod symbols;

pub use interpret::{Fragments, Interpretation, Interpreter, analyse, interpret, interpret_ahead, scene_of};
pub use symbols::{Definition, DefinitionId, Occurrence, Role, Symbol, SymbolId, SymbolTable};
