//! What a rule is.

use crate::context::Context;
use crate::findings::Findings;
use crate::page::Page;

/// A check and its manual page; made by the macro `rule!`.
pub(crate) struct Rule {
    /// The page, which tells the code as well.
    pub(crate) page: Page,
    /// Looks at the file and adds what it finds.
    pub(crate) check: fn(&Context<'_>, &mut Findings),
}
