//! The words of a statement in the order in which they are written.

use scenec_text::Span;

use crate::{Axis, Form, Operator, Sign, Statement, Value, ValueKind};

/// A word, with the sigil or sign that touches it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Cell<'a> {
    pub(super) prefix: &'static str,
    pub(super) word: &'a str,
    /// Whether it is a number, which stands in a column by its point.
    pub(super) number: bool,
}

/// Hands every cell of a statement to `each`: the name it begins with, the operator, and what follows.
pub(super) fn cells<'a>(text: &'a str, statement: &Statement, mut each: impl FnMut(Cell<'a>)) {
    each(Cell {
        prefix: statement.form().info().space.sigil(),
        word: statement.name().of(text),
        number: false,
    });
    each(plain(operator(statement)));
    match statement {
        Statement::Object { base: word, .. } | Statement::MaterialSet { material: word, .. } => {
            each(plain(word.of(text)));
        }
        Statement::Combination {
            operator, left, right, ..
        } => {
            each(plain(left.of(text)));
            each(plain(match operator {
                Operator::Union => "|",
                Operator::Intersection => "&",
                Operator::Subtraction => "-",
            }));
            each(plain(right.of(text)));
        }
        _ => statement
            .values()
            .iter()
            .for_each(|written| each(value(text, *written))),
    }
}

const fn plain(word: &str) -> Cell<'_> {
    Cell {
        prefix: "",
        word,
        number: false,
    }
}

fn operator(statement: &Statement) -> &'static str {
    match (statement.form(), statement) {
        (_, Statement::Rotate { axis, .. }) => match axis {
            Axis::X => "#x=",
            Axis::Y => "#y=",
            Axis::Z => "#z=",
        },
        (Form::MaterialSet, _) => "?=",
        (Form::Scale, _) => "*=",
        (Form::Translate, _) => "+=",
        (Form::Submit, _) => "<=",
        _ => ":=",
    }
}

fn value(text: &str, value: Value) -> Cell<'_> {
    // White space may stand between a sign and what it belongs to.
    let unsigned = Span::new(value.span.start + u32::from(value.sign.is_some()), value.span.end);
    Cell {
        prefix: match value.sign {
            Some(Sign::Minus) => "-",
            Some(Sign::Plus) => "+",
            None => "",
        },
        word: unsigned.of(text).trim_start(),
        number: matches!(value.kind, ValueKind::Number(_)),
    }
}
