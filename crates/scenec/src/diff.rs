//! What would change in a file, as `patch` understands it.

use std::time::Duration;

use similar::TextDiff;

/// How long two texts may be compared; from then on the difference is true but not the shortest.
const PATIENCE: Duration = Duration::from_secs(1);

/// The unified diff from one text to another; empty if they are equal.
pub(crate) fn unified(name: &str, old: &str, new: &str) -> String {
    if old == new {
        return String::new();
    }
    let diff = TextDiff::configure().timeout(PATIENCE).diff_lines(old, new);
    diff.unified_diff().header(name, name).to_string()
}

#[cfg(test)]
mod tests {
    use super::unified;

    fn check(old: &str, new: &str, expect: &str) {
        assert_eq!(unified("a.scene", old, new), expect);
    }

    #[test]
    fn the_difference_has_the_lines_around_it() {
        check("x\n", "x\n", "");
        check(
            "1\n2\n3\n4\nfive\n",
            "1\n2\n3\n4\n5\n",
            "--- a.scene\n+++ a.scene\n@@ -2,4 +2,4 @@\n 2\n 3\n 4\n-five\n+5\n",
        );
        check(
            "x",
            "x\n",
            "--- a.scene\n+++ a.scene\n@@ -1 +1 @@\n-x\n\\ No newline at end of file\n+x\n",
        );
    }
}
