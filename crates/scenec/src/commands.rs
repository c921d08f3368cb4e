//! The subcommands: each is a set of arguments with a `run` that tells how the program ends.

pub(crate) mod check;
