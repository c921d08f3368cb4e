//! `scenec.toml`: what holds for the files at and below the place where it lies.
//!
//! Owns the keys and what is said about those that do not exist. It must not know who asks.

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use scenec_syntax::FormatStyle;
use scenec_text::{SourceFile, closest};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::levels::{Level, Levels, Which};

/// The name of a configuration.
pub(crate) const NAME: &str = "scenec.toml";

/// What a configuration says, or would say if there were one.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Config {
    pub(crate) levels: Levels,
    pub(crate) format: FormatStyle,
}

/// A configuration, or a sentence about why there is none to be had.
pub(crate) type Found = Result<Arc<Config>, Arc<str>>;

/// Arguments about which configuration holds.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct ConfigOptions {
    /// The configuration of all files, in place of each one's nearest scenec.toml
    #[arg(long, value_name = "FILE", conflicts_with = "isolated")]
    pub(crate) config: Option<PathBuf>,
    /// Go by no configuration
    #[arg(long)]
    pub(crate) isolated: bool,
}

impl ConfigOptions {
    /// What holds for all files, if that was said.
    fn only(&self) -> Option<Found> {
        if self.isolated {
            return Some(Ok(Arc::default()));
        }
        let path = self.config.as_ref()?;
        let name = path.display().to_string();
        let text = fs::read_to_string(path).map_err(|error| format!("cannot read {name}: {error}"));
        let found = text.and_then(|text| read(&name, &text));
        Some(found.map(Arc::new).map_err(Arc::from))
    }
}

/// Finds the configuration of each file, and reads each one once.
pub(crate) struct Configs {
    only: Option<Found>,
    folders: HashMap<PathBuf, Found>,
}

impl Configs {
    pub(crate) fn new(options: &ConfigOptions) -> Self {
        Self {
            only: options.only(),
            folders: HashMap::new(),
        }
    }

    /// Why the configuration of all files is none, if it is.
    pub(crate) fn failure(&self) -> Option<&str> {
        self.only.as_ref()?.as_ref().err().map(AsRef::as_ref)
    }

    /// What holds for a file: what was said to hold for all, or the nearest configuration in its folder or one above, or
    /// the defaults.
    pub(crate) fn of(&mut self, file: &Path) -> Found {
        if let Some(only) = &self.only {
            return only.clone();
        }
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
        // A folder that can't be resolved has no file in it that could be read either.
        let folder = folder.unwrap_or(Path::new("."));
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        self.folder(fs::canonicalize(&folder).unwrap_or(folder))
    }

    fn folder(&mut self, folder: PathBuf) -> Found {
        let mut passed = Vec::new();
        let mut found = Ok(Arc::default());
        for above in folder.ancestors() {
            if let Some(known) = self.folders.get(above) {
                found = known.clone();
                break;
            }
            passed.push(above.to_owned());
            let path = above.join(NAME);
            match fs::read_to_string(&path) {
                Ok(text) => {
                    found = read(&shown(&path), &text).map(Arc::new).map_err(Arc::from);
                    break;
                }
                Err(error) if error.kind() == io::ErrorKind::NotFound || !path.exists() => {}
                Err(error) => {
                    found = Err(Arc::from(format!("cannot read {}: {error}", shown(&path))));
                    break;
                }
            }
        }
        for folder in passed {
            self.folders.insert(folder, found.clone());
        }
        found
    }
}

/// A path as seen from here, where it lies below here.
fn shown(path: &Path) -> String {
    let here = std::env::current_dir().and_then(fs::canonicalize);
    let below = here.ok().and_then(|here| path.strip_prefix(here).ok());
    below.unwrap_or(path).display().to_string()
}

/// Reads a configuration.
///
/// # Errors
/// A sentence that begins with the place.
pub(crate) fn read(name: &str, text: &str) -> Result<Config, String> {
    let reader = Reader { name, text };
    let table = DeTable::parse(text)
        .map_err(|error| reader.wrong(error.span().map_or(0, |span| span.start), error.message()))?;
    reader.config(table.get_ref())
}

struct Reader<'a> {
    name: &'a str,
    text: &'a str,
}

type Entry<'a> = (&'a str, &'a Spanned<DeValue<'a>>);

