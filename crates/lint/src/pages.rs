//! The pages of the codes that earlier stages report.

use crate::page::Page;

/// All of them.
pub(crate) const PAGES: &[Page] = &[];
