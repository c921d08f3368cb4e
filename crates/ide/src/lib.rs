//! What an editor shows of one document, as plain data: a file for each feature.
//!
//! Every place is a byte offset or a span of them. It must not know the editor's protocol, a renderer, or any file.

mod document;

pub use document::Document;
