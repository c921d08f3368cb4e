//! How often each code was found, instead of the findings.

use std::collections::BTreeMap;
use std::io::{self, Write};

use scenec_text::Code;
use serde_json::json;

use crate::finding::Checked;

/// Counts of findings.
#[derive(Default)]
pub(crate) struct Statistics {
    /// By code: how many, and how many of them have a repair.
    counts: BTreeMap<Code, (usize, usize)>,
}

impl Statistics {
    pub(crate) fn file(&mut self, checked: &Checked) {
        for finding in &checked.findings {
            let (all, mendable) = self.counts.entry(finding.diagnostic.code).or_default();
            *all += 1;
            *mendable += usize::from(finding.diagnostic.fix.is_some());
        }
    }

    /// The most frequent first; a `*` marks the codes some of whose findings have a repair.
    ///
    /// # Errors
    /// Those of `out`.
    pub(crate) fn print(&self, out: &mut dyn Write) -> io::Result<()> {
        let rows = self.rows();
        let width = rows.first().map_or(0, |(_, all, _)| all.to_string().len());
        for (code, all, mendable) in rows {
            let mark = if mendable > 0 { '*' } else { ' ' };
            writeln!(out, "{all:width$}  {} [{mark}]  {}", code.id(), code.summary())?;
        }
        Ok(())
    }

    /// The same as a JSON array.
    ///
    /// # Errors
    /// Those of `out`.
    pub(crate) fn print_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let record = |(code, all, mendable): (Code, usize, usize)| json!({"code": code.id(), "summary": code.summary(), "count": all, "fixable": mendable});
        let rows: Vec<_> = self.rows().into_iter().map(record).collect();
        writeln!(out, "{:#}", json!(rows))
    }

    fn rows(&self) -> Vec<(Code, usize, usize)> {
        let mut rows: Vec<_> = self
            .counts
            .iter()
            .map(|(code, (all, mendable))| (*code, *all, *mendable))
            .collect();
        // The sort is stable: codes that are as frequent stay in the order of the table.
        rows.sort_by_key(|(_, all, _)| std::cmp::Reverse(*all));
        rows
    }
}