impl Reader<'_> {
    fn config(&self, table: &DeTable) -> Result<Config, String> {
        let mut config = Config::default();
        for (key, value) in self.keys(table, "", &["lint", "fmt"])? {
            match key {
                "lint" => self.lint(value, &mut config.levels)?,
                _ => self.format(value, &mut config.format)?,
            }
        }
        Ok(config)
    }

    /// The lists of codes. A kind gives way to a single code, whichever is written first.
    fn lint(&self, value: &Spanned<DeValue>, levels: &mut Levels) -> Result<(), String> {
        let mut asked: Vec<(Level, Which)> = Vec::new();
        let names = Level::ALL.map(Level::name);
        for (key, value) in self.keys(self.table(value, "lint")?, "lint.", &names)? {
            let level = Level::ALL.into_iter().find(|level| level.name() == key);
            let (Some(level), DeValue::Array(words)) = (level, value.get_ref()) else {
                return Err(self.wrong(
                    value.span().start,
                    &format!("`lint.{key}` is a list of codes, such as [\"W005\"]"),
                ));
            };
            for word in words {
                let wrong = |message: &str| self.wrong(word.span().start, message);
                let DeValue::String(code) = word.get_ref() else {
                    return Err(wrong("a code is a string, such as \"W005\""));
                };
                let which = Which::read(code, level).map_err(|message| wrong(&message))?;
                if asked.iter().any(|(other, one)| *one == which && *other != level) {
                    return Err(wrong(&format!("`{code}` stands in two lists")));
                }
                asked.push((level, which));
            }
        }
        asked.sort_by_key(|(_, which)| matches!(which, Which::One(_)));
        for (level, which) in asked {
            levels.set(level, which);
        }
        Ok(())
    }

    fn format(&self, value: &Spanned<DeValue>, style: &mut FormatStyle) -> Result<(), String> {
        for (key, value) in self.keys(self.table(value, "fmt")?, "fmt.", &["align"])? {
            let DeValue::Boolean(align) = value.get_ref() else {
                return Err(self.wrong(value.span().start, &format!("`fmt.{key}` is true or false")));
            };
            style.align = *align;
        }
        Ok(())
    }

    fn table<'a>(&self, value: &'a Spanned<DeValue<'a>>, key: &str) -> Result<&'a DeTable<'a>, String> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(table),
            _ => Err(self.wrong(value.span().start, &format!("`{key}` is a table, written [{key}]"))),
        }
    }

    /// The entries of a table, all of whose keys are known.
    fn keys<'a>(&self, table: &'a DeTable<'a>, within: &str, known: &[&str]) -> Result<Vec<Entry<'a>>, String> {
        // The table is sorted by name; what is said first should be what stands first.
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let entry = |(key, value): (&'a Spanned<toml::de::DeString<'a>>, &'a Spanned<DeValue<'a>>)| {
            let name: &str = key.get_ref();
            if known.contains(&name) {
                return Ok((name, value));
            }
            let help = match closest(name, known.iter().copied()) {
                Some(similar) => format!("did you mean `{similar}`?"),
                None => format!("known here: {}", known.join(", ")),
            };
            Err(self.wrong(key.span().start, &format!("unknown key `{within}{name}`; {help}")))
        };
        entries.into_iter().map(entry).collect()
    }

    fn wrong(&self, offset: usize, message: &str) -> String {
        let place = SourceFile::new(self.name, self.text)
            .map(|source| source.position(u32::try_from(offset).unwrap_or(u32::MAX)))
            .unwrap_or_default();
        // The parser's messages may go over several lines.
        let message = message.trim().replace('\n', ": ");
        format!("{}:{}:{}: {message}", self.name, place.line + 1, place.chars + 1)
    }
}

#[cfg(test)]
mod tests {
    use scenec_text::{Code, Severity};

    use super::read;

    fn check(text: &str, words: &str) {
        let error = read("scenec.toml", text).unwrap_err();
        assert_eq!(error, format!("scenec.toml:{words}"), "{text:?}");
    }

    #[test]
    fn levels_and_format_are_read_and_a_code_beats_its_kind() {
        let config = read(
            "t",
            "[lint]\nallow = ['W005']\ndeny = ['warnings']\n[fmt]\nalign = true\n",
        )
        .unwrap();
        assert_eq!(config.levels.of(Code::AfterSubmission), None);
        assert_eq!(config.levels.of(Code::UnusedVariable), Some(Severity::Error));
        assert!(config.format.align);
        assert_eq!(read("t", "").unwrap(), super::Config::default());
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        check("[lints]\n", "1:2: unknown key `lints`; did you mean `lint`?");
        check(
            "[lint]\nalow = []\n",
            "2:1: unknown key `lint.alow`; did you mean `allow`?",
        );
        check("[fmt]\nwidth = 1\n", "2:1: unknown key `fmt.width`; known here: align");
        check(
            "[lint]\ndeny = 'W005'\n",
            "2:8: `lint.deny` is a list of codes, such as [\"W005\"]",
        );
        check("[lint]\ndeny = [5]\n", "2:9: a code is a string, such as \"W005\"");
        check(
            "[lint]\ndeny = ['W05']\n",
            "2:9: there is no code `W05`; did you mean `W005`?",
        );
        check(
            "[lint]\nallow = ['E005']\n",
            "2:10: E005 is an error and stays one: with it the file means nothing",
        );
        check(
            "[lint]\nallow = ['W005']\ndeny = ['w005']\n",
            "3:9: `w005` stands in two lists",
        );
        check("lint = 1\n", "1:8: `lint` is a table, written [lint]");
        check("[fmt]\nalign = 1\n", "2:9: `fmt.align` is true or false");
        assert!(read("t", "a = = 1").unwrap_err().starts_with("t:1:5: "));
    }
}
