//! What every phase shares: spans, source files with their line index, and diagnostics with stable codes.
//!
//! Owns nothing about the language itself: it must not know tokens, scenes, or how a report is printed.

mod codes;
mod diagnostic;
mod ends;
mod line_index;
mod repair;
mod source;
mod span;
mod suggest;

pub use codes::{Code, Severity};
pub use diagnostic::{Diagnostic, Edit, Fix, Label};
pub use ends::CommonEnds;
pub use repair::{apply, fitting};
pub use source::{MAX_FILE_BYTES, Position, SourceFile, TooLarge};
pub use span::Span;
pub use suggest::closest;
