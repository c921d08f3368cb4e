//! Going over all files once.

use std::io::{self, BufWriter, IsTerminal, Write};
use std::ops::ControlFlow;

use super::Check;
use scenec_picture::Watch;

use crate::diff::unified;
use crate::exit::Exit;
use crate::finding::{Checked, find};
use crate::fix::{applies, mend};
use crate::interrupt;
use crate::jobs::{Failures, Job, jobs};
use crate::output::{Look, OutputFormat, Printer, Statistics};
use crate::parallel::in_order;
use crate::report::{Tally, plural, sanitise};
use crate::rewrite::rewrite;

/// What has been said and counted so far.
pub(super) struct Round<'a> {
    check: &'a Check,
    out: Box<dyn Write>,
    printer: Box<dyn Printer>,
    statistics: Statistics,
    tally: Tally,
    /// Files that were checked, and repairs that were applied.
    files: usize,
    fixed: usize,
    /// What the last file is called.
    last: String,
    /// Repairs that could be applied: safe ones and others.
    fixable: [usize; 2],
    /// Whether `--diff` found something to change.
    differs: bool,
    failures: Failures,
}

/// How a file fared.
struct Fared {
    checked: Checked,
    /// What was in the file, where repairs have changed it.
    before: Option<String>,
    fixed: usize,
}

impl<'a> Round<'a> {
    pub(super) fn new(check: &'a Check) -> Self {
        let style = &check.talk.voice.style;
        // Text that was mended goes where it is expected, and then the findings must not be in between.
        let aside = check.fixing.fix && !check.fixing.diff && check.files.standard();
        let (out, colour): (Box<dyn Write>, _) = if aside {
            (
                Box::new(BufWriter::new(io::stderr())),
                style.colour.decide(&io::stderr()),
            )
        } else {
            // Standard output would be flushed after every line.
            (
                Box::new(BufWriter::new(io::stdout())),
                style.colour.decide(&io::stdout()),
            )
        };
        let most = style.max_diagnostics;
        Self {
            check,
            out,
            printer: check.talk.output_format.printer(Look {
                colour,
                unsafe_fixes: check.fixing.unsafe_fixes,
                most,
            }),
            statistics: Statistics::default(),
            tally: Tally::default(),
            files: 0,
            fixed: 0,
            last: String::new(),
            fixable: [0; 2],
            differs: false,
            failures: Failures::default(),
        }
    }

    /// How it went, and whether somebody still reads what is written.
    pub(super) fn run(mut self) -> (Exit, bool) {
        let (jobs, failures) = jobs(&self.check.files, &self.check.config);
        self.failures = failures;
        let mut written = if self.shows_findings() {
            self.printer.begin(&mut self.out)
        } else {
            Ok(())
        };
        // Ctrl-C must not leave the half of a new file beside the old one.
        let writes = self.check.fixing.fix && !self.check.fixing.diff && !self.check.files.standard();
        let watch = writes.then(interrupt::watch);
        let stopped = || watch.is_some_and(Watch::stopped);
        if written.is_ok() {
            let check = self.check;
            in_order(
                &jobs,
                |job| fare(check, job),
                |job, fared| {
                    match fared {
                        Ok(fared) => written = self.file(job, &fared),
                        Err(message) => self.failures.tell(message),
                    }
                    if written.is_ok() && !stopped() {
                        ControlFlow::Continue(())
                    } else {
                        ControlFlow::Break(())
                    }
                },
            );
        }
        let written = written.and_then(|()| self.end()).and_then(|()| self.out.flush());
        if let Err(error) = &written {
            self.failures.tell_unwritten(error);
        }
        if stopped() {
            return (Exit::Interrupted, false);
        }
        let wrong = if self.check.fixing.diff {
            self.differs
        } else {
            self.tally.errors > 0
        };
        let exit = if wrong { Exit::Errors } else { Exit::Clean };
        (self.failures.exit(exit), written.is_ok())
    }

    fn shows_findings(&self) -> bool {
        !self.check.fixing.diff && !self.check.talk.statistics
    }

    fn file(&mut self, job: &Job, fared: &Fared) -> io::Result<()> {
        let checked = &fared.checked;
        if self.check.fixing.diff {
            return self.diff(fared);
        }
        if self.check.fixing.fix && !self.store(job, fared)? {
            return Ok(());
        }
        self.files += 1;
        self.last = sanitise(checked.source.name());
        self.fixed += fared.fixed;
        self.tally = self.tally.and(Tally::of(&checked.findings));
        for finding in &checked.findings {
            let [safe, other] = &mut self.fixable;
            *safe += usize::from(applies(finding, false));
            *other += usize::from(applies(finding, true) && !applies(finding, false));
        }
        if self.check.talk.statistics {
            self.statistics.file(checked);
        } else {
            self.printer.file(&mut self.out, checked)?;
        }
        Ok(())
    }

