//! What an editor shows of one document, as plain data: a file for each feature.
//!
//! Every place is a byte offset or a span of them. It must not know the editor's protocol, a renderer, or any file.

mod colour;
mod completion;
mod document;
mod facts;
mod fields;
mod hover;
mod inlay;
mod look;
#[cfg(test)]
mod marked;
mod place;
mod settings;
mod signature;
mod solid;
mod words;

pub use colour::{Swatch, colour_edits, colours};
pub use completion::{Completion, CompletionKind, MOST_NAMES, completions};
pub use document::Document;
pub use hover::{Hover, hover};
pub use inlay::{InlayHint, InlayKind, inlay_hints};
pub use signature::{Parameter, Signature, signature};
