//! Comments that speak to the checker.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[page! {
    /// A comment that allows a code which is not reported there, or which does not exist.
    ///
    /// `/ scenec: allow W012, W013` silences warnings and hints: at the end of a line those of that line, on a line of its
    /// own those of the next one, before the first statement those of the whole file. Words after the last code are a
    /// reason, for people. What the comment allows may have been mended since; then the comment only hides the next
    /// mistake. Errors can't be silenced.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 0 1 0 / scenec: allow W014
    /// !ball <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 0 0 0 / scenec: allow W014 to be moved later
    /// !ball <=
    /// ```
    UselessAllow
}];