    fn diff(&mut self, fared: &Fared) -> io::Result<()> {
        let Some(before) = &fared.before else {
            return Ok(());
        };
        self.differs = true;
        let source = &fared.checked.source;
        write_diff(&mut self.out, source.name(), before, source.text())
    }

    /// Writes a mended text to where it belongs; whether it is there now.
    fn store(&mut self, job: &Job, fared: &Fared) -> io::Result<bool> {
        let checked = &fared.checked;
        let text = checked.source.text();
        if job.input.is_standard() {
            // Of a text with holes the rest is not what somebody waits for.
            if checked.source.holes().is_empty() {
                let mut out = io::stdout().lock();
                out.write_all(text.as_bytes())?;
                out.flush()?;
            }
        } else if fared.before.is_some()
            && let Err(message) = rewrite(&job.input.path, text)
        {
            self.failures.tell(message);
            return Ok(false);
        }
        Ok(true)
    }

    /// Whether people read this, and want to be told how it went.
    fn is_talkative(&self) -> bool {
        self.check.talk.output_format.is_prose() && !self.check.talk.voice.quiet
    }

    fn end(&mut self) -> io::Result<()> {
        let out = &mut *self.out;
        if self.check.fixing.diff {
            return Ok(());
        }
        match (self.check.talk.statistics, self.check.talk.output_format) {
            (false, _) => self.printer.end(out, &self.failures.messages)?,
            (true, OutputFormat::Json | OutputFormat::JsonLines) => self.statistics.print_json(out)?,
            (true, _) => self.statistics.print(out)?,
        }
        if !self.is_talkative() || self.files == 0 {
            return Ok(());
        }
        self.summary()
    }

    fn summary(&mut self) -> io::Result<()> {
        let place = if self.check.files.is_one_file() {
            self.last.clone()
        } else {
            plural(self.files, "file")
        };
        match self.tally.words() {
            Some(counts) => writeln!(self.out, "{counts} in {place}")?,
            None => writeln!(self.out, "{place}: no problems")?,
        }
        if self.fixed > 0 {
            writeln!(self.out, "{} fixed", self.fixed)?;
        }
        match self.mendable() {
            Some(words) => writeln!(self.out, "{words}"),
            None => Ok(()),
        }
    }

    /// What `--fix` would do about the findings; after it has done its work, what it left.
    fn mendable(&self) -> Option<String> {
        let [safe, other] = self.fixable;
        let fixing = &self.check.fixing;
        // Where findings are marked, this says what the mark means.
        let mark = match self.check.talk.output_format {
            OutputFormat::Concise if !self.check.talk.statistics => "[*] ",
            _ => "",
        };
        match (safe, other) {
            (0, 0) => None,
            _ if fixing.fix && fixing.unsafe_fixes => None,
            (_, 0) if fixing.fix => None,
            (_, other) if fixing.fix => Some(format!("{other} more can be fixed with --unsafe-fixes")),
            (safe, other) if fixing.unsafe_fixes => {
                Some(format!("{mark}{} can be fixed with --fix --unsafe-fixes", safe + other))
            }
            (0, other) => Some(format!("{other} can be fixed with --fix --unsafe-fixes")),
            (safe, 0) => Some(format!("{mark}{safe} can be fixed with --fix")),
            (safe, other) => Some(format!(
                "{mark}{safe} can be fixed with --fix, {other} more with --unsafe-fixes"
            )),
        }
    }
}

/// Checks a file, and mends its text where that is asked for; nothing is written yet.
fn fare(check: &Check, job: &Job) -> Result<Fared, String> {
    let config = job.config.as_ref().map_err(ToString::to_string)?;
    let mut levels = config.levels.clone();
    check.levels.apply(&mut levels);
    let (source, reading) = job.input.read()?;
    let findings = find(&source, &reading, &levels);
    let (fix, unsafe_too) = (check.fixing.fix || check.fixing.diff, check.fixing.unsafe_fixes);
    // A text with holes is not what is in the file.
    if !fix || !reading.is_empty() || !findings.iter().any(|finding| applies(finding, unsafe_too)) {
        let checked = Checked { source, findings };
        return Ok(Fared {
            checked,
            before: None,
            fixed: 0,
        });
    }
    let before = source.text().to_owned();
    let mended = mend(source, findings, &levels, unsafe_too);
    Ok(Fared {
        before: (mended.source.text() != before).then_some(before),
        fixed: mended.count,
        checked: Checked {
            source: mended.source,
            findings: mended.findings,
        },
    })
}

/// Writes what would change in a file; harmless where a terminal shows it, exact where `patch` reads it.
///
/// # Errors
/// Those of `out`.
pub(crate) fn write_diff(out: &mut dyn Write, name: &str, before: &str, after: &str) -> io::Result<()> {
    let diff = unified(name, before, after);
    if io::stdout().is_terminal() {
        out.write_all(sanitise(&diff).as_bytes())
    } else {
        out.write_all(diff.as_bytes())
    }
}
