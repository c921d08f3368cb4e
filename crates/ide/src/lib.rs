//! What an editor shows of one document, as plain data: a file for each feature.
//!
//! Every place is a byte offset or a span of them. It must not know the editor's protocol, a renderer, or any file.

mod actions;
mod camera;
mod carry;
mod colour;
mod completion;
mod document;
mod extent;
mod facts;
mod fields;
mod fold;
mod formatting;
mod highlight;
mod hover;
mod inlay;
mod insert;
mod lens;
mod look;
#[cfg(test)]
mod marked;
mod meaning;
mod names;
mod navigate;
mod outline;
mod pick;
mod pieces;
mod place;
mod rename;
mod select;
mod settings;
mod signature;
mod solid;
mod symbols;
#[cfg(test)]
mod tests;
mod tokens;
mod words;

pub use actions::{Action, ActionKind, actions, fix_all};
pub use camera::{CameraChange, camera_edits};
pub use colour::{Swatch, colour_edits, colours};
pub use completion::{Completion, CompletionKind, MOST_NAMES, completions};
pub use document::Document;
pub use fold::{Fold, FoldKind, folds};
pub use formatting::{format, format_line, format_lines};
pub use highlight::{Highlight, highlights};
pub use hover::{Hover, hover};
pub use inlay::{InlayHint, InlayKind, inlay_hints};
pub use lens::{Lens, LensKind, lenses};
pub use meaning::meaning;
pub use navigate::{Target, definition, references};
pub use outline::{OutlineItem, OutlineKind, outline};
pub use pick::{object_at, statement_of};
pub use rename::{RenameError, Renameable, prepare_rename, rename};
pub use scenec_lint::{Page, page};
pub use scenec_syntax::{FormatStyle, Refused};
pub use select::selections;
pub use signature::{Parameter, Signature, signature};
pub use symbols::{FoundSymbol, symbols};
pub use tokens::{Modifiers, Token, TokenKind, tokens};
