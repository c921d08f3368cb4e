//! Whether reports are coloured.

use std::env;
use std::io::IsTerminal;

/// What the user asked for.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ColourChoice {
    /// If the reports go to a terminal, and NO_COLOR, CLICOLOR_FORCE and TERM don't say otherwise
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl ColourChoice {
    /// Whether to colour what goes to `out`.
    pub(crate) fn decide(self, out: &impl IsTerminal) -> bool {
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => automatic(
                |name| env::var_os(name).map(|value| value.to_string_lossy().into_owned()),
                out.is_terminal(),
            ),
        }
    }
}

/// The conventions of no-color.org and bixense.com/clicolors.
fn automatic(variable: impl Fn(&str) -> Option<String>, terminal: bool) -> bool {
    let set = |name: &str| variable(name).is_some_and(|value| !value.is_empty() && value != "0");
    if variable("NO_COLOR").is_some_and(|value| !value.is_empty()) {
        return false;
    }
    if set("CLICOLOR_FORCE") {
        return true;
    }
    terminal && variable("TERM").as_deref() != Some("dumb") && variable("CLICOLOR").as_deref() != Some("0")
}

#[cfg(test)]
mod tests {
    use super::automatic;

    fn check(set: &[(&str, &str)], terminal: bool, expect: bool) {
        let variable = |name: &str| {
            set.iter()
                .find(|(known, _)| *known == name)
                .map(|(_, value)| (*value).to_owned())
        };
        assert_eq!(automatic(variable, terminal), expect, "{set:?}");
    }

    #[test]
    fn the_usual_variables_decide() {
        check(&[], true, true);
        check(&[], false, false);
        check(&[("NO_COLOR", "1")], true, false);
        check(&[("NO_COLOR", "")], true, true);
        check(&[("CLICOLOR_FORCE", "1")], false, true);
        check(&[("CLICOLOR_FORCE", "0")], false, false);
        check(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")], true, false);
        check(&[("TERM", "dumb")], true, false);
        check(&[("CLICOLOR", "0")], true, false);
    }
}
