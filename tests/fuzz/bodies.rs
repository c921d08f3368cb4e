//! What has to hold whatever the bytes are: the bodies of the fuzz targets, which the property tests run as well.
//!
//! Each panics where a promise is broken.

#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each target uses one of them; a panic is what they are for"
)]

use scenec_syntax::{Content, FormatStyle, Line, format};
use scenec_text::{Diagnostic, Severity, SourceFile, Span};

/// Lines come in order, and every span lies in the file, between characters.
pub(crate) fn parse(bytes: &[u8]) {
    let (source, reading) = SourceFile::from_bytes("t", bytes.to_vec()).unwrap();
    let (lines, findings) = scenec_syntax::parse(&source);
    let mut end = 0;
    for line in &lines {
        let whole = line.comment.map_or(line.span, |comment| line.span.to(comment));
        assert!(inside(&source, line.span) && inside(&source, whole), "{line:?}");
        assert!(line.span.start >= end, "{line:?}");
        end = whole.end;
        if let Content::Statement(statement) = &line.content {
            let within =
                |span: Span| inside(&source, span) && span.start >= line.span.start && span.end <= line.span.end;
            assert!(within(statement.name()) && !statement.name().is_empty(), "{line:?}");
            assert!(statement.values().iter().all(|value| within(value.span)), "{line:?}");
        }
    }
    hold(&source, &reading);
    hold(&source, &findings);
    let broken = lines.iter().any(|line| matches!(line.content, Content::Broken(_)));
    assert!(!broken || failed(&reading) || failed(&findings));
}

/// There is a scene unless there is an error; findings come in order, and repairs can be applied.
pub(crate) fn lint(bytes: &[u8]) {
    let (source, reading) = SourceFile::from_bytes("t", bytes.to_vec()).unwrap();
    let checked = scenec_lint::check(&source);
    let (interpretation, findings) = (checked.interpretation, checked.diagnostics);
    assert_eq!(interpretation.scene.is_none(), failed(&reading) || failed(&findings));
    assert!(findings.is_sorted_by_key(|finding| finding.span().start));
    hold(&source, &findings);
    for fix in findings.iter().filter_map(|finding| finding.fix.as_ref()) {
        let mut edits: Vec<Span> = fix.edits.iter().map(|edit| edit.span).collect();
        edits.sort();
        assert!(!edits.is_empty() && !fix.title.is_empty(), "{fix:?}");
        assert!(edits.iter().all(|span| inside(&source, *span)), "{fix:?}");
        assert!(edits.windows(2).all(|pair| pair[0].end <= pair[1].start), "{fix:?}");
    }
}

/// A file is refused, or what it says stays and a second time changes nothing.
pub(crate) fn fmt(bytes: &[u8]) {
    let (source, _) = SourceFile::from_bytes("t", bytes.to_vec()).unwrap();
    let (lines, _) = scenec_syntax::parse(&source);
    let readable = |line: &Line| !matches!(line.content, Content::Broken(_));
    let sound = source.holes().is_empty() && lines.iter().all(readable);
    for align in [false, true] {
        let style = FormatStyle { align };
        let Ok(once) = format(&source, &lines, style) else {
            assert!(!sound, "a sound file is refused");
            continue;
        };
        assert!(sound, "a broken file is formatted");
        let formatted = SourceFile::new("t", once.as_str()).unwrap();
        let (again, _) = scenec_syntax::parse(&formatted);
        assert_eq!(words(&source, &lines), words(&formatted, &again));
        assert_eq!(format(&formatted, &again, style).unwrap(), once);
    }
}

/// What the lines say, without white space: the form, the words and the comment of each.
fn words(source: &SourceFile, lines: &[Line]) -> Vec<(Option<scenec_syntax::Form>, String, String)> {
    let text = source.text();
    let line = |line: &Line| {
        let form = match &line.content {
            Content::Statement(statement) => Some(statement.form()),
            _ => None,
        };
        let comment = line.comment.unwrap_or_default().of(text).trim_end();
        (
            form,
            line.span.of(text).split_whitespace().collect(),
            comment.to_owned(),
        )
    };
    lines.iter().map(line).collect()
}

fn hold(source: &SourceFile, findings: &[Diagnostic]) {
    for finding in findings {
        assert!(!finding.labels.is_empty() && !finding.message.is_empty(), "{finding:?}");
        let spans = finding.labels.iter().map(|label| label.span);
        assert!(spans.into_iter().all(|span| inside(source, span)), "{finding:?}");
    }
}

fn failed(findings: &[Diagnostic]) -> bool {
    findings.iter().any(|finding| finding.severity() == Severity::Error)
}

fn inside(source: &SourceFile, span: Span) -> bool {
    let boundary = |offset: u32| source.text().is_char_boundary(offset as usize);
    span.start <= span.end && boundary(span.start) && boundary(span.end)
}
