//! Another name for something, in every place.

use std::fmt;

use scenec_interpret::Role;
use scenec_scene::setting;
use scenec_syntax::{Space, Token, quote, scan};
use scenec_text::{Edit, Span};

use crate::Document;
use crate::names::{Named, name_at, names_of, places};

/// A name that can be changed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Renameable {
    /// The name without a sigil.
    pub span: Span,
    /// The same in words, to begin from.
    pub placeholder: String,
}

/// Why a name is not changed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum RenameError {
    /// There is no name at the place.
    NoName,
    /// The language reads this variable by its name.
    Setting {
        /// The name.
        name: String,
    },
    /// The new name is not one.
    Malformed {
        /// The word.
        name: String,
    },
    /// The new name is that of the constant.
    Constant,
    /// The new name is taken.
    Taken {
        /// The new name with its sigil.
        name: String,
        /// The line where it stands first, from 1.
        line: u32,
    },
}

impl fmt::Display for RenameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoName => write!(f, "there is no name here to change"),
            Self::Setting { name } => write!(f, "{} is a setting, which is known by its name", quote(name)),
            Self::Malformed { name } => write!(
                f,
                "{} is no name: a name is a letter or `_`, then letters, digits and `_`",
                quote(name)
            ),
            Self::Constant => write!(f, "`pi` is a constant and can't be assigned"),
            Self::Taken { name, line } => write!(f, "{} is taken: it stands on line {line}", quote(name)),
        }
    }
}

impl std::error::Error for RenameError {}

/// The name at `offset`, if it can be changed.
///
/// # Errors
/// [`RenameError::NoName`] and [`RenameError::Setting`].
pub fn prepare_rename(document: &Document, offset: u32) -> Result<Renameable, RenameError> {
    let name = name_at(document, offset).ok_or(RenameError::NoName)?;
    let word = name.span.of(document.text());
    // A setting with another spelling can be changed to that.
    let fixed = name.space == Space::Variable && setting(word).is_some_and(|row| row.alias.is_none());
    if fixed {
        return Err(RenameError::Setting { name: word.to_owned() });
    }
    Ok(Renameable {
        span: name.span,
        placeholder: word.to_owned(),
    })
}

/// The edits that write `to` wherever the name at `offset` stands in its name space. The file means what it did.
///
/// # Errors
/// Whatever keeps it from being the same file under another name.
pub fn rename(document: &Document, offset: u32, to: &str) -> Result<Vec<Edit>, RenameError> {
    prepare_rename(document, offset)?;
    let name = name_at(document, offset).ok_or(RenameError::NoName)?;
    let to = to.trim();
    let to = to.strip_prefix(name.space.sigil()).unwrap_or(to);
    let from = name.span.of(document.text());
    if to == from {
        return Ok(Vec::new());
    }
    if !is_name(to) {
        return Err(RenameError::Malformed { name: to.to_owned() });
    }
    if name.space == Space::Variable {
        settle_variable(from, to)?;
    }
    if let Some(line) = first_line_of(document, name.space, to) {
        return Err(RenameError::Taken {
            name: format!("{}{to}", name.space.sigil()),
            line: line + 1,
        });
    }
    let places = places(document, name);
    let edit = |place: &Named| Edit {
        span: place.span,
        text: to.to_owned(),
    };
    Ok(places.iter().map(edit).collect())
}

/// A variable's name may be one that the language reads; only another spelling of the same setting keeps the meaning.
fn settle_variable(from: &str, to: &str) -> Result<(), RenameError> {
    if to == "pi" {
        return Err(RenameError::Constant);
    }
    if setting(from) == setting(to) {
        return Ok(());
    }
    let known = if setting(from).is_some() { from } else { to };
    Err(RenameError::Setting { name: known.to_owned() })
}

/// Whether the word is a name of the language.
pub(crate) fn is_name(word: &str) -> bool {
    let mut words = scan(word);
    let first = words.next().map(|(token, span)| (token, span.len() as usize));
    first == Some((Token::Name, word.len())) && words.next().is_none()
}

/// The line on which a name first stands, from 0.
fn first_line_of(document: &Document, space: Space, name: &str) -> Option<u32> {
    let text = document.text();
    let symbols = document.interpretation().symbols.symbols().iter();
    let known = symbols
        .filter(|symbol| symbol.space == space && symbol.name.of(text) == name)
        .map(|symbol| symbol.name.start);
    let broken = document.lines().iter().filter_map(|line| match &line.content {
        scenec_syntax::Content::Broken(broken) => Some(broken),
        _ => None,
    });
    let guessed = broken
        .flat_map(|broken| names_of(text, broken))
        .filter(|place| place.space == space && place.role != Role::Edit && place.span.of(text) == name)
        .map(|place| place.span.start);
    let first = known.chain(guessed).min()?;
    Some(document.source().line_of(first))
}

#[cfg(test)]
mod tests {
    use scenec_text::apply;

    use super::{prepare_rename, rename};
    use crate::marked::marked;

    /// The text afterwards, or why there is none.
    fn check(text: &str, to: &str, expect: &str) {
        let (document, offset) = marked(text);
        let found = match rename(&document, offset, to) {
            Ok(edits) => apply(document.text(), &edits),
            Err(error) => error.to_string(),
        };
        assert_eq!(found, expect, "{text}");
    }

    #[test]
    fn every_place_of_the_space_changes_and_no_other() {
        check(
            "a := 1\n!a := sphere\n!$0a += a a 0\n!u := a - a",
            "é_1",
            "a := 1\n!é_1 := sphere\n!é_1 += a a 0\n!u := é_1 - é_1",
        );
        check("!a := sphere\n!u := $0a | ", "!b", "!b := sphere\n!u := b | ");
        check("$0raydepth := 1", "max_reflections", "max_reflections := 1");
    }

    #[test]
    fn what_would_change_the_meaning_is_refused() {
        check("a := 1\nb := $0a", "b", "`b` is taken: it stands on line 2");
        check(
            "!a := sphere\n!b <=\n!$0a <=",
            "b",
            "`!b` is taken: it stands on line 2",
        );
        check(
            "b := $0a",
            "1a",
            "`1a` is no name: a name is a letter or `_`, then letters, digits and `_`",
        );
        check(
            "b := $0a",
            "",
            "`` is no name: a name is a letter or `_`, then letters, digits and `_`",
        );
        check("b := $0a", "pi", "`pi` is a constant and can't be assigned");
        check("!$0a := sphere", "pi", "!pi := sphere");
        check("b := $0a", "width", "`width` is a setting, which is known by its name");
        check("$0width := 1", "w", "`width` is a setting, which is known by its name");
        check("!a := $0sphere", "w", "there is no name here to change");
    }

    #[test]
    fn the_place_to_rename_is_the_name_without_its_sigil() {
        let (document, offset) = marked("!ball$0 := sphere");
        let found = prepare_rename(&document, offset).unwrap();
        assert_eq!((found.span.start, found.placeholder.as_str()), (1, "ball"));
    }
}
