//! The pages of the codes that earlier stages report.

mod comments;
mod objects;
mod settings;
mod statements;
mod unused;
mod words;

use crate::page::Page;

/// All of them, in groups.
pub(crate) const PAGES: &[&[Page]] = &[
    words::PAGES,
    statements::PAGES,
    objects::PAGES,
    settings::PAGES,
    unused::PAGES,
    comments::PAGES,
];
