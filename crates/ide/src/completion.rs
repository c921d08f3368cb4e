//! What may be written at the cursor: statements, operators, names, values, settings.

mod form;
mod names;
mod whole;

use scenec_scene::Base;
use scenec_syntax::{Form, Space, Token};
use scenec_text::Span;

use crate::Document;
use crate::look::{Look, Piece, Shape, is_joint};

/// Something that may be written at the cursor.
#[derive(Clone, PartialEq, Debug)]
pub struct Completion {
    /// What the list shows, and what typed letters are compared with.
    pub label: String,
    /// What it is.
    pub kind: CompletionKind,
    /// A short phrase beside the label; may be empty.
    pub detail: String,
    /// More about it, in Markdown; may be empty.
    pub documentation: String,
    /// What is replaced: the word or the operator at the cursor, or nothing.
    pub replace: Span,
    /// What stands there afterwards.
    pub insert: String,
    /// Whether `insert` is a snippet with places to fill in, rather than plain text.
    pub snippet: bool,
    /// Its place in the list; smaller numbers first.
    pub order: u32,
}

/// What a completion writes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CompletionKind {
    /// A statement, or the rest of one.
    Statement,
    /// An operator.
    Operator,
    /// A base object.
    Base,
    /// The name of an object.
    Object,
    /// The name of a material.
    Material,
    /// The name of a light.
    Light,
    /// The name of a variable.
    Variable,
    /// A variable that the language reads.
    Setting,
    /// The constant `pi`, or a number.
    Constant,
}

/// What may be written at an offset. Names are those that are bound on earlier lines.
#[must_use]
pub fn completions(document: &Document, offset: u32) -> Vec<Completion> {
    let Some(look) = Look::at(document.source(), offset).filter(|look| !look.in_comment(offset)) else {
        return Vec::new();
    };
    if look.is_typing_number(offset) {
        return Vec::new();
    }
    let cursor = Cursor::new(document, &look, offset);
    let mut list = cursor.list();
    for (order, item) in (0..).zip(&mut list) {
        item.order = order;
    }
    list
}

/// Where the cursor is on its line.
struct Cursor<'a> {
    document: &'a Document,
    /// Where the line begins: names must be bound before it.
    line: u32,
    /// The tokens before what is being typed.
    before: Vec<Piece>,
    /// Whether other tokens follow.
    more: bool,
    /// What is being typed, which a completion replaces; empty where that is nothing.
    replace: Span,
    /// The part of it before the cursor.
    typed: &'a str,
}

impl<'a> Cursor<'a> {
    fn new(document: &'a Document, look: &Look, offset: u32) -> Self {
        let typing = look.pieces.iter().position(|piece| {
            let inside = piece.span.start < offset && offset <= piece.span.end;
            inside && is_unfinished(look, piece)
        });
        let replace = typing
            .and_then(|index| look.pieces.get(index))
            .map_or(Span::at(offset), |piece| piece.span);
        let before = look
            .pieces
            .iter()
            .take_while(|piece| piece.span.end <= replace.start)
            .copied();
        Self {
            document,
            line: look.line.start,
            before: before.collect(),
            more: look
                .pieces
                .iter()
                .any(|piece| piece.span.start >= replace.end.max(offset)),
            replace,
            typed: document.words(Span::new(replace.start, offset)),
        }
    }

    fn list(&self) -> Vec<Completion> {
        let shape = Shape::of(&self.before);
        match (shape.space, shape.name) {
            (None, _) if self.before.is_empty() => self.line_start(),
            (None, _) => Vec::new(),
            (Some(space), None) => self.subjects(space),
            (Some(space), Some(_)) if shape.operator.is_none() && shape.tail.is_empty() => self.operators(space),
            (Some(_), Some(_)) => shape.form().map(|form| self.parts(form, &shape)).unwrap_or_default(),
        }
    }

