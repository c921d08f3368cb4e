//! What a file holds, as a tree: the submitted object with its parts first, then everything else by kind.
//!
//! Everything is read off the statements, so that a file with errors keeps its outline. Both the depth and the number of
//! items are bounded, and a part that is shared is taken apart once.

mod list;
mod tree;

use scenec_text::Span;

use crate::Document;

/// The most items under one, or of one kind; a last one tells how many more there are.
const MOST: usize = 500;

/// The most items of the tree.
const MOST_PARTS: usize = 5000;

/// The most items on the way from the submitted object to a part.
const DEEPEST: usize = 24;

/// What an item is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum OutlineKind {
    /// A base object.
    Base,
    /// A combination.
    Combination,
    /// A material.
    Material,
    /// A light.
    Light,
    /// A variable that the language reads.
    Setting,
    /// An author's variable.
    Variable,
    /// What stands for items that were left out.
    More,
}

/// Something that a statement makes.
#[derive(Clone, PartialEq, Debug)]
pub struct OutlineItem {
    /// The name with its sigil, or how many items were left out.
    pub name: String,
    /// What it is, in a few words; may be empty.
    pub detail: String,
    /// What it is.
    pub kind: OutlineKind,
    /// The statement.
    pub line: Span,
    /// The name in it, without a sigil.
    pub name_span: Span,
    /// The parts, in the order in which they were taken.
    pub children: Vec<OutlineItem>,
}

/// The submitted object with its parts; then the other objects, materials, lights, settings and variables, each with the
/// last statement that makes it.
#[must_use]
pub fn outline(document: &Document) -> Vec<OutlineItem> {
    let tree = tree::submitted(document);
    tree.into_iter().chain(list::others(document)).collect()
}

/// What stands for `count` items after or before `line`.
fn more(count: usize, line: Span, name_span: Span) -> OutlineItem {
    OutlineItem {
        name: format!("… {count} more"),
        detail: String::new(),
        kind: OutlineKind::More,
        line,
        name_span,
        children: Vec::new(),
    }
}
