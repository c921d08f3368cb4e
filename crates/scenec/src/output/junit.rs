//! JUnit's XML: a suite for each file, a failed case for each finding.

use std::io::{self, Write};

use scenec_text::Severity;

use super::{Place, Printer, slashes};
use crate::finding::Checked;

pub(super) struct Junit;

impl Printer for Junit {
    fn begin(&mut self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(
            out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"scenec\">"
        )
    }

    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        let name = escape(&slashes(checked.source.name()));
        let findings = checked.findings.len();
        writeln!(
            out,
            "  <testsuite name=\"{name}\" tests=\"{}\" failures=\"{findings}\" errors=\"0\">",
            findings.max(1)
        )?;
        if findings == 0 {
            writeln!(out, "    <testcase name=\"no problems\" classname=\"{name}\"/>")?;
        }
        for finding in &checked.findings {
            let diagnostic = &finding.diagnostic;
            let place = Place::of(&checked.source, diagnostic.span().start);
            let (line, column) = (place.line, place.column);
            let code = diagnostic.code.id();
            let message = escape(&diagnostic.message);
            let kind = match finding.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Hint => "hint",
            };
            let help = diagnostic.help.as_ref().map(|help| format!("\nhelp: {}", escape(help)));
            writeln!(
                out,
                "    <testcase name=\"{code} at {line}:{column}\" classname=\"{name}\" file=\"{name}\" line=\"{line}\">\n      \
                 <failure type=\"{kind}\" message=\"{message}\">{name}:{line}:{column}: {message}{}</failure>\n    </testcase>",
                help.unwrap_or_default()
            )?;
        }
        writeln!(out, "  </testsuite>")
    }

    fn end(&mut self, out: &mut dyn Write, _failures: &[String]) -> io::Result<()> {
        writeln!(out, "</testsuites>")
    }
}

/// Words as XML 1.0 may hold them, in an attribute or outside: what it has no way to write becomes U+FFFD.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            '\n' => escaped.push_str("&#10;"),
            '\r' => escaped.push_str("&#13;"),
            '\t' => escaped.push_str("&#9;"),
            '\0'..='\u{1F}' | '\u{FFFE}' | '\u{FFFF}' => escaped.push('\u{FFFD}'),
            _ => escaped.push(character),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::escape;

    fn check(text: &str, expect: &str) {
        assert_eq!(escape(text), expect);
    }

    #[test]
    fn nothing_ends_an_attribute_or_is_no_xml() {
        check("`a` é", "`a` é");
        check("<a b=\"c\" & 'd'>", "&lt;a b=&quot;c&quot; &amp; &apos;d&apos;&gt;");
        check("\0\u{1b}\n\t\u{FFFE}", "\u{FFFD}\u{FFFD}&#10;&#9;\u{FFFD}");
    }
}
