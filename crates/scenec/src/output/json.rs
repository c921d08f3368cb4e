//! All findings in one JSON array, and what a finding looks like in JSON.

use std::io::{self, Write};

use scenec_text::{SourceFile, Span};
use serde_json::{Value, json};

use super::{Place, Printer, slashes};
use crate::finding::{Checked, Finding};

/// Remembers whether something has been written, for the commas.
#[derive(Default)]
pub(super) struct Json {
    begun: bool,
}

impl Printer for Json {
    fn begin(&mut self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "[")
    }

    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        for finding in &checked.findings {
            let comma = if self.begun { "," } else { "" };
            self.begun = true;
            write!(out, "{comma}\n{:#}", record(&checked.source, finding))?;
        }
        Ok(())
    }

    fn end(&mut self, out: &mut dyn Write, _failures: &[String]) -> io::Result<()> {
        writeln!(out, "{}]", if self.begun { "\n" } else { "" })
    }
}

/// A finding with everything that is known about it.
pub(super) fn record(source: &SourceFile, finding: &Finding) -> Value {
    let diagnostic = &finding.diagnostic;
    let ends = |span: Span| (place(source, span.start), place(source, span.end));
    let (start, end) = ends(diagnostic.span());
    let labels = diagnostic.labels.iter().map(|label| {
        let (start, end) = ends(label.span);
        json!({"message": label.message, "location": start, "end_location": end})
    });
    let fix = diagnostic.fix.as_ref().map(|fix| {
        let edits = fix.edits.iter().map(|edit| {
            let (start, end) = ends(edit.span);
            json!({"content": edit.text, "location": start, "end_location": end})
        });
        json!({
            "message": fix.title,
            "applicability": if fix.safe { "safe" } else { "unsafe" },
            "edits": edits.collect::<Vec<_>>(),
        })
    });
    json!({
        "code": diagnostic.code.id(),
        "severity": severity(finding),
        "message": diagnostic.message,
        "filename": slashes(source.name()),
        "location": start,
        "end_location": end,
        "labels": labels.collect::<Vec<_>>(),
        "help": diagnostic.help,
        "fix": fix,
    })
}

/// How grave a finding counts, in a word.
pub(super) const fn severity(finding: &Finding) -> &'static str {
    match finding.severity {
        scenec_text::Severity::Error => "error",
        scenec_text::Severity::Warning => "warning",
        scenec_text::Severity::Hint => "hint",
    }
}

fn place(source: &SourceFile, offset: u32) -> Value {
    let place = Place::of(source, offset);
    json!({"row": place.line, "column": place.column, "offset": offset})
}
