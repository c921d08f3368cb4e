//! What the editor writes between the words: the names of values, angles, and where an object ends up.

use scenec_interpret::{DefinitionId, Occurrence};
use scenec_scene::{SettingRange, setting};
use scenec_syntax::{Content, Form, Statement, Value, ValueKind};
use scenec_text::Span;

use crate::Document;
use crate::extent::Extent;
use crate::fields::{meaning, name};
use crate::solid::{Made, Shape, Standing};
use crate::words::{angle, degrees, figure, triple};

/// A few words that stand between those of the text.
#[derive(Clone, PartialEq, Debug)]
pub struct InlayHint {
    /// Where it stands.
    pub offset: u32,
    /// The words.
    pub label: String,
    /// What they tell.
    pub kind: InlayKind,
    /// More about it, in Markdown; may be empty.
    pub tooltip: String,
}

/// What an inlay hint tells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum InlayKind {
    /// What the value behind it is.
    Parameter,
    /// What the value before it amounts to.
    Angle,
    /// Where the object of the line before it is.
    Position,
}

/// The hints of the lines that a span touches, in order.
#[must_use]
pub fn inlay_hints(document: &Document, span: Span) -> Vec<InlayHint> {
    let first = document.lines().partition_point(|line| line.span.end < span.start);
    let lines = document.lines().get(first..).unwrap_or_default();
    let mut hints = Vec::new();
    for line in lines.iter().take_while(|line| line.span.start <= span.end) {
        if let Content::Statement(statement) = &line.content {
            fields(statement, &mut hints);
            hints.extend(turn(document, statement));
            hints.extend(position(document, statement, line.span));
        }
    }
    hints
}

/// The names of the values of materials and lights.
fn fields(statement: &Statement, hints: &mut Vec<InlayHint>) {
    let form = statement.form();
    if !matches!(form, Form::Material | Form::Light) {
        return;
    }
    hints.extend(statement.values().iter().enumerate().map(|(number, value)| InlayHint {
        offset: value.span.start,
        label: format!("{}:", name(form, number)),
        kind: InlayKind::Parameter,
        tooltip: meaning(form, number).to_owned(),
    }));
}

/// The angle of a rotation or of the field of view, where it is not written with `pi` already.
fn turn(document: &Document, statement: &Statement) -> Option<InlayHint> {
    let value: &Value = match statement {
        Statement::Rotate { angle, .. } => angle,
        Statement::Variable { name, value } if is_angle(document.words(*name)) => value,
        _ => return None,
    };
    let radians = document.number(value).filter(|radians| *radians != 0.0)?;
    (value.kind != ValueKind::Pi).then(|| InlayHint {
        offset: value.span.end,
        label: format!(" = {}", angle(radians)),
        kind: InlayKind::Angle,
        tooltip: format!("{} radians, {}", figure(radians), degrees(radians)),
    })
}

/// Where an object is: behind the last of several transforms, and at the submission. Of a combination that is the middle
/// of the box around it.
fn position(document: &Document, statement: &Statement, line: Span) -> Option<InlayHint> {
    let place = document.places_on(line).first()?;
    let id = place.definition?;
    let standing = match statement.form() {
        Form::Submit => Standing::of(document, id, line.start)?,
        form if is_transform(form) => {
            let moves = |edit: &&Occurrence| {
                let found = document.statement_at(edit.span.start);
                found.is_some_and(|(statement, _)| is_transform(statement.form()))
            };
            let last = document.facts().edits(document, id).rev().find(moves)?;
            if last.span != place.span {
                return None;
            }
            let whole = Standing::of(document, id, u32::MAX)?;
            let (last, _) = whole.steps.last().filter(|_| whole.steps.len() > 1)?;
            if *last != line {
                return None;
            }
            whole
        }
        _ => return None,
    };
    let label = match standing.shape() {
        Some(Shape::Ball { centre, .. }) => format!(" at {}", triple(centre)),
        Some(Shape::Half { point, normal }) => format!(" through {}, facing {}", triple(point), triple(normal)),
        None => parts(document, id),
    };
    let extent = Extent::of(document, id, &standing).filter(|_| standing.made == Made::Combination);
    let middle = extent.and_then(Extent::middle);
    Some(InlayHint {
        offset: line.end,
        label: middle.map_or(label.clone(), |middle| format!("{label} around {}", triple(middle))),
        kind: InlayKind::Position,
        tooltip: extent.and_then(Extent::words).unwrap_or_default(),
    })
}