    /// What may stand behind an operator.
    fn parts(&self, form: Form, shape: &Shape<'_>) -> Vec<Completion> {
        let names = |space| self.names(space);
        match (form, shape.tail) {
            (Form::Object, []) => {
                let mut list = self.bases();
                list.extend(names(Space::Object));
                list
            }
            (Form::Object, [operand]) if operand.token == Token::Name => {
                let word = self.document.words(operand.span);
                let is_base = Base::ALL.iter().any(|(_, base)| *base == word);
                if is_base { Vec::new() } else { self.joints() }
            }
            (Form::Combination, [_, joint]) if is_joint(joint.token) => names(Space::Object),
            (Form::MaterialSet, []) => names(Space::Material),
            (Form::Variable, []) => self.values_of(shape),
            (_, _) if shape.values().len() < form.info().fields.len() || self.ends_in_sign(shape) => self.values(),
            _ => Vec::new(),
        }
    }

    fn ends_in_sign(&self, shape: &Shape<'_>) -> bool {
        let fields = shape.form().map_or(0, |form| form.info().fields.len());
        let values = shape.values();
        let last = values.last().map(|spot| spot.piece.token);
        values.len() == fields && matches!(last, Some(Token::Plus | Token::Minus))
    }

    fn item(&self, kind: CompletionKind, label: impl Into<String>) -> Completion {
        let label = label.into();
        Completion {
            insert: label.clone(),
            label,
            kind,
            detail: String::new(),
            documentation: String::new(),
            replace: self.replace,
            snippet: false,
            order: 0,
        }
    }
}

