//! How grave a finding counts: what its code says, unless the command line or a configuration says otherwise.

use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use scenec_text::{Code, Severity, closest};

/// What somebody wants done about a code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Level {
    /// It counts as an error.
    Deny,
    /// It counts as a warning.
    Warn,
    /// It is not shown.
    Allow,
}

impl Level {
    pub(crate) const ALL: [Self; 3] = [Self::Deny, Self::Warn, Self::Allow];

    /// The name of the option and of the key.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Deny => "deny",
            Self::Warn => "warn",
            Self::Allow => "allow",
        }
    }

    const fn help(self) -> &'static str {
        match self {
            Self::Deny => "Count a code as an error (or all `warnings`, or all `hints`)",
            Self::Warn => "Count a code as a warning (or all `hints`)",
            Self::Allow => "Say nothing about a code (or all `warnings`, or all `hints`)",
        }
    }
}

/// A code, or every code of a kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Which {
    One(Code),
    All(Severity),
}

impl Which {
    /// What a word stands for at a level.
    ///
    /// # Errors
    /// A sentence for the user: the word is no code, or the code can't be had at this level.
    pub(crate) fn read(word: &str, level: Level) -> Result<Self, String> {
        const KINDS: [(&str, Severity); 2] = [("warnings", Severity::Warning), ("hints", Severity::Hint)];
        if let Some((_, kind)) = KINDS.iter().find(|(name, _)| *name == word) {
            return Ok(Self::All(*kind));
        }
        let Some(code) = Code::ALL.iter().find(|code| code.id().eq_ignore_ascii_case(word)) else {
            let names = Code::ALL
                .iter()
                .map(|code| code.id())
                .chain(KINDS.map(|(name, _)| name));
            let similar = closest(word, names).map(|name| format!("; did you mean `{name}`?"));
            return Err(format!("there is no code `{word}`{}", similar.unwrap_or_default()));
        };
        if code.severity() == Severity::Error && level != Level::Deny {
            let id = code.id();
            return Err(format!(
                "{id} is an error and stays one: with it the file means nothing"
            ));
        }
        Ok(Self::One(*code))
    }

    fn holds(self, code: Code) -> bool {
        match self {
            Self::One(one) => one == code,
            Self::All(kind) => code.severity() == kind,
        }
    }
}

/// How grave each code counts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Levels(Vec<Option<Severity>>);

impl Default for Levels {
    fn default() -> Self {
        Self(Code::ALL.iter().map(|code| Some(code.severity())).collect())
    }
}

impl Levels {
    /// Sets what `which` stands for; what was set before gives way.
    pub(crate) fn set(&mut self, level: Level, which: Which) {
        for (code, slot) in Code::ALL.iter().zip(&mut self.0) {
            if which.holds(*code) {
                *slot = match level {
                    Level::Deny => Some(Severity::Error),
                    Level::Warn => Some(Severity::Warning),
                    Level::Allow => None,
                };
            }
        }
    }

    /// How grave a code counts; `None` if it is not to be shown.
    pub(crate) fn of(&self, code: Code) -> Option<Severity> {
        let index = Code::ALL.iter().position(|one| *one == code)?;
        self.0.get(index).copied().flatten()
    }
}

/// `--deny`, `--warn` and `--allow` in the order in which they were given.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct LevelOptions {
    pub(crate) asked: Vec<(Level, Which)>,
}

impl LevelOptions {
    pub(crate) fn apply(&self, levels: &mut Levels) {
        for (level, which) in &self.asked {
            levels.set(*level, *which);
        }
    }
}

impl Args for LevelOptions {
    fn augment_args(command: Command) -> Command {
        let option = |level: Level| {
            Arg::new(level.name())
                .long(level.name())
                .value_name("CODE")
                .help(level.help())
                .help_heading("Levels")
                .action(ArgAction::Append)
                .value_delimiter(',')
                .value_parser(move |word: &str| Which::read(word, level))
        };
        command.args(Level::ALL.map(option))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for LevelOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut found = Vec::new();
        for level in Level::ALL {
            let places = matches.indices_of(level.name()).into_iter().flatten();
            let values = matches.get_many::<Which>(level.name()).into_iter().flatten();
            found.extend(places.zip(values).map(|(place, which)| (place, (level, *which))));
        }
        found.sort_by_key(|(place, _)| *place);
        let asked = found.into_iter().map(|(_, asked)| asked).collect();
        Ok(Self { asked })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use clap::{Args, Command, FromArgMatches};
    use scenec_text::{Code, Severity};

    use super::{LevelOptions, Levels};

    /// How grave W005 counts with these arguments.
    fn check(arguments: &[&str], expect: Result<Option<Severity>, &str>) {
        let command = LevelOptions::augment_args(Command::new("t").no_binary_name(true));
        let found = command.try_get_matches_from(arguments).map(|matches| {
            let mut levels = Levels::default();
            LevelOptions::from_arg_matches(&matches).unwrap().apply(&mut levels);
            levels.of(Code::AfterSubmission)
        });
        match (found, expect) {
            (Ok(found), Ok(expect)) => assert_eq!(found, expect, "{arguments:?}"),
            (Err(error), Err(words)) => assert!(error.to_string().contains(words), "{error}"),
            (found, _) => panic!("{arguments:?}: {found:?}"),
        }
    }

    #[test]
    fn the_later_option_wins() {
        check(&[], Ok(Some(Severity::Warning)));
        check(&["--deny", "W005"], Ok(Some(Severity::Error)));
        check(&["--allow", "w005,W006"], Ok(None));
        check(&["--deny", "warnings", "--allow", "W005"], Ok(None));
        check(&["--allow", "W005", "--deny", "warnings"], Ok(Some(Severity::Error)));
        check(
            &["--allow=warnings", "--warn=W006", "--warn=W005"],
            Ok(Some(Severity::Warning)),
        );
        check(&["--deny", "hints"], Ok(Some(Severity::Warning)));
        check(&["--deny", "E005"], Ok(Some(Severity::Warning)));
    }

    #[test]
    fn what_is_no_code_or_must_stay_an_error_is_refused() {
        check(&["--allow", "E005"], Err("E005 is an error and stays one"));
        check(&["--deny", "waring"], Err("there is no code `waring`"));
        check(&["--deny", "warning"], Err("did you mean `warnings`?"));
        check(&["--deny", ""], Err("there is no code ``"));
    }
}
