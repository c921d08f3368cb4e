//! Comments that silence a finding.

use scenec_lint::allow_also;
use scenec_syntax::Content;
use scenec_text::{Code, Diagnostic, Edit, Severity, Span};

use super::Offer;
use crate::Document;
use crate::insert::new_line_before;

/// To silence the finding's code on its line and in the whole file; nothing for an error, which can't be silenced.
pub(super) fn offers(document: &Document, finding: &Diagnostic) -> Vec<Offer> {
    let code = finding.code;
    // A remark about such a comment is beyond the comment's own reach.
    if finding.severity() == Severity::Error || code == Code::UselessAllow {
        return Vec::new();
    }
    let line = on_line(document, finding).map(|edit| (format!("allow {} on this line", code.id()), vec![edit]));
    let file = (
        format!("allow {} in this file", code.id()),
        vec![in_file(document, code)],
    );
    line.into_iter().chain([file]).collect()
}

fn on_line(document: &Document, finding: &Diagnostic) -> Option<Edit> {
    let text = document.text();
    let line = document.line_at(finding.span().start)?;
    if line.content == Content::Comment {
        return None;
    }
    let words = format!("scenec: allow {}", finding.code.id());
    let Some(comment) = line.comment else {
        return Some(Edit {
            span: Span::at(line.span.end),
            text: format!("  / {words}"),
        });
    };
    if let Some(edit) = allow_also(comment, text, finding.code) {
        return Some(edit);
    }
    // What the comment said becomes the reason.
    let said = comment.of(text).trim_start_matches('/');
    let space = if said.starts_with(char::is_whitespace) || said.is_empty() {
        ""
    } else {
        " "
    };
    Some(Edit {
        span: Span::at(comment.end - u32::try_from(said.len()).ok()?),
        text: format!(" {words}{space}"),
    })
}

fn in_file(document: &Document, code: Code) -> Edit {
    let head = document
        .lines()
        .iter()
        .take_while(|line| line.content == Content::Comment);
    let merged = head
        .filter_map(|line| line.comment)
        .find_map(|comment| allow_also(comment, document.text(), code));
    merged.unwrap_or_else(|| {
        let first = document.source().line_span(0).unwrap_or_default();
        new_line_before(document, first, &format!("/ scenec: allow {}", code.id()))
    })
}
