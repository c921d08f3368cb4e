//! Colours in the text, and what an edit of one writes.

use scenec_interpret::DefinitionId;
use scenec_scene::{DVec3, setting};
use scenec_syntax::{Content, Form, Statement, Value, ValueKind};
use scenec_text::{Edit, Span};

use crate::Document;
use crate::words::bytes;

/// The settings that are a colour together.
const AMBIENT: [&str; 3] = ["ambient_r", "ambient_g", "ambient_b"];

/// A colour that stands in the text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Swatch {
    /// The three numbers of a material or a light; the first of the three values of the ambient light.
    pub span: Span,
    /// Red, green and blue, each brought between 0 and 1.
    pub colour: [f64; 3],
}

/// Every colour of a document, in the order of the text: those of materials and lights, and the ambient light.
#[must_use]
pub fn colours(document: &Document) -> Vec<Swatch> {
    let ambient = ambient(document);
    let mut swatches: Vec<Swatch> = document
        .lines()
        .iter()
        .filter_map(|line| match &line.content {
            Content::Statement(statement) => own_colour(statement),
            Content::Comment | Content::Broken(_) => None,
        })
        .chain(ambient)
        .filter_map(|values| swatch(document, &values))
        .collect();
    swatches.sort_by_key(|swatch| swatch.span.start);
    swatches
}

/// The edits that give the swatch at `span` another colour, the one at the swatch first; numbers whose 8-bit value stays the same
/// are left as they are. `None` if no swatch is there, or if it names a variable, which may well be meant for other
/// things too.
#[must_use]
pub fn colour_edits(document: &Document, span: Span, colour: [f64; 3]) -> Option<Vec<Edit>> {
    let (statement, _) = document.statement_at(span.start)?;
    let values = own_colour(statement).or_else(|| ambient(document))?;
    if swatch(document, &values)?.span != span || values.iter().any(|value| matches!(value.kind, ValueKind::Name(_))) {
        return None;
    }
    let now = [0, 1, 2].map(|part| document.number(&values[part]));
    let mut texts = values.iter().zip(now).zip(colour).map(|((value, now), wanted)| {
        let same = now.is_some_and(|now| bytes([now; 3]) == bytes([wanted; 3]));
        if same {
            document.words(value.span).to_owned()
        } else {
            format!("{}{}", parting_sign(document, value), short(wanted))
        }
    });
    let [r, g, b] = [texts.next()?, texts.next()?, texts.next()?];
    if statement.form() == Form::Variable {
        let edits = values
            .iter()
            .zip([r, g, b])
            .map(|(value, text)| Edit { span: value.span, text });
        let mut edits: Vec<Edit> = edits.collect();
        edits.sort_by_key(|edit| edit.span.start);
        return Some(edits);
    }
    let gap = |left: usize, right: usize| document.words(Span::new(values[left].span.end, values[right].span.start));
    let text = format!("{r}{}{g}{}{b}", gap(0, 1), gap(1, 2));
    Some(vec![Edit { span, text }])
}

/// A sign alone may part a value from the one before it, as in `1-.5`: another one takes its place.
fn parting_sign(document: &Document, value: &Value) -> &'static str {
    let before = document.words(Span::new(0, value.span.start)).chars().next_back();
    let touches = before.is_some_and(|before| before.is_alphanumeric() || matches!(before, '.' | '_'));
    if touches { "+" } else { "" }
}

/// The values of the colour that a statement gives by itself.
fn own_colour(statement: &Statement) -> Option<[Value; 3]> {
    if !matches!(statement.form(), Form::Light | Form::Material) {
        return None;
    }
    statement.values().last_chunk().copied()
}

/// The values of the ambient light, as they count at the end of the file.
fn ambient(document: &Document) -> Option<[Value; 3]> {
    let value = |name: &str| {
        let id = setting(name).and_then(|row| document.setting(row))?;
        value_of(document, id)
    };
    let [r, g, b] = AMBIENT.map(value);
    Some([r?, g?, b?])
}

/// The ambient light as one colour, if a variable of this name is part of it.
pub(crate) fn ambient_with(document: &Document, name: &str) -> Option<DVec3> {
    let values = ambient(document).filter(|_| AMBIENT.contains(&name))?;
    document.numbers::<3>(&values).map(DVec3::from_array)
}

fn value_of(document: &Document, id: DefinitionId) -> Option<Value> {
    let line = document.definition_of(id)?.line;
    document.statement_at(line.start)?.0.values().first().copied()
}

