//! Operators, base objects and lights.

use scenec_interpret::DefinitionId;
use scenec_scene::{Base, DVec3};
use scenec_syntax::{Form, Statement, Token};
use scenec_text::Span;

use crate::Document;
use crate::fields::label;
use crate::look::Shape;
use crate::words::{bytes, code, hex, triple};

/// What the operator of a line does, or the sign between two objects.
pub(super) fn operator(shape: &Shape<'_>, token: Token) -> Option<String> {
    let joint = match token {
        Token::Or => "**union**: the points in either of two objects",
        Token::And => "**intersection**: the points in both of two objects",
        Token::Minus => "**subtraction**: the points in the left object and not in the right one",
        _ => "",
    };
    if !joint.is_empty() {
        let bound = "Both are taken as they stand on this line; later edits of either do not reach the combination.";
        return Some(format!(
            "{joint}\n\n{}\n\n{bound}",
            code(&label(Form::Combination, token))
        ));
    }
    let form = shape
        .form()
        .filter(|_| shape.operator.map(|piece| piece.token) == Some(token))?;
    Some(format!("{}\n\n{}", code(&label(form, token)), form.info().meaning))
}

/// A base object by its word.
pub(super) fn base(base: Base, word: &str) -> String {
    let words = match base {
        Base::Sphere => "the points at most 1 from the origin",
        Base::HalfSpace => "the half-space under y = 0; the normal of its surface is +y",
    };
    format!("**base object** {}: {words}", code(word))
}

/// A light by its name.
pub(super) fn light(document: &Document, name: Span, id: Option<DefinitionId>) -> Option<String> {
    let title = format!("**light** {}", code(&format!("*{}", document.words(name))));
    let Some(definition) = id.and_then(|id| document.definition_of(id)) else {
        return Some(format!("{title}\n\nThis statement is ignored."));
    };
    let (Statement::Light { values, .. }, _) = document.statement_at(definition.line.start)? else {
        return None;
    };
    let [x, y, z, r, g, b] = document.numbers(values.as_slice())?;
    let colour = DVec3::new(r, g, b);
    let [red, green, blue] = bytes([r, g, b]);
    let place = triple(DVec3::new(x, y, z));
    let mut text = format!(
        "{title}\n\nPoint light at {place}, colour {} (`{}`, rgb({red}, {green}, {blue})). It does not fade with distance.",
        triple(colour),
        hex(colour)
    );
    let last = document.binding(definition.symbol, u32::MAX);
    if let Some(later) = last
        .filter(|last| Some(*last) != id)
        .and_then(|last| document.definition_of(last))
    {
        let number = document.line_number(later.line.start);
        text.push_str(&format!(
            "\n\nThe light of the same name on line {number} takes its place."
        ));
    }
    Some(text)
}
