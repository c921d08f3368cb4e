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

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use super::{OutlineItem, outline};
    use crate::tests::document;

    fn show(items: &[OutlineItem], depth: usize, out: &mut String) {
        for item in items {
            writeln!(out, "{}{} ({})", "  ".repeat(depth), item.name, item.detail).unwrap();
            show(&item.children, depth + 1, out);
        }
    }

    fn check(text: &str, expect: &str) {
        let mut found = String::new();
        show(&outline(&document(text)), 0, &mut found);
        assert_eq!(found.trim_end(), expect, "{text}");
    }

    #[test]
    fn the_submitted_object_comes_first_with_its_parts() {
        check(
            "width := 5\nq := pi\n!a := sphere\n!b := hp\n!c := sphere\n!u := a | b\n!u := u - c\n!u <=\n\
             ?m := 0 0 0 0 0 0 0 1 .5 0\n*l := 1 2 3 4 5 6",
            "!u (subtraction)\n  !a (sphere)\n  !b (hp)\n  !c (less sphere)\n?m (1 .5 0)\n*l (1 2 3)\nwidth (5)\nq (pi)",
        );
        check(
            "!a := sphere\n!b := hp\n!b <=\nbroken",
            "!b (hp)\n!a (sphere, not rendered)",
        );
    }

    #[test]
    fn shared_parts_are_taken_apart_once() {
        check(
            "!a := sphere\n!b := a | a\n!c := b & b\n!c <=",
            "!c (intersection)\n  !b (union, shown before)\n  !b (cut to union)\n    !a (sphere)\n    !a (sphere)",
        );
        let doubling: String = (1..200)
            .map(|n| format!("!d{n} := d{} | d{}\n", n - 1, n - 1))
            .collect();
        let items = outline(&document(&format!("!d0 := sphere\n{doubling}!d199 <=")));
        assert_eq!(count(&items), 2 * 24 + 2);
    }

    #[test]
    fn long_chains_are_cut() {
        let chain = "!u := u | a\n".repeat(100_000);
        let items = outline(&document(&format!("!a := sphere\n!u := sphere\n{chain}!u <=")));
        assert_eq!(count(&items), 502);
        assert_eq!(items[0].children[0].name, "… 99501 more");
        let deep: String = (1..100_000).map(|n| format!("!d{n} := d{} | a\n", n - 1)).collect();
        let items = outline(&document(&format!("!a := sphere\n!d0 := sphere\n{deep}!d99999 <=")));
        assert!(count(&items) < 100);
    }

    fn count(items: &[OutlineItem]) -> usize {
        items.iter().map(|item| 1 + count(&item.children)).sum()
    }
}
