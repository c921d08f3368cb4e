//! The subcommands: each is a set of arguments with a `run` that tells how the program ends.

pub(crate) mod bench;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod devices;
pub(crate) mod explain;
pub(crate) mod fmt;
pub(crate) mod lsp;
pub(crate) mod plan;
pub(crate) mod preview_worker;
pub(crate) mod render;
