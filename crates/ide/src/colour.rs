//! Colours in the text, and what an edit of one writes.

use scenec_interpret::DefinitionId;
use scenec_scene::setting;
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
            short(wanted)
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
    let part = part.clamp(0.0, 1.0);
    (0..4_usize)
        .map(|digits| format!("{part:.digits$}"))
        .find(|text| text.parse::<f64>().is_ok_and(|read| bytes([read; 3]) == wanted))
        .unwrap_or_else(|| format!("{part:.4}"))
}
