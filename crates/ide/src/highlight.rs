//! The places of the name under the cursor.

use scenec_interpret::Role;
use scenec_text::Span;

use crate::Document;
use crate::names::{name_at, places};

/// A place of a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Highlight {
    /// The name without a sigil.
    pub span: Span,
    /// Whether the statement binds the name or changes what it is bound to.
    pub write: bool,
}

/// Every place where the name at `offset` stands, in the order of the file; none where no name is.
#[must_use]
pub fn highlights(document: &Document, offset: u32) -> Vec<Highlight> {
    let found = name_at(document, offset).map(|name| places(document, name));
    let found = found.into_iter().flatten();
    found
        .map(|place| Highlight {
            span: place.span,
            write: place.role != Role::Use,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::highlights;
    use crate::marked::marked;

    #[test]
    fn what_binds_or_changes_is_told_from_what_reads() {
        let (document, offset) = marked("!a := sphere\n!$0a += 1 1 1\n!u := a | a\na := 1");
        let found: Vec<bool> = highlights(&document, offset).iter().map(|place| place.write).collect();
        assert_eq!(found, [true, true, false, false]);
    }
}