fn swatch(document: &Document, values: &[Value; 3]) -> Option<Swatch> {
    let mut colour = [0.0; 3];
    for (part, value) in colour.iter_mut().zip(values) {
        *part = document.number(value)?.clamp(0.0, 1.0);
    }
    let [first, _, last] = values.map(|value| value.span);
    let one_line = document.source().line_of(first.start) == document.source().line_of(last.start);
    let span = if one_line {
        first.to(last)
    } else {
        values.iter().map(|value| value.span).min_by_key(|span| span.start)?
    };
    Some(Swatch { span, colour })
}

/// The shortest decimal with the same 8-bit value.
fn short(part: f64) -> String {
    let wanted = bytes([part; 3]);
    let part = if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) };
    (0..4_usize)
        .map(|digits| format!("{part:.digits$}"))
        .find(|text| text.parse::<f64>().is_ok_and(|read| bytes([read; 3]) == wanted))
        .unwrap_or_else(|| format!("{part:.4}"))
}

#[cfg(test)]
mod tests {
    use scenec_text::SourceFile;

    use super::{colour_edits, colours};
    use crate::Document;
    use crate::marked::marked;

    /// Gives every swatch, the last one first, the colour `wanted`; where that is refused nothing happens.
    fn check(text: &str, wanted: [f64; 3], expect: &str) {
        let (document, _) = marked(text);
        let mut edited = text.to_owned();
        for swatch in colours(&document).into_iter().rev() {
            let mut edits = colour_edits(&document, swatch.span, wanted).unwrap_or_default();
            edits.sort_by_key(|edit| edit.span.start);
            for edit in edits.iter().rev() {
                edited.replace_range(edit.span.range(), &edit.text);
            }
        }
        assert_eq!(edited, expect, "{text:?}");
    }

    #[test]
    fn edits_write_short_numbers_and_keep_the_rest() {
        let wanted = [0.5, 0.2, 2.0];
        check(
            "?m := 1 2 3 4 5 6 7  0.1\t9 1. / c",
            wanted,
            "?m := 1 2 3 4 5 6 7  0.5\t0.2 1. / c",
        );
        check("*l := 1 2 3 4 5 6\r\n", wanted, "*l := 1 2 3 0.5 0.2 6\r\n");
        check(
            "?m := 1 2 3 4 5 6 7 -1 0 pi",
            [0.0, 0.002, 0.123456],
            "?m := 1 2 3 4 5 6 7 -1 0.002 0.12",
        );
        check("*l := 1 2 3-1+.5-1", wanted, "*l := 1 2 3+0.5+0.2+1");
        check("!a := sphere\nx := 1\n", wanted, "!a := sphere\nx := 1\n");
        check("?m := 1 2 3 4 5 6 7 8 9", wanted, "?m := 1 2 3 4 5 6 7 8 9");
    }

    #[test]
    fn the_ambient_light_is_one_colour_of_three_lines() {
        check(
            "ambient_b := 1\nambient_r := 0\nambient_g := 0\nambient_r := 0.2 / last",
            [0.5, 0.25, 0.75],
            "ambient_b := 0.75\nambient_r := 0\nambient_g := 0.25\nambient_r := 0.5 / last",
        );
        check(
            "ambient_b := 1\nambient_r := 0",
            [0.5; 3],
            "ambient_b := 1\nambient_r := 0",
        );
    }

    #[test]
    fn a_variable_is_shown_and_never_rewritten() {
        let text = "red := 0.5\n?m := 1 2 3 4 5 6 7 red 0 -0.2";
        let document = Document::new(SourceFile::new("t", text).unwrap());
        let found = colours(&document);
        assert_eq!(found.len(), 1);
        assert_eq!(
            (found[0].colour, found[0].span.of(text)),
            ([0.5, 0.0, 0.0], "red 0 -0.2")
        );
        check(text, [0.1; 3], text);
        check("?m := 1 2 3 4 5 6 7 red 0 0", [0.1; 3], "?m := 1 2 3 4 5 6 7 red 0 0");
    }

    #[test]
    fn every_8_bit_value_comes_back_from_at_most_four_digits() {
        for byte in 0..=255_u8 {
            let text = super::short(f64::from(byte) / 255.0);
            let read: f64 = text.parse().unwrap();
            assert_eq!(super::bytes([read; 3])[0], byte, "{text}");
            assert!(text.len() <= 6, "{text}");
            assert_eq!(super::short(f64::NAN), "0");
        }
    }
}
