//! What each value of a statement is called and means.

use scenec_scene::MATERIAL_FIELDS;
use scenec_syntax::{Form, Token};

/// What a value of a form, or a name that it takes, means.
pub(crate) fn meaning(form: Form, number: usize) -> &'static str {
    const SPACE: [&str; 3] = ["along x", "along y", "along z"];
    let words: &[&'static str] = match form {
        Form::Material => return MATERIAL_FIELDS.get(number).map_or("", |field| field.meaning),
        Form::Variable => &["a number, `pi`, or a variable given before, with or without a sign"],
        Form::Object => &["`sphere`, `hp`, or the first of two objects"],
        Form::Combination => &["the object on the left", "the object on the right"],
        Form::MaterialSet => &["a material, taken as it stands here"],
        Form::Scale => &[
            "factor along x, not 0; a negative one mirrors",
            "factor along y, not 0; a negative one mirrors",
            "factor along z, not 0; a negative one mirrors",
        ],
        Form::Rotate => &["angle in radians, right-handed; `pi` is half a turn"],
        Form::Translate => &SPACE,
        Form::Submit => &[],
        Form::Light => &[
            "x of its place",
            "y of its place",
            "z of its place",
            "red of its light",
            "green of its light",
            "blue of its light",
        ],
    };
    words.get(number).copied().unwrap_or_default()
}

/// A form as the manual writes it, about the axis of this operator where it is a rotation, and with this one between the
/// operands where it is a combination.
pub(crate) fn label(form: Form, operator: Token) -> String {
    let text = form.info().text;
    match operator {
        Token::RotateX => text.replace("#y", "#x"),
        Token::RotateZ => text.replace("#y", "#z"),
        Token::And => text.replace('|', "&"),
        Token::Minus => text.replace('|', "-"),
        _ => text.to_owned(),
    }
}

/// What a value of a form is called.
pub(crate) fn name(form: Form, number: usize) -> &'static str {
    form.info().fields.get(number).copied().unwrap_or_default()
}
