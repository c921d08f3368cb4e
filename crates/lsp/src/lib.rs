//! The language server: frames, documents and their order, one thin handler a feature, and the live preview.
//!
//! It must not know how statements are parsed and bound; what an editor shows comes from the features as plain data.

mod abilities;
mod ball;
mod contain;
mod convert;
mod documents;
mod folders;
mod frames;
mod handlers;
mod log;
mod markup;
mod mend;
mod newer;
mod options;
mod orphan;
mod pages;
mod pictures;
pub mod preview;
mod publisher;
mod pump;
mod requests;
mod serve;
mod server;
mod settings;
mod text;
mod view;

pub use options::{FileOptions, Options};
pub use serve::{Ended, serve};
