//! One line a finding: `file:line:column: severity[code]: message`, as compilers have it and editors understand. A `[*]` before
//! the message says that `--fix` would mend it.

use std::io::{self, Write};

use super::{Look, Place, Printer};
use crate::finding::Checked;
use crate::fix::applies;
use crate::report::{choose, not_shown, sanitise};
use scenec_text::Severity;

pub(super) struct Concise(pub(super) Look);

impl Printer for Concise {
    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        let name = sanitise(checked.source.name());
        let (chosen, hidden) = choose(&checked.findings, self.0.most);
        for finding in chosen {
            let diagnostic = &finding.diagnostic;
            let place = Place::of(&checked.source, diagnostic.span().start);
            let (severity, colour) = match finding.severity {
                Severity::Error => ("error", "31"),
                Severity::Warning => ("warning", "33"),
                Severity::Hint => ("hint", "36"),
            };
            let kind = format!("{severity}[{}]", diagnostic.code.id());
            let kind = if self.0.colour {
                format!("\u{1b}[{colour}m{kind}\u{1b}[0m")
            } else {
                kind
            };
            let mark = if applies(finding, self.0.unsafe_fixes) {
                "[*] "
            } else {
                ""
            };
            let message = sanitise(&diagnostic.message);
            writeln!(out, "{name}:{}:{}: {kind}: {mark}{message}", place.line, place.column)?;
        }
        not_shown(out, hidden)
    }
}
