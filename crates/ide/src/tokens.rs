//! What every word of a text is, for colouring it.
//!
//! The kinds are those that editors know, chosen so that common themes tell the name spaces apart: a setting is a
//! property, an author's variable a variable, an object a class (something that is made), a material an enum member (a
//! named constant) and a light a function. The sigil before a name takes the kind of the name.

use scenec_interpret::{Occurrence, Role};
use scenec_scene::{Base, setting};
use scenec_syntax::{Content, Line, Space, Statement, Token as Word, scan};
use scenec_text::Span;

use crate::Document;
use crate::names::{Named, names_of};

/// What a word is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TokenKind {
    /// A comment.
    Comment,
    /// The word for a base object.
    Keyword,
    /// A number; its sign is an operator.
    Number,
    /// An operator.
    Operator,
    /// The name of an author's variable, and `pi`.
    Variable,
    /// The name of a variable that the language reads.
    Setting,
    /// The name of an object, and its sigil.
    Object,
    /// The name of a material, and its sigil.
    Material,
    /// The name of a light, and its sigil.
    Light,
}

impl TokenKind {
    /// Every kind, in the order of their numbers in a legend.
    pub const ALL: [Self; 9] = [
        Self::Comment,
        Self::Keyword,
        Self::Number,
        Self::Operator,
        Self::Variable,
        Self::Setting,
        Self::Object,
        Self::Material,
        Self::Light,
    ];

    /// The name that editors have for such a word.
    #[must_use]
    pub const fn standard_name(self) -> &'static str {
        match self {
            Self::Comment => "comment",
            Self::Keyword => "keyword",
            Self::Number => "number",
            Self::Operator => "operator",
            Self::Variable => "variable",
            Self::Setting => "property",
            Self::Object => "class",
            Self::Material => "enumMember",
            Self::Light => "function",
        }
    }
}

/// What else there is to say about a word: a set of bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Modifiers(u32);

impl Modifiers {
    /// None of them.
    pub const NONE: Self = Self(0);
    /// The statement binds the name.
    pub const DECLARATION: Self = Self(1);
    /// The statement changes what the name is bound to.
    pub const MODIFICATION: Self = Self(2);
    /// It can't be assigned: `pi`.
    pub const READONLY: Self = Self(4);
    /// The language gives it its meaning: a setting, `pi`, the word for a base object.
    pub const DEFAULT_LIBRARY: Self = Self(8);

    /// The names that editors have for the bits, the lowest first.
    pub const STANDARD_NAMES: [&'static str; 4] = ["declaration", "modification", "readonly", "defaultLibrary"];

    /// The bits as a number.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Both sets together.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether all of `other` are among them.
    #[must_use]
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

/// A word in its place, never longer than its line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Token {
    /// The place.
    pub span: Span,
    /// What it is.
    pub kind: TokenKind,
    /// What else there is to say.
    pub modifiers: Modifiers,
}

/// The words on the lines that `span` touches, in order. What is no word of the language is left out.
#[must_use]
pub fn tokens(document: &Document, span: Span) -> Vec<Token> {
    let source = document.source();
    let first = source.line_span(source.line_of(span.start)).unwrap_or_default();
    let last = source.line_span(source.line_of(span.end)).unwrap_or_default();
    let whole = Span::new(first.start, last.end);
    let lines = document.lines();
    let places = document.occurrences();
    let mut painter = Painter {
        document,
        lines: lines
            .get(lines.partition_point(|line| line.span.start < whole.start)..)
            .unwrap_or_default(),
        places: places
            .get(places.partition_point(|place| place.span.start < whole.start)..)
            .unwrap_or_default(),
    };
    scan(whole.of(document.text()))
        .filter_map(|(word, place)| {
            let span = Span::new(whole.start + place.start, whole.start + place.end);
            painter.paint(word, span)
        })
        .collect()
}

/// Walks over the lines and the known names beside the words.
struct Painter<'a> {
    document: &'a Document,
    /// The lines from the one at hand on.
    lines: &'a [Line],
    /// The names from the one at hand on.
    places: &'a [Occurrence],
}

