//! `scenec fmt`

use std::io::{self, Write};
use std::ops::ControlFlow;

use clap::Args;
use scenec_picture::Watch;
use scenec_syntax::{format, parse};
use scenec_text::{Diagnostic, Severity, SourceFile};

use crate::commands::check::write_diff;
use crate::config::ConfigOptions;
use crate::exit::Exit;
use crate::files::FileOptions;
use crate::interrupt;
use crate::jobs::{Failures, Job, jobs, remark};
use crate::parallel::in_order;
use crate::report::{self, plural, sanitise};
use crate::rewrite::rewrite;

/// Write scene files in the one canonical style
///
/// Numbers, names and comments stay as they are written, and so does the end of each line, LF or CRLF. A file with a line
/// that fits no statement is reported and left untouched. Of `-` the formatted text goes to standard output.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Fmt {
    #[command(flatten)]
    files: FileOptions,
    #[command(flatten)]
    config: ConfigOptions,
    /// Change nothing; name the files that would change
    #[arg(long)]
    check: bool,
    /// Change nothing; show what would
    #[arg(long)]
    diff: bool,
    #[command(flatten)]
    voice: report::Voice,
}

const AFTER_HELP: &str = "\
Examples:
  scenec fmt
  scenec fmt scenes --check
  generate | scenec fmt - > tidy.scene

A scenec.toml in the file's folder or one above it may ask for values one below the other:
  [fmt]
  align = true

Exit codes:
  0    every file is in style, or is now
  1    a file has errors and was left untouched; with --check or --diff, something would change
  2    bad arguments or configuration, or a file that can't be read or written; the others are formatted
  130  Ctrl-C";

/// A file and what became of it.
struct Formatted {
    source: SourceFile,
    /// The text in the canonical style, or why there is none.
    text: Result<String, Vec<Diagnostic>>,
}

/// What has been counted so far.
#[derive(Default)]
struct Counts {
    changed: usize,
    same: usize,
    refused: usize,
}

impl Fmt {
    pub(crate) fn run(&self) -> Exit {
        let (jobs, mut failures) = jobs(&self.files, &self.config);
        let mut counts = Counts::default();
        let mut written = Ok(());
        // A file is whole at all times, but Ctrl-C must not leave the half of a new one beside it.
        let watch = (!self.only_asks() && !self.files.standard()).then(interrupt::watch);
        let stopped = || watch.is_some_and(Watch::stopped);
        in_order(&jobs, formatted, |job, formatted| {
            match formatted {
                Ok(formatted) => written = self.file(job, &formatted, &mut counts, &mut failures),
                Err(message) => failures.tell(message),
            }
            if written.is_ok() && !stopped() {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        if stopped() {
            return Exit::Interrupted;
        }
        if let Err(error) = written.and_then(|()| io::stdout().flush()) {
            failures.tell_unwritten(&error);
        }
        if !self.voice.quiet && !self.files.standard() {
            self.summary(&counts);
        }
        let wrong = counts.refused > 0 || (self.only_asks() && counts.changed > 0);
        failures.exit(if wrong { Exit::Errors } else { Exit::Clean })
    }

    fn only_asks(&self) -> bool {
        self.check || self.diff
    }

    fn file(&self, job: &Job, formatted: &Formatted, counts: &mut Counts, failures: &mut Failures) -> io::Result<()> {
        let source = &formatted.source;
        let text = match &formatted.text {
            Ok(text) => text,
            Err(findings) => {
                counts.refused += 1;
                self.refuse(source, findings);
                return Ok(());
            }
        };
        let same = text == source.text();
        let count = if same { &mut counts.same } else { &mut counts.changed };
        *count += 1;
        if self.only_asks() {
            return if same { Ok(()) } else { self.tell(source, text) };
        }
        if job.input.is_standard() {
            return io::stdout().write_all(text.as_bytes());
        }
        if !same && let Err(message) = rewrite(&job.input.path, text) {
            failures.tell(message);
            counts.changed -= 1;
        }
        Ok(())
    }

    /// Shows why a file can't be formatted.
    fn refuse(&self, source: &SourceFile, findings: &[Diagnostic]) {
        let mut drawn = Vec::new();
        // Writing into memory can't fail, and where standard error is gone the exit code still tells.
        report::print(&mut drawn, source, findings, &self.voice.style).unwrap_or_default();
        io::stderr().lock().write_all(&drawn).unwrap_or_default();
        let untouched = if self.only_asks() {
            ""
        } else {
            "; it was left untouched"
        };
        remark(&format!("cannot format {}: it has errors{untouched}", source.name()));
    }

    /// Says what would change in a file.
    fn tell(&self, source: &SourceFile, text: &str) -> io::Result<()> {
        let out = &mut io::stdout().lock();
        if self.diff {
            return write_diff(out, source.name(), source.text(), text);
        }
        writeln!(out, "would format {}", sanitise(source.name()))
    }

    fn summary(&self, counts: &Counts) {
        let would = if self.only_asks() { "would be " } else { "" };
        let words = [
            (counts.changed, format!("{would}formatted")),
            (counts.same, "in style already".to_owned()),
            (counts.refused, "with errors".to_owned()),
        ];
        let words: Vec<_> = words
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{} {what}", plural(*count, "file")))
            .collect();
        if !words.is_empty() {
            remark(&words.join(", "));
        }
    }
}

/// The text of a file in the canonical style.
fn formatted(job: &Job) -> Result<Formatted, String> {
    let config = job.config.as_ref().map_err(ToString::to_string)?;
    let (source, reading) = job.input.read()?;
    let (lines, parsing) = parse(&source);
    let text = format(&source, &lines, config.format).map_err(|_| {
        let mut findings: Vec<_> = reading.into_iter().chain(parsing).collect();
        findings.retain(|finding| finding.severity() == Severity::Error);
        findings.sort_by_key(|finding| finding.span().start);
        findings
    });
    Ok(Formatted { source, text })
}
