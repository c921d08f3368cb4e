//! What is useless in a comment that allows something.

use scenec_syntax::quote;
use scenec_text::{Code, Diagnostic, Edit, Fix, Severity, SourceFile, Span, closest};

use super::allow::{Allow, Named};

/// A remark for each code that silenced nothing, among those that `about` picks; and one for a comment without a code.
pub(super) fn remarks(source: &SourceFile, allow: &Allow, about: &impl Fn(Option<Code>) -> bool) -> Vec<Diagnostic> {
    let text = source.text();
    if allow.named.is_empty() {
        return about(None).then(|| unclear(text, allow)).into_iter().collect();
    }
    let mut remarks = Vec::new();
    for (index, named) in allow.named.iter().enumerate() {
        if named.used || !about(named.code) {
            continue;
        }
        let mut remark = useless(text, named);
        let near = named.code.is_none() && remark.help.is_some();
        if !near {
            remark.fix = Some(Fix {
                title: "remove it".to_owned(),
                edits: vec![Edit {
                    span: without(source, allow, index),
                    text: String::new(),
                }],
                safe: true,
            });
        }
        remarks.push(remark);
    }
    remarks
}

fn unclear(text: &str, allow: &Allow) -> Diagnostic {
    let verb = allow.verb.of(text);
    let (message, place) = match verb {
        "allow" => ("this comment allows nothing".to_owned(), allow.verb),
        "" => ("this comment asks for nothing".to_owned(), allow.comment),
        _ => (format!("{} is no instruction to scenec", quote(verb)), allow.verb),
    };
    Diagnostic::new(Code::UselessAllow, message, place, "has no effect").help("write `/ scenec: allow W012, W013`")
}

fn useless(text: &str, named: &Named) -> Diagnostic {
    let word = quote(named.span.of(text));
    let finding = |message: String, label: &str| Diagnostic::new(Code::UselessAllow, message, named.span, label);
    match named.code {
        None => {
            let finding = finding(format!("there is no code {word}"), "has no effect");
            let known = Code::ALL.iter().filter(|code| code.severity() != Severity::Error);
            match closest(named.span.of(text), known.map(|code| code.id())) {
                Some(near) => finding.help(format!("did you mean `{near}`?")),
                None => finding,
            }
        }
        Some(code) if code.severity() == Severity::Error => {
            finding(format!("{word} is an error, which can't be allowed"), "has no effect")
        }
        Some(_) => finding(format!("there is no {word} here to allow"), "silences nothing"),
    }
}

/// What to remove so that a code is gone: its comment if it is the only one, else the code with a comma.
fn without(source: &SourceFile, allow: &Allow, index: usize) -> Span {
    let span = |index: usize| allow.named.get(index).map(|named| named.span);
    let here = span(index).unwrap_or_default();
    let before = index.checked_sub(1).and_then(span);
    match (before, span(index + 1)) {
        (_, Some(next)) => Span::new(here.start, next.start),
        (Some(before), None) => Span::new(before.end, here.end),
        (None, None) => comment(source, allow.comment),
    }
}

/// A comment with the white space before it; its line, if it stands there alone.
fn comment(source: &SourceFile, comment: Span) -> Span {
    let number = source.line_of(comment.start);
    let line = source.line_span(number).unwrap_or(comment);
    let before = Span::new(line.start, comment.start).of(source.text()).trim_end();
    if before.is_empty() {
        let end = source.line_span(number + 1).map_or(line.end, |next| next.start);
        return Span::new(line.start, end);
    }
    let kept = u32::try_from(before.len()).unwrap_or_default();
    Span::new(line.start + kept, comment.end)
}