impl Painter<'_> {
    fn paint(&mut self, word: Word, span: Span) -> Option<Token> {
        let (kind, modifiers) = match word {
            Word::Newline => {
                return None;
            }
            Word::Comment => (TokenKind::Comment, Modifiers::NONE),
            Word::Number => (TokenKind::Number, Modifiers::NONE),
            Word::Bang => (TokenKind::Object, Modifiers::NONE),
            Word::Question => (TokenKind::Material, Modifiers::NONE),
            Word::Star => (TokenKind::Light, Modifiers::NONE),
            Word::Name => self.name(span),
            Word::Bad => return None,
            _ => (TokenKind::Operator, Modifiers::NONE),
        };
        let text = span.of(self.document.text());
        let trimmed = u32::try_from(text.trim_end_matches('\r').len()).unwrap_or_default();
        let span = Span::new(span.start, span.start + trimmed);
        Some(Token { span, kind, modifiers })
    }

    fn name(&mut self, span: Span) -> (TokenKind, Modifiers) {
        let text = self.document.text();
        while let [first, rest @ ..] = self.places
            && first.span.start < span.start
        {
            self.places = rest;
        }
        while let [first, rest @ ..] = self.lines
            && first.span.end < span.end
        {
            self.lines = rest;
        }
        if let Some(place) = self.places.first().filter(|place| place.span == span) {
            let symbols = self.document.interpretation().symbols.symbols();
            let space = symbols.get(place.symbol.0 as usize).map(|symbol| symbol.space);
            return named(span.of(text), space.unwrap_or(Space::Variable), Some(place.role));
        }
        match self.lines.first().map(|line| &line.content) {
            Some(Content::Statement(Statement::Object { base, .. })) if *base == span => KEYWORD,
            Some(Content::Broken(broken)) => {
                let place: Option<Named> = names_of(text, broken).find(|name| name.span == span);
                match place {
                    Some(place)
                        if place.space == Space::Object && place.role == Role::Use && is_base(span.of(text)) =>
                    {
                        KEYWORD
                    }
                    Some(place) => named(span.of(text), place.space, Some(place.role)),
                    None => named(span.of(text), Space::Variable, None),
                }
            }
            _ => named(span.of(text), Space::Variable, None),
        }
    }
}

const KEYWORD: (TokenKind, Modifiers) = (TokenKind::Keyword, Modifiers::DEFAULT_LIBRARY);

fn is_base(word: &str) -> bool {
    Base::ALL.iter().any(|(_, known)| *known == word)
}

fn named(word: &str, space: Space, role: Option<Role>) -> (TokenKind, Modifiers) {
    let role = match role {
        Some(Role::Define) => Modifiers::DECLARATION,
        Some(Role::Edit) => Modifiers::MODIFICATION,
        Some(Role::Use) | None => Modifiers::NONE,
    };
    match space {
        Space::Object => (TokenKind::Object, role),
        Space::Material => (TokenKind::Material, role),
        Space::Light => (TokenKind::Light, role),
        Space::Variable if word == "pi" => (
            TokenKind::Variable,
            Modifiers::READONLY.with(Modifiers::DEFAULT_LIBRARY),
        ),
        Space::Variable if setting(word).is_some() => (TokenKind::Setting, role.with(Modifiers::DEFAULT_LIBRARY)),
        Space::Variable => (TokenKind::Variable, role),
    }
}

#[cfg(test)]
mod tests {
    use scenec_text::Span;

    use super::{Modifiers, tokens};
    use crate::tests::document;

    /// Every word with the name of its kind and the letters of its modifiers.
    fn check(text: &str, expect: &str) {
        let document = document(text);
        let all = tokens(&document, Span::new(0, u32::try_from(text.len()).unwrap()));
        let found: Vec<String> = all
            .iter()
            .map(|token| {
                let bits = (0..4).filter(|bit| token.modifiers.bits() & (1 << bit) != 0);
                let letters: String = bits.map(|bit| &Modifiers::STANDARD_NAMES[bit][..1]).collect();
                format!("{} {}{letters}", token.span.of(text), token.kind.standard_name())
            })
            .collect();
        assert_eq!(found.join(", "), expect, "{text}");
    }

    #[test]
    fn names_are_told_apart_by_their_space() {
        check("width := pi", "width propertydd, := operator, pi variablerd");
        check(
            "a := -1 / c\r\n",
            "a variabled, := operator, - operator, 1 number, / c comment",
        );
        check(
            "!s := sphere\n!s ?= m",
            "! class, s classd, := operator, sphere keywordd, ! class, s classm, ?= operator, m enumMember",
        );
        check("*l := 1 2", "* function, l functiond, := operator, 1 number, 2 number");
    }

    #[test]
    fn broken_lines_are_coloured_as_far_as_they_are_words() {
        check(
            "!z := sphere | x $ y",
            "! class, z classd, := operator, sphere keywordd, | operator, x class, y class",
        );
        check(
            "!z ?= m m",
            "! class, z classm, ?= operator, m enumMember, m enumMember",
        );
        check("$$", "");
    }

    #[test]
    fn a_part_is_the_same_as_in_the_whole() {
        let document = document("a := 1\nb := a\nc := b");
        let part: Vec<_> = tokens(&document, Span::at(8)).iter().map(|token| token.span).collect();
        assert_eq!(part, [Span::new(7, 8), Span::new(9, 11), Span::new(12, 13)]);
    }
}
