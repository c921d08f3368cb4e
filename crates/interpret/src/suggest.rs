//! "Did you mean", with a bound on what it costs a whole file.

use scenec_text::closest;

/// How many names one file may have looked at: enough for every finding that somebody reads, and a fraction of a second.
const BUDGET: usize = 200_000;

/// Looks for near names until the budget is used up.
pub(crate) struct Suggestions {
    left: usize,
}

impl Suggestions {
    pub(crate) const fn new() -> Self {
        Self { left: BUDGET }
    }

    /// The nearest candidate; one that is `None` costs as much as any other, since it was looked at.
    pub(crate) fn closest<'a>(
        &mut self,
        name: &str,
        candidates: impl Iterator<Item = Option<&'a str>>,
    ) -> Option<&'a str> {
        let left = &mut self.left;
        let affordable = candidates.take_while(|_| {
            let open = *left > 0;
            *left = left.saturating_sub(1);
            open
        });
        closest(name, affordable.flatten())
    }
}
