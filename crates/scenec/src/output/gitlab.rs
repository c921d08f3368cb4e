//! A code quality report: the part of Code Climate's format that GitLab reads.

use std::collections::HashMap;
use std::io::{self, Write};

use scenec_text::Severity;
use serde_json::json;

use super::{Place, Printer, slashes};
use crate::finding::Checked;

/// Remembers how often each fingerprint was given, since they must differ.
#[derive(Default)]
pub(super) struct Gitlab {
    given: HashMap<u64, u32>,
    begun: bool,
}

impl Printer for Gitlab {
    fn begin(&mut self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "[")
    }

    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        let name = slashes(checked.source.name());
        for finding in &checked.findings {
            let diagnostic = &finding.diagnostic;
            let span = diagnostic.span();
            let start = Place::of(&checked.source, span.start);
            let end = Place::of(&checked.source, span.end);
            let record = json!({
                "description": format!("{}: {}", diagnostic.code.id(), diagnostic.message),
                "check_name": diagnostic.code.id(),
                "severity": match finding.severity {
                    Severity::Error => "major",
                    Severity::Warning => "minor",
                    Severity::Hint => "info",
                },
                "fingerprint": self.fingerprint(&name, diagnostic.code.id(), &diagnostic.message),
                "location": {
                    "path": name,
                    "positions": {
                        "begin": {"line": start.line, "column": start.column},
                        "end": {"line": end.line, "column": end.column},
                    },
                },
            });
            let comma = if self.begun { "," } else { "" };
            self.begun = true;
            write!(out, "{comma}\n{record:#}")?;
        }
        Ok(())
    }

    fn end(&mut self, out: &mut dyn Write, _failures: &[String]) -> io::Result<()> {
        writeln!(out, "{}]", if self.begun { "\n" } else { "" })
    }
}

impl Gitlab {
    /// The same for the same finding on every run, wherever in its file the line has moved to.
    fn fingerprint(&mut self, name: &str, code: &str, message: &str) -> String {
        let hash = [name, code, message].into_iter().fold(FNV_BASIS, hash);
        let given = self.given.entry(hash).or_default();
        *given += 1;
        format!("{hash:016x}-{given}")
    }
}

const FNV_BASIS: u64 = 0xcbf2_9ce4_8422_2325;

/// FNV-1a (Fowler, Noll and Vo 1991), each word followed by a byte that is in no word.
fn hash(seed: u64, word: &str) -> u64 {
    word.bytes().chain([0xFF]).fold(seed, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}
