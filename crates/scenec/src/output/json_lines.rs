//! A JSON object a line, so that a reader need not wait for the last finding.

use std::io::{self, Write};

use super::Printer;
use super::json::record;
use crate::finding::Checked;

pub(super) struct JsonLines;

impl Printer for JsonLines {
    fn file(&mut self, out: &mut dyn Write, checked: &Checked) -> io::Result<()> {
        for finding in &checked.findings {
            writeln!(out, "{}", record(&checked.source, finding))?;
        }
        Ok(())
    }
}
