//! Annotations: the commands that GitHub's workflows look for in what a step prints.

use std::io::{self, Write};

use scenec_text::Severity;

use super::{Place, Printer, slashes};
use crate::finding::Checked;

pub(super) struct Github;

impl Printer for Github {
    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        let name = slashes(checked.source.name());
        for finding in &checked.findings {
            let diagnostic = &finding.diagnostic;
            let command = match finding.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Hint => "notice",
            };
            let span = diagnostic.span();
            let start = Place::of(&checked.source, span.start);
            let end = Place::of(&checked.source, span.end);
            write!(
                out,
                "::{command} title={},file={},line={}",
                property(&format!("scenec {}", diagnostic.code.id())),
                property(&name),
                start.line
            )?;
            // Columns of a place on several lines are refused.
            if start.line == end.line {
                write!(
                    out,
                    ",endLine={},col={},endColumn={}",
                    end.line, start.column, end.column
                )?;
            } else {
                write!(out, ",endLine={}", end.line)?;
            }
            // The log of the step shows the message alone, so the place is in it as well.
            let help = diagnostic.help.as_ref().map(|help| format!("\nhelp: {help}"));
            let message = format!(
                "{name}:{}:{}: {}{}",
                start.line,
                start.column,
                diagnostic.message,
                help.unwrap_or_default()
            );
            writeln!(out, "::{}", data(&message))?;
        }
        Ok(())
    }
}

/// Words after the second pair of colons.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::{data, property};

    fn check(text: &str, as_data: &str, as_property: &str) {
        assert_eq!((data(text).as_str(), property(text).as_str()), (as_data, as_property));
    }

    #[test]
    fn what_would_end_a_command_is_escaped() {
        check("a.scene", "a.scene", "a.scene");
        check("100%,\r\n::x", "100%25,%0D%0A::x", "100%25%2C%0D%0A%3A%3Ax");
        check("%0A", "%250A", "%250A");
    }
}
