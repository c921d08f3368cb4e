//! SARIF 2.1.0, the interchange format for static analysis (OASIS 2020).

use std::io::{self, Write};

use scenec_text::{Code, Fix, Severity, SourceFile, Span};
use serde_json::{Value, json};

use super::{Place, Printer, slashes};
use crate::finding::{Checked, Finding};

const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// Collects the results: the rules that they refer to stand before them.
#[derive(Default)]
pub(super) struct Sarif {
    results: Vec<Value>,
    /// The codes that were found; a result names its place here.
    rules: Vec<Code>,
}

impl Printer for Sarif {
    fn file(&mut self, _out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        for finding in &checked.findings {
            let code = finding.diagnostic.code;
            let known = self.rules.iter().position(|rule| *rule == code);
            let index = known.unwrap_or_else(|| {
                self.rules.push(code);
                self.rules.len() - 1
            });
            self.results.push(result(&checked.source, finding, index));
        }
        Ok(())
    }

    fn end(&mut self, out: &mut dyn Write, failures: &[String]) -> io::Result<()> {
        let notifications = failures
            .iter()
            .map(|failure| json!({"level": "error", "message": {"text": failure}}));
        let log = json!({
            "$schema": SCHEMA,
            "version": "2.1.0",
            "runs": [{
                "tool": {"driver": {
                    "name": "scenec",
                    "semanticVersion": env!("CARGO_PKG_VERSION"),
                    "rules": self.rules.iter().map(|code| rule(*code)).collect::<Vec<_>>(),
                }},
                "invocations": [{
                    "executionSuccessful": failures.is_empty(),
                    "toolExecutionNotifications": notifications.collect::<Vec<_>>(),
                }],
                "columnKind": "unicodeCodePoints",
                "results": std::mem::take(&mut self.results),
            }],
        });
        writeln!(out, "{log:#}")
    }
}

fn rule(code: Code) -> Value {
    let mut rule = json!({
        "id": code.id(),
        "shortDescription": {"text": code.summary()},
        "defaultConfiguration": {"level": level(code.severity())},
    });
    if let (Some(page), Some(rule)) = (scenec_lint::page(code), rule.as_object_mut()) {
        let text = page.text();
        rule.insert("name".to_owned(), json!(page.name()));
        rule.insert("help".to_owned(), json!({"text": text, "markdown": text}));
    }
    rule
}

const fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Hint => "note",
    }
}

fn result(source: &SourceFile, finding: &Finding, rule: usize) -> Value {
    let diagnostic = &finding.diagnostic;
    let help = diagnostic.help.as_ref().map(|help| format!("\n{help}"));
    let mut labels = diagnostic.labels.iter();
    let first = labels.next().map(|label| location(source, label.span, &label.message));
    let others = labels.enumerate().map(|(index, label)| {
        let mut place = location(source, label.span, &label.message);
        if let Some(place) = place.as_object_mut() {
            place.insert("id".to_owned(), json!(index));
        }
        place
    });
    let mut result = json!({
        "ruleId": diagnostic.code.id(),
        "ruleIndex": rule,
        "level": level(finding.severity),
        "message": {"text": format!("{}{}", diagnostic.message, help.unwrap_or_default())},
        "locations": first.into_iter().collect::<Vec<_>>(),
        "relatedLocations": others.collect::<Vec<_>>(),
    });
    if let (Some(fix), Some(result)) = (&diagnostic.fix, result.as_object_mut()) {
        result.insert("fixes".to_owned(), json!([repair(source, fix)]));
    }
    result
}

fn location(source: &SourceFile, span: Span, message: &str) -> Value {
    let mut location = json!({
        "physicalLocation": {
            "artifactLocation": {"uri": uri(source.name())},
            "region": region(source, span),
        },
    });
    if let (false, Some(location)) = (message.is_empty(), location.as_object_mut()) {
        location.insert("message".to_owned(), json!({"text": message}));
    }
    location
}

fn region(source: &SourceFile, span: Span) -> Value {
    let start = Place::of(source, span.start);
    let end = Place::of(source, span.end);
    json!({
        "startLine": start.line,
        "startColumn": start.column,
        "endLine": end.line,
        "endColumn": end.column,
    })
}

fn repair(source: &SourceFile, fix: &Fix) -> Value {
    let replacements = fix.edits.iter().map(|edit| {
        json!({
            "deletedRegion": region(source, edit.span),
            "insertedContent": {"text": edit.text},
        })
    });
    json!({
        "description": {"text": fix.title},
        "artifactChanges": [{
            "artifactLocation": {"uri": uri(source.name())},
            "replacements": replacements.collect::<Vec<_>>(),
        }],
    })
}

/// A path as a reference (RFC 3986): what has a meaning there, and what is not ASCII, is written in percents.
fn uri(name: &str) -> String {
    let mut uri = String::with_capacity(name.len());
    if std::path::Path::new(name).is_absolute() {
        uri.push_str("file://");
        if !name.starts_with('/') {
            uri.push('/');
        }
    }
    for byte in slashes(name).bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => uri.push(char::from(byte)),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::uri;

    fn check(name: &str, expect: &str) {
        assert_eq!(uri(name), expect);
    }

    #[test]
    fn paths_become_references() {
        check("scenes/a.scene", "scenes/a.scene");
        check("a b:é%.scene", "a%20b%3A%C3%A9%25.scene");
        check("<stdin>", "%3Cstdin%3E");
        #[cfg(unix)]
        check("/tmp/a.scene", "file:///tmp/a.scene");
    }
}
