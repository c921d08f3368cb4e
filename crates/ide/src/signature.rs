//! Which of a statement's values the cursor is in, on half a line too.

use scenec_syntax::Form;

use crate::Document;
use crate::fields::{label, meaning};
use crate::look::{Look, Shape};

/// A statement's form with its parts.
#[derive(Clone, PartialEq, Debug)]
pub struct Signature {
    /// The form, as in `!x += a b c`.
    pub label: String,
    /// What it does, in Markdown.
    pub documentation: String,
    /// Its values, or the names that it takes.
    pub parameters: Vec<Parameter>,
    /// The number of the one that the cursor is in.
    pub active: u32,
}

/// A part of a form.
#[derive(Clone, PartialEq, Debug)]
pub struct Parameter {
    /// Where it stands in the label, in bytes.
    pub range: (u32, u32),
    /// What it means, in Markdown.
    pub documentation: String,
}

/// The form of the statement at an offset; `None` before its operator, in a comment, and behind its last value.
#[must_use]
pub fn signature(document: &Document, offset: u32) -> Option<Signature> {
    let offset = document.cursor(offset);
    let look = Look::at(document.source(), offset)?;
    if look.in_comment(offset) {
        return None;
    }
    let whole = look.shape();
    let operator = whole.operator.filter(|operator| operator.span.end <= offset)?;
    let form = whole.form()?;
    let label = label(form, operator.token);
    let parameters = parameters(form, &label);
    let active = active(&whole, form, offset);
    (active < parameters.len()).then(|| Signature {
        documentation: form.info().meaning.to_owned(),
        label,
        parameters,
        active: u32::try_from(active).unwrap_or(u32::MAX),
    })
}

/// The words behind the operator, signs between names aside.
fn parameters(form: Form, label: &str) -> Vec<Parameter> {
    let start = label.find('=').map_or(0, |at| at + 1);
    let mut at = start;
    let mut parameters = Vec::new();
    for word in label.get(start..).unwrap_or_default().split(' ') {
        let end = at + word.len();
        if word.chars().all(char::is_alphanumeric) && !word.is_empty() {
            let number = parameters.len();
            parameters.push(Parameter {
                range: (place(at), place(end)),
                documentation: meaning(form, number).to_owned(),
            });
        }
        at = end + 1;
    }
    parameters
}

fn place(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

/// How many values end before the cursor; one that it touches is the one that it is in.
fn active(shape: &Shape<'_>, form: Form, offset: u32) -> usize {
    if form == Form::Combination {
        return usize::from(shape.tail.get(1).is_some_and(|joint| joint.span.end <= offset));
    }
    shape.values().iter().filter(|spot| spot.span.end < offset).count()
}

#[cfg(test)]
mod tests {
    use super::signature;
    use crate::marked::marked;

    /// Compares the part of the form that the cursor is in.
    fn check(text: &str, expect: Option<&str>) {
        let (document, offset) = marked(text);
        let found = signature(&document, offset);
        let part = found.as_ref().map(|signature| {
            let (start, end) = signature.parameters[signature.active as usize].range;
            &signature.label[start as usize..end as usize]
        });
        assert_eq!(part, expect, "{text:?}");
    }

    #[test]
    fn the_part_at_the_cursor_is_told_on_half_a_line() {
        check("?m :=$0", Some("ambref"));
        check("?m := 1 $0", Some("diffref"));
        check("?m := 1 2$0", Some("diffref"));
        check("?m := 1 -$0", Some("diffref"));
        check("?m := 1 -2 -x $0 4", Some("rflec"));
        check("?m := 1 2 3 4 5 6 7 8 9 10$0", Some("b"));
        check("?m := 1 2 3 4 5 6 7 8 9 10 $0", None);
        check("*l := 1 2 3 $0", Some("r"));
        check("!a #z= $0", Some("v"));
        check("!a += 1 2 $0 / c", Some("c"));
        check("!a += 1 2 / $0", None);
        check("!a := $0", Some("sphere"));
        check("!a := b | $0", Some("y"));
        check("!a := b$0 | c", Some("x"));
        check("!a ?= $0", Some("m"));
        check("!a <= $0", None);
        check("!a $0", None);
        check("x := $0", Some("v"));
        check("$0", None);
    }
}