/// Whether a token may become another one as more is typed: a name, or what may be the start of an operator.
fn is_unfinished(look: &Look, piece: &Piece) -> bool {
    match piece.token {
        Token::Name | Token::Bad => true,
        Token::Question | Token::Star | Token::Plus => {
            let third = look.pieces.get(2) == Some(piece);
            third && look.pieces.first().is_some_and(|first| first.token == Token::Bang)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use scenec_text::{Diagnostic, Severity};

    use super::completions;
    use crate::marked::marked;

    /// Compares what is offered: for each item the words it replaces, an arrow, and what it writes.
    fn check(text: &str, expect: &[&str]) {
        let (document, offset) = marked(text);
        let list = completions(&document, offset);
        let found: Vec<_> = list
            .iter()
            .map(|item| format!("{}→{}", item.replace.of(document.text()), item.insert))
            .collect();
        assert_eq!(found, expect, "{text:?}");
        for (order, item) in (0..).zip(&list) {
            assert_eq!(item.order, order);
            assert!(item.replace.start <= offset && offset <= item.replace.end, "{item:?}");
        }
    }

    /// Whether something among much else is offered.
    fn offers(text: &str, insert: &str) -> bool {
        let (document, offset) = marked(text);
        completions(&document, offset).iter().any(|item| item.insert == insert)
    }

    const SCENE: &str = "ball := 2\n!ball := sphere\n!wall := hp\n?clay := 0 0 0 0 0 1 0 0 0 0\n*lamp := 0 0 0 1 1 1\n";

    fn after(line: &str, expect: &[&str]) {
        check(&format!("{SCENE}{line}\n!late := sphere\nlate := 1"), expect);
    }

    #[test]
    fn names_are_those_of_the_place_bound_before() {
        after("!u := $0", &["→sphere", "→hp", "→ball", "→wall"]);
        after("!u := ba$0", &["ba→sphere", "ba→hp", "ba→ball", "ba→wall"]);
        after(
            "!u := b$0all | wall",
            &["ball→sphere", "ball→hp", "ball→ball", "ball→wall"],
        );
        after("!u := ball $0", &["→|", "→&", "→-"]);
        after("!u := sphere $0", &[]);
        after("!u := ball | $0", &["→ball", "→wall"]);
        after("!u := ball -$0", &["→ball", "→wall"]);
        after("!u := ball | wall $0", &[]);
        after("!ball ?= $0", &["→clay"]);
        after("!ball ?=$0", &["→clay"]);
        after("!ball += $0", &["→ball", "→pi"]);
        after("!ball += 1 -$0", &["→ball", "→pi"]);
        after("!ball += 1 2 -$0", &["→ball", "→pi"]);
        after("!ball += 1 2 3 $0", &[]);
        after("!ball #x= p$0", &["p→ball", "p→pi"]);
        after("x := $0", &["→ball", "→pi"]);
        after("raydepth := $0", &["→4", "→ball", "→pi"]);
        after("fov := $0", &["→1.5707963267948966", "→ball", "→pi"]);
        after("!ball += 1$0", &[]);
        after("!ball <= $0", &[]);
        after("/ $0", &[]);
        after("x := 1 / !$0", &[]);
    }

    #[test]
    fn operators_bring_the_rest_of_their_statement() {
        let all = |typed: &str| {
            [
                ":= ${1|sphere,hp|}",
                ":= ${1:x} ${2|\\|,&,-|} ${3:y}",
                "?= ${1:m}",
                "*= ${1:1} ${2:1} ${3:1}",
                "#x= ${1:pi}",
                "#y= ${1:pi}",
                "#z= ${1:pi}",
                "+= ${1:0} ${2:0} ${3:0}",
                "<=",
            ]
            .map(|rest| format!("{typed}→{rest}"))
        };
        for (line, typed) in [
            ("!ball $0", ""),
            ("!ball :$0", ":"),
            ("!ball ?$0", "?"),
            ("!ball *$0", "*"),
            ("!ball +$0", "+"),
            ("!ball <$0", "<"),
            ("!ball #x$0", "#x"),
        ] {
            after(line, &all(typed).each_ref().map(String::as_str));
        }
        after("*lamp $0", &["→:= ${1:0} ${2:5} ${3:5} ${4:1} ${5:1} ${6:1}"]);
        after("x $0", &["→:= ${1:0}"]);
        after(
            "!ball $0 1 2 3",
            &["→:=", "→?=", "→*=", "→#x=", "→#y=", "→#z=", "→+=", "→<="],
        );
        after("x + $0", &[]);
    }

    #[test]
    fn a_line_begins_with_a_setting_a_statement_or_a_name() {
        assert!(offers("wi$0", "width := ${1:600}"));
        assert!(offers("width := 1\n$0", "height := ${1:400}"));
        assert!(!offers("width := 1\n$0", "width := ${1:600}"));
        assert!(!offers("max_reflections := 1\n$0", "raydepth := ${1:4}"));
        assert!(offers("$0", "!${1:x} #${2|x,y,z|}= ${3:pi}"));
        assert!(offers("x := 1\n$0", "x"));
        assert!(offers("$0 := 600", "width"));
        let (document, offset) = marked("height := 1\n$0\nwidth := 1");
        let all = completions(&document, offset).remove(0);
        assert_eq!(all.insert.lines().count(), 13, "{}", all.insert);
        assert!(
            all.insert.starts_with("lookat_x := ${1:0}\nlookat_y := ${2:0}"),
            "{}",
            all.insert
        );
        after(
            "*$0",
            &["→lamp", "*→*${1:x} := ${2:0} ${3:5} ${4:5} ${5:1} ${6:1} ${7:1}"],
        );
        after("*la$0mp := 1", &["lamp→lamp"]);
    }

    #[test]
    fn what_the_settings_begin_with_is_a_scene() {
        let (document, offset) = marked("!a := sphere\n!a <=\n$0");
        let all = completions(&document, offset).remove(0).insert;
        let lines = all.lines().map(|line| {
            let (name, value) = line.split_once("${").unwrap();
            format!("{name}{}\n", value.split_once(':').unwrap().1.trim_end_matches('}'))
        });
        let (document, _) = marked(&format!("!a := sphere\n!a <=\n{}", lines.collect::<String>()));
        assert!(document.scene().is_some());
        let grave = |finding: &&Diagnostic| finding.severity() != Severity::Hint;
        assert_eq!(document.diagnostics().iter().find(grave), None);
    }
}