fn is_angle(variable: &str) -> bool {
    setting(variable).is_some_and(|row| row.range == SettingRange::Angle)
}

const fn is_transform(form: Form) -> bool {
    matches!(form, Form::Scale | Form::Rotate | Form::Translate)
}

fn parts(document: &Document, id: DefinitionId) -> String {
    match document.facts().leaves(id) {
        u64::MAX => " base objects without number".to_owned(),
        1 => " 1 base object".to_owned(),
        count => format!(" {count} base objects"),
    }
}

#[cfg(test)]
mod tests {
    use scenec_text::Span;

    use super::inlay_hints;
    use crate::marked::marked;

    /// Compares the text with its hints written into it, each in angle quotes.
    fn check(text: &str, expect: &str) {
        let (document, _) = marked(text);
        let mut found = text.to_owned();
        for hint in inlay_hints(&document, Span::new(0, u32::MAX)).iter().rev() {
            found.insert_str(hint.offset as usize, &format!("‹{}›", hint.label));
        }
        assert_eq!(found, expect, "{text:?}");
    }

    #[test]
    fn values_of_materials_and_lights_are_named() {
        check("*l := 1 2 -x 4 5 6", "*l := ‹a:›1 ‹b:›2 ‹c:›-x ‹r:›4 ‹g:›5 ‹b:›6");
        check(
            "?m := 1 2 3 4 5 6 7 8 9 0",
            "?m := ‹ambref:›1 ‹diffref:›2 ‹specref:›3 ‹rflec:›4 ‹rfrac:›5 ‹rfracind:›6 ‹shiny:›7 ‹r:›8 ‹g:›9 ‹b:›0",
        );
        check("?m := 1 2 3", "?m := 1 2 3");
    }

    #[test]
    fn angles_are_told() {
        check(
            "!a := hp\n!a #x= 1.5707963267948966",
            "!a := hp\n!a #x= 1.5707963267948966‹ = pi/2›",
        );
        check("t := -0.5\n!a #x= -t", "t := -0.5\n!a #x= -t‹ = 28.6°›");
        check("fov := 1 / wide", "fov := 1‹ = 57.3°› / wide");
        check("!a #z= pi", "!a #z= pi");
        check("!a #z= 0", "!a #z= 0");
        check("!a #z= q", "!a #z= q");
    }

    #[test]
    fn an_object_is_where_its_transforms_brought_it() {
        check("!a := sphere\n!a += 1 0 0", "!a := sphere\n!a += 1 0 0");
        check(
            "!a := sphere\n!a += 1 0 0\n!a *= 2 2 2\n!a ?= m\n!a <= / c",
            "!a := sphere\n!a += 1 0 0\n!a *= 2 2 2‹ at (2, 0, 0)›\n!a ?= m\n!a <=‹ at (2, 0, 0)› / c",
        );
        check(
            "!a := hp\n!a #z= pi\n!a += 0 3 0",
            "!a := hp\n!a #z= pi\n!a += 0 3 0‹ through (0, 3, 0), facing (0, -1, 0)›",
        );
        check(
            "!a := sphere\n!a += 1 0 0\n!a *= 2 2 2\n!a += q 0 0",
            "!a := sphere\n!a += 1 0 0\n!a *= 2 2 2\n!a += q 0 0",
        );
        check(
            "!a := sphere\n!b := hp\n!c := a & b\n!c <=",
            "!a := sphere\n!b := hp\n!c := a & b\n!c <=‹ 2 base objects around (0, -0.5, 0)›",
        );
        check(
            "!a := hp\n!b := a | a\n!b := b & b\n!b <=",
            "!a := hp\n!b := a | a\n!b := b & b\n!b <=‹ 4 base objects›",
        );
    }
}
